// SPDX-License-Identifier: Apache-2.0
// Chooses finite carriers for a component that only passes values on. A few values then represent all values. See
// docs/conformance.md, "Few values for all".
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "conformance/model/longer_lists.hpp"
#include "cpp_emit/plan/component.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// A type with few explored values.
struct RepresentedType {
    ir::TypeId type;
    std::string name;        ///< name in the model
    std::size_t values = 0;  ///< number of values that represent all
    /// The representatives that are neither initial values nor values of constants. Each of them can represent any
    /// value of the type.
    std::vector<ir::Value> names;
};

/// An instantiation with fewer values, and the types with fewer values. If `types` is empty, all values are explored.
struct Representatives {
    ir::Instantiation instantiation;
    std::vector<RepresentedType> types;
    /// True if the lists of the instantiation represent lists of any length.
    bool lists_of_any_length = false;
};

/// The least number of names of a represented type.
inline constexpr std::size_t least_names = 2;

/// Chooses representatives for a component whose inputs or outputs have more values than can be explored. For each
/// data-independent type, the representatives are the values of constants, the initial values, and `names` further
/// values (the names). The first two names differ from the other values and from each other in every part. If the
/// carriers allow it, the parts of one value also differ from each other. So the check detects lost or exchanged parts.
/// If a type has too few values for the names, all values of the type are explored. If a type of lists has a bound, its
/// carrier contains all lists of the representatives up to this bound.
[[nodiscard]] Representatives choose_representatives(const ir::System&, const ir::Instantiation&,
                                                     const cpp_emit::Component&, std::size_t names = least_names,
                                                     const ListBounds& bounds = {});

/// Returns whether few values represent the type or one of its parts.
[[nodiscard]] bool is_represented(const ir::System&, const Representatives&, ir::TypeId);

/// A set of names: one bit for each name of Representatives::types, in their order.
using NameSet = std::uint64_t;
/// The number of names that a NameSet can contain.
inline constexpr std::size_t most_bits = 64;

/// Returns, for each represented type, the set of its names. All types together must have at most `most_bits` names.
[[nodiscard]] std::vector<NameSet> names_by_type(const Representatives&);
/// The parts of a value that have represented types.
struct RepresentedParts {
    NameSet names = 0;                ///< the names in these parts
    std::vector<std::size_t> counts;  ///< for each represented type, the number of parts
};
/// Finds the parts of a value. All types together must have at most `most_bits` names.
[[nodiscard]] RepresentedParts represented_parts(const ir::System&, const Representatives&, ir::TypeId,
                                                 const ir::Value&);

}  // namespace robochart::conformance
