// SPDX-License-Identifier: Apache-2.0
// See rules.hpp.
#include "sleec/checks/rules.hpp"

#include <array>

namespace robochart::sleec::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule unknown_name{"SLEEC-T01", Severity::error, "there is no {} '{}'",
                        "Define events, measures and constants between def_start and def_end, before rules use them."};
const Rule wrong_kind{
    "SLEEC-T02", Severity::error, "'{}' is {}, not {}",
    "Rules begin with an event and require events. Conditions are about measures. Limits are numbers or constants."};
const Rule declared_twice{
    "SLEEC-T03", Severity::error, "'{}' is declared twice",
    "Each event, measure and constant needs a different name, and so does each value of one scale."};
const Rule rule_named_twice{"SLEEC-T03", Severity::warning, "two rules have the name '{}'",
                            "Results name rules, so only the line numbers distinguish these two."};
const Rule wrong_type{"SLEEC-T04", Severity::error, "{}",
                      "Numbers are compared with numbers, and a measure on a scale with a value of this scale. 'and', "
                      "'or' and 'not' apply to truth values, and a whole condition is a truth value."};
const Rule literal_by_place{"SLEEC-T05", Severity::warning,
                            "'{}' is not a value of {} ({}); it is read by its position, as '{}'",
                            "LEGOS numbers the values of each scale from the least, and compares numbers. SLEEC-TK "
                            "would reject the comparison."};
const Rule circular_constant{"SLEEC-T06", Severity::error, "the constant '{}' is defined by itself",
                             "A constant is a number or another constant, and this chain must end with a number."};
const Rule empty_interval{"SLEEC-T07", Severity::error, "the interval ends before it begins",
                          "within [A, B] means: no sooner than A and no later than B."};

std::span<const Rule* const> check_rule_table() {
    static constexpr std::array<const Rule*, 8> table{&unknown_name,      &wrong_kind,    &declared_twice,
                                                      &rule_named_twice,  &wrong_type,    &literal_by_place,
                                                      &circular_constant, &empty_interval};
    return table;
}

}  // namespace robochart::sleec::rules
