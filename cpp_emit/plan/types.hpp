// SPDX-License-Identifier: Apache-2.0
// Writes the model's types and values as C++ text.
#pragma once

#include <string>
#include <vector>

#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// How types are written at some place: the name of the policy, the namespace of the core's types, and the names of
/// number types.
struct Spelling {
    std::string types = "Types";
    std::string core;  ///< "core::" outside the core; "" inside
    std::string real = "Real", nat = "Nat", integer = "Int";
};

/// A member of a struct for a record, a product, or an enumeration whose literals have arguments.
struct TypeMember {
    std::string name;
    ir::TypeId type;
    std::size_t literal = 0;  ///< for enumerations: the literal whose argument it is
};

struct Extent {
    std::size_t size = 1;
    std::size_t alignment = 1;
    bool varies = false;  ///< `size` is the size over the instantiation's carriers; it may differ for other parameters
};

/// Returns whether code for values of the type can be generated.
[[nodiscard]] bool is_supported(const ir::System&, ir::TypeId);
[[nodiscard]] bool is_numeric(ir::TypeKind);
/// Returns whether the core declares the type: enumerations, given types, and structs.
[[nodiscard]] bool is_declared(const ir::Type&);
/// Returns whether the type is a record, a product or an enumeration with arguments.
[[nodiscard]] bool is_struct(const ir::Type&);
/// Returns whether the exploration interface numbers the values of the type. This is true unless the type is a number,
/// a boolean, or an enumeration without arguments.
[[nodiscard]] bool is_composed(const ir::Type&);
/// Returns whether the type is a vector or matrix.
[[nodiscard]] bool is_block_type(const ir::Type&);
/// Returns whether the type is a relation or function, whose values are sets of pairs.
[[nodiscard]] bool has_pairs(const ir::Type&);
[[nodiscard]] std::vector<TypeMember> type_members(const ir::Type&);
/// Returns whether the values of the type are stored in places of fixed size: sequences, sets, relations and functions.
[[nodiscard]] bool is_list(const ir::Type&);
/// Returns whether values of the type contain lists that may be longer than their capacity on the robot. These are
/// sequences, and sets, relations and functions with numbers (ir::has_numbers). False for types that are not supported.
[[nodiscard]] bool has_lists(const ir::System&, ir::TypeId);
/// The usual capacity of lists in deployed code, in items. `usual_outer_capacity` is the usual capacity of lists of
/// lists.
inline constexpr std::size_t usual_capacity = 64, usual_outer_capacity = 16;
/// Returns the capacity of a list type in deployed code if it is given (list_capacities.hpp), and otherwise 0.
[[nodiscard]] std::size_t given_capacity(const ir::Type&);
/// Returns the capacity of a list type in deployed code over robochart::Deployment, in items.
[[nodiscard]] std::size_t deployed_capacity(const ir::System&, const ir::Type&);
/// Returns the C++ name of a declared type.
[[nodiscard]] std::string declared_name(const ir::Type&);
/// Returns the C++ name of a type: bool, Nat, Int, Real, the declared type's name, `robochart::Sequence<Nat, ...>`.
[[nodiscard]] std::string cpp_type(const ir::System&, ir::TypeId, const Spelling& = {});
/// Returns `robochart::Pair<...>` for the pairs of a relation or function.
[[nodiscard]] std::string cpp_pair(const ir::System&, const ir::Type&, const Spelling& = {});
/// The maximal number of characters of a string.
inline constexpr std::size_t longest_string = 31;
/// Return the capacity of sets, relations and functions of the type: the number of values of their elements' type. The
/// first function returns it as C++ text. The second computes it over the instantiation's carriers and stops at
/// largest_set + 1 (capacity.cpp).
[[nodiscard]] std::string set_capacity(const ir::System&, const ir::Type&, const Spelling&);
[[nodiscard]] std::size_t set_capacity(const ir::System&, const ir::Instantiation&, const ir::Type&);
/// The largest capacity of a set. Larger sets would lose elements.
inline constexpr std::size_t largest_set = 1024;
/// Returns the size in bytes of a value in State over the instantiation's carriers, and its alignment (8 for numbers, 1
/// for others).
[[nodiscard]] Extent cpp_extent(const ir::System&, const ir::Instantiation&, ir::TypeId);
/// Returns the capacity of a sequence or set over the instantiation's carriers. It is enough for every sequence, and
/// for every set of numbers or elements of a given type.
[[nodiscard]] std::size_t longest(const ir::Instantiation&);
/// Returns a value as C++ text: `Real(-0.75)`, `Nat(25)`, `true`, `Light::Red`, `Point<Types>::make(Nat(1), Nat(2))`.
[[nodiscard]] std::string cpp_value(const ir::System&, const ir::Instantiation&, ir::TypeId, const ir::Value&,
                                    const Spelling& = {});
/// Returns the characters of a value of type string.
[[nodiscard]] diagnostics::ForeignText string_text(const ir::Value&);
/// Returns a decimal as a C++ literal, always with a point.
[[nodiscard]] std::string decimal_text(ir::Decimal);
/// Returns the C++ name of an enumeration's literal.
[[nodiscard]] std::string literal_name(const ir::Type&, std::size_t index);
/// Returns a value as CSPM text: "-70" (scaled), "true", "P_T_Red", "(1, 2)".
[[nodiscard]] std::string cspm_value(const ir::System&, ir::TypeId, const ir::Value&);

}  // namespace robochart::cpp_emit
