// The numbers that values of a type are compared with (private to this component). RoboTool's carriers end at the
// greatest literal. Here they reach one number beyond each that values of the type are compared with, on both sides,
// and reals have one between each two neighbours, so that each comparison has either answer; not where an option or a
// block Instantiations gives the carrier.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "semantics/ir/literals.hpp"

namespace robochart::ir {

/// Numbers that a carrier needs so that each comparison has either answer, whatever the number is compared with.
struct Compared {
    std::set<std::int64_t> nat, integer;  ///< the numbers beside those that values are compared with
    std::set<std::int64_t> real;          ///< whole numbers beyond them
    std::vector<Decimal> between;         ///< one between each two neighbours that reals are compared with by order
};

/// From comparisons of guards, conditions and contracts. Constants count with each value that the model, an option, an
/// assertion or a csp block gives to one of the name; `chosen` are the values that options give, by the names in
/// scripts; `longest` is the length of the longest sequences.
[[nodiscard]] Compared compared(const System&, const std::map<std::string, ExprPtr>& chosen, const Literals&,
                                std::int64_t longest);

/// Whether a block Instantiations defines a carrier of numbers: what the types hold is the user's choice then.
[[nodiscard]] bool carriers_given(const System&);

}  // namespace robochart::ir
