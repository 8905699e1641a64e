// SPDX-License-Identifier: Apache-2.0
#include "prism/explore/rules.hpp"

#include <array>

namespace robochart::prism::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule constant_open{"PRISM-E01", Severity::error, "the constant '{}' has no value",
                         "The model or the properties file leaves the constant open: give it a value with --const "
                         "NAME=VALUE, or values with --const NAME=LOW:HIGH or NAME=LOW:STEP:HIGH."};
const Rule arithmetic{
    "PRISM-E02", Severity::error, "{}",
    "Integers have 32 bits, and a result beyond them is an error, as are a remainder by zero or less, "
    "a negative exponent of integers, 0/0, Infinity - Infinity and the logarithm of a negative number. "
    "1/0 is Infinity. Only what is used has to have a value."};
const Rule out_of_range{"PRISM-E03", Severity::error, "'{}' would be {}, outside its range {}",
                        "An update, or an initial value, leaves the declared range of the variable. Guard the command, "
                        "or widen the range."};
const Rule bad_probability{"PRISM-E04", Severity::error, "{} is no probability",
                           "A probability lies between 0 and 1. One that depends on constants or variables may leave "
                           "these bounds in some state."};
const Rule wrong_sum{"PRISM-E05", Severity::error, "the probabilities sum to {}, not to 1",
                     "The probabilities of the updates of a command sum to 1. A difference of up to 0.00001 is taken "
                     "for rounding in the text, reported, and divided out."};
const Rule empty_range{"PRISM-E06", Severity::error, "the range of '{}' is empty: {}..{}",
                       "The lower bound of a range is at most the upper one, and both fit 32 bits."};
const Rule no_initial_state{"PRISM-E07", Severity::error, "{}",
                            "The expression of init ... endinit holds in at least one state; the variables then have "
                            "ranges, so that the states can be listed."};
const Rule deadlocks{"PRISM-E08", Severity::warning, "no command is enabled in {}; a self loop was added",
                     "A state without enabled command gets a loop to itself, so that every path is infinite. The label "
                     "\"deadlock\" still marks it: E [ F \"deadlock\" ] asks whether there is one."};
const Rule negative_reward{"PRISM-E09", Severity::error, "the reward {} is negative",
                           "Expected rewards are computed for rewards of zero and more."};
const Rule bad_steps{"PRISM-E10", Severity::error, "{}",
                     "A bound on steps is a number from zero on, and the lower bound is at most the upper one. F<k "
                     "means F<=k-1, F>k means F>=k+1."};
const Rule too_close{"PRISM-E11", Severity::error, "{}",
                     "Decimal numbers are exact, and compared exactly. Logarithms and roots are known up to rounding "
                     "only; a comparison that hangs on it is refused, not guessed."};
const Rule normalised{"PRISM-E12", Severity::warning, "the probabilities sum to {}; they were divided by that",
                      "The probabilities of a command sum almost to 1, as if they were rounded in the text. Exact "
                      "fractions such as 1/3 avoid that."};
const Rule not_exact{
    "PRISM-E13", Severity::error, "{} is not known exactly",
    "With --exact every number of the model is a fraction. Logarithms and roots are not, and fractions "
    "of many thousand digits are not kept."};
const Rule bad_bound{"PRISM-E14", Severity::error, "the bound {} is no probability",
                     "The bound of P and S lies between 0 and 1, that of R is 0 or more."};
const Rule left_out{"PRISM-E15", Severity::error, "a step that would leave the range of a variable is left out",
                    "`emit prism` guards the steps that could leave a range in states that nothing reaches, since "
                    "PRISM's default engine looks at these too. Here such a state is reachable, so the file has other "
                    "steps than the model. Write it with wider ranges."};

std::span<const Rule* const> explore() {
    static constexpr std::array<const Rule*, 15> table{
        &constant_open, &arithmetic,       &out_of_range, &bad_probability, &wrong_sum,
        &empty_range,   &no_initial_state, &deadlocks,    &negative_reward, &bad_steps,
        &too_close,     &normalised,       &not_exact,    &bad_bound,       &left_out};
    return table;
}

}  // namespace robochart::prism::rules
