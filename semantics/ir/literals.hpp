// SPDX-License-Identifier: Apache-2.0
// Collects the numbers that occur in a model, by type. These numbers widen the carriers and determine the scale
// (semantics 3.13).
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// The literals of a model by type. A literal that is only used as a wait duration, as a deadline or in a comparison
/// with since() is a number of time units and not a value of a variable. Such a literal influences only the scale.
/// Numbers that only select an element or a field are not included.
struct Literals {
    std::set<std::int64_t> nat, integer;
    std::vector<Decimal> real;                         ///< values
    std::vector<Decimal> real_time;                    ///< durations
    std::set<diagnostics::ForeignText> strings;        ///< texts
    std::map<std::int64_t, diagnostics::Span> places;  ///< the first place of a whole number
    std::set<std::string> durations;                   ///< see constants_of_durations()
    bool windows = false;                              ///< windows are included: the numbers of W in `extract(W, s)`
};

/// Returns the literals of a model. If `windows` is true, the result includes the numbers of windows. These numbers are
/// positions in a sequence and not values, but RoboTool's carriers contain them.
[[nodiscard]] Literals literals_of(const System&, bool windows = false);
/// Returns the names of constants that the model uses at least once, and only as a whole duration or in a comparison
/// with since(). The values of these constants are numbers of time units. All constants with the same name are treated
/// as one constant, because a required constant gets its value from another constant with this name.
[[nodiscard]] std::set<std::string> constants_of_durations(const System&);
/// Returns the names of constants that some wait, deadline or comparison with a clock reads. Other expressions may also
/// read these constants as values.
[[nodiscard]] std::set<std::string> constants_read_as_times(const System&);
/// Adds the literals of one expression. `time` is true if the whole expression is a duration.
void add_literals(const System&, const Expr&, bool time, Literals&);

}  // namespace robochart::ir
