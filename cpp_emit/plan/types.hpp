// The model's types and values as C++ text.
#pragma once

#include <string>
#include <vector>

#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// How types are spelled in a place: the name of the policy, where the core's types are, what numbers are called.
struct Spelling {
    std::string types = "Types";
    std::string core;  ///< "core::" outside the core
    std::string real = "Real", nat = "Nat", integer = "Int";
};

/// A member of a struct that stands for a record, a product, or an enumeration whose literals have arguments.
struct TypeMember {
    std::string name;
    ir::TypeId type;
    std::size_t literal = 0;  ///< enumeration: whose argument it is
};

struct Extent {
    std::size_t size = 1;
    std::size_t alignment = 1;
};

/// Whether values of the type can be generated.
[[nodiscard]] bool supported(const ir::System&, ir::TypeId);
[[nodiscard]] bool numeric(ir::TypeKind);
/// The type has a declaration of its own in the core: enumerations, given types, and what is a struct.
[[nodiscard]] bool declared(const ir::Type&);
/// Records, products and enumerations with arguments.
[[nodiscard]] bool is_struct(const ir::Type&);
/// Neither a number, a boolean, nor an enumeration without arguments: the exploration interface numbers its values.
[[nodiscard]] bool composed(const ir::Type&);
/// Vectors and matrices.
[[nodiscard]] bool block(const ir::Type&);
/// Relations and functions as values: sets of pairs.
[[nodiscard]] bool of_pairs(const ir::Type&);
[[nodiscard]] std::vector<TypeMember> members(const ir::Type&);
/// The C++ name of a declared type.
[[nodiscard]] std::string declared_name(const ir::Type&);
/// bool, Nat, Int, Real, the declared type's name, `robochart::Sequence<Nat, ...>`.
[[nodiscard]] std::string cpp_type(const ir::System&, ir::TypeId, const Spelling& = {});
/// `robochart::Pair<...>` of a relation or function.
[[nodiscard]] std::string cpp_pair(const ir::System&, const ir::Type&, const Spelling& = {});
/// Characters of a string.
inline constexpr std::size_t longest_string = 31;
/// How many members sets, relations and functions of the type can have: all values of their members' type, as C++ text
/// and over the instantiation's carriers, where it is counted up to largest_set + 1 (capacity.cpp).
[[nodiscard]] std::string capacity(const ir::System&, const ir::Type&, const Spelling&);
[[nodiscard]] std::size_t capacity(const ir::System&, const ir::Instantiation&, const ir::Type&);
/// Beyond this members of sets would be lost.
inline constexpr std::size_t largest_set = 1024;
/// Bytes of a value in State over the instantiation's carriers, and its alignment: numbers 8, others 1.
[[nodiscard]] Extent cpp_extent(const ir::System&, const ir::Instantiation&, ir::TypeId);
/// Places of a sequence or set over the instantiation's carriers: enough for every sequence, and every set of numbers
/// or elements of a given type.
[[nodiscard]] std::size_t longest(const ir::Instantiation&);
/// A value as C++ text: `Real(-0.75)`, `Nat(25)`, `true`, `Light::Red`, `Point<Types>::make(Nat(1), Nat(2))`.
[[nodiscard]] std::string cpp_value(const ir::System&, const ir::Instantiation&, ir::TypeId, const ir::Value&,
                                    const Spelling& = {});
/// The characters of a value of type string.
[[nodiscard]] diagnostics::ForeignText string_text(const ir::Value&);
/// A decimal as it is written in C++: always with a point.
[[nodiscard]] std::string decimal_text(ir::Decimal);
/// The C++ name of an enumeration's literal.
[[nodiscard]] std::string literal_name(const ir::Type&, std::size_t index);
/// A value as CSPM text: "-70" (scaled), "true", "P_T_Red", "(1, 2)".
[[nodiscard]] std::string cspm_value(const ir::System&, ir::TypeId, const ir::Value&);

}  // namespace robochart::cpp_emit
