// SPDX-License-Identifier: Apache-2.0
// See rules.hpp.
#include "sleec/checks/rules.hpp"

#include <array>

namespace robochart::sleec::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule unknown_name{
    "SLEEC-T01", Severity::error, "there is no {} '{}'",
    "Events, measures and constants are defined between def_start and def_end before rules speak of "
    "them."};
const Rule wrong_kind{
    "SLEEC-T02", Severity::error, "'{}' is {}, not {}",
    "Rules begin with an event and ask for events; conditions are over measures; limits are numbers or "
    "constants."};
const Rule declared_twice{
    "SLEEC-T03", Severity::error, "'{}' is declared twice",
    "Events, measures and constants have names of their own, and so have the values of one scale."};
const Rule rule_named_twice{"SLEEC-T03", Severity::warning, "two rules are called '{}'",
                            "Answers name rules; the line tells the two apart."};
const Rule wrong_type{"SLEEC-T04", Severity::error, "{}",
                      "Numbers are compared with numbers, and a measure on a scale with a value of that scale; 'and', "
                      "'or', 'not' and whole conditions are true or false."};
const Rule literal_by_place{
    "SLEEC-T05", Severity::warning, "'{}' is no value of {} ({}); read by its place, as '{}'",
    "LEGOS numbers the values of each scale from the least, and compares numbers. SLEEC-TK would "
    "refuse the comparison."};
const Rule circular_constant{"SLEEC-T06", Severity::error, "the constant '{}' is defined by itself",
                             "A constant is a number or another constant, which leads to a number in the end."};
const Rule empty_interval{"SLEEC-T07", Severity::error, "the interval ends before it begins",
                          "within [A, B] means: no sooner than A and no later than B."};

std::span<const Rule* const> check_rule_table() {
    static constexpr std::array<const Rule*, 8> table{&unknown_name,      &wrong_kind,    &declared_twice,
                                                      &rule_named_twice,  &wrong_type,    &literal_by_place,
                                                      &circular_constant, &empty_interval};
    return table;
}

}  // namespace robochart::sleec::rules
