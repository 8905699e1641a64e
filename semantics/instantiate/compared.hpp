// SPDX-License-Identifier: Apache-2.0
// Collects the numbers with which values of a type are compared. Private to this component. RoboTool's carriers end at
// the greatest literal. In this project a carrier also contains one number below and one above each number with which
// values of the type are compared. If a counter is compared, it also contains the number that the counter reaches one
// step later. Carriers of reals contain one number between each two neighbours. If values of a type are converted to
// another type, the carrier of the first type also contains the numbers with which values of the other type are
// compared. So every comparison is true for some values and false for others. This does not apply if an option or a
// block Instantiations gives the carrier.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "semantics/ir/literals.hpp"

namespace robochart::ir {

/// The numbers that a carrier needs so that every comparison is true for some values and false for others.
struct Compared {
    std::set<std::int64_t> nat, integer;  ///< the neighbours of the numbers with which values are compared
    std::set<std::int64_t> real;          ///< the whole numbers around the numbers with which reals are compared
    std::vector<Decimal> between;         ///< one number between each two neighbouring bounds of reals (<, <=, >, >=)
};

/// Collects the numbers from comparisons in guards, conditions and contracts. A constant in a comparison represents
/// every value that the model, an option, an assertion or a CSP block gives to any constant with this name. `chosen`
/// contains the values of options, by the names in scripts. `longest` is the length of the longest sequences.
[[nodiscard]] Compared compared_values(const System&, const std::map<std::string, ExprPtr>& chosen, const Literals&,
                                       std::int64_t longest);

/// True if a block Instantiations defines a carrier of numbers. The user has then chosen the values of the types.
[[nodiscard]] bool carriers_given(const System&);

}  // namespace robochart::ir
