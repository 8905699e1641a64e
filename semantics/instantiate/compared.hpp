// SPDX-License-Identifier: Apache-2.0
// The numbers that values of a type are compared with (private to this component). RoboTool's carriers end at the
// greatest literal. Here a carrier also contains, on both sides, one number beyond each number that values of the type
// are compared with. Carriers of reals contain one number between each two neighbours. So every comparison is true for
// some values and false for others. This does not apply if an option or a block Instantiations gives the carrier.
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
    std::set<std::int64_t> nat, integer;  ///< the neighbours of the numbers that values are compared with
    std::set<std::int64_t> real;          ///< the whole numbers around them
    std::vector<Decimal> between;  ///< one number between each two neighbours that reals are compared with by order
};

/// Collects the numbers from comparisons in guards, conditions and contracts. A constant counts with each value that
/// the model, an option, an assertion or a csp block gives to a constant of its name. `chosen`: the values given by
/// options, by the names in scripts. `longest`: the length of the longest sequences.
[[nodiscard]] Compared compared_values(const System&, const std::map<std::string, ExprPtr>& chosen, const Literals&,
                                       std::int64_t longest);

/// True if a block Instantiations defines a carrier of numbers; the values of the types are then the user's choice.
[[nodiscard]] bool carriers_given(const System&);

}  // namespace robochart::ir
