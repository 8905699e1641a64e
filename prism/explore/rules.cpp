// SPDX-License-Identifier: Apache-2.0
#include "prism/explore/rules.hpp"

#include <array>

namespace robochart::prism::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule constant_open{"PRISM-E01", Severity::error, "the constant '{}' has no value",
                         "Neither the model nor the properties file gives the constant a value. Set one value with "
                         "--const NAME=VALUE, or several with --const NAME=LOW:HIGH or NAME=LOW:STEP:HIGH."};
const Rule arithmetic{"PRISM-E02", Severity::error, "{}",
                      "Integers have 32 bits, and a larger result is an error. Other errors are a remainder by zero or "
                      "a negative number, a negative exponent of integers, 0/0, Infinity - Infinity and the logarithm "
                      "of a negative number. 1/0 is Infinity. Only expressions that are used must have a value."};
const Rule out_of_range{"PRISM-E03", Severity::error, "'{}' would be {}, which is outside its range {}",
                        "An update or an initial value is outside the declared range of the variable. Guard the "
                        "command, or extend the range."};
const Rule bad_probability{"PRISM-E04", Severity::error, "{} is not a probability",
                           "A probability is between 0 and 1. A probability that depends on constants or variables may "
                           "be outside these bounds in some states."};
const Rule wrong_sum{
    "PRISM-E05", Severity::error, "the probabilities sum to {}, not to 1",
    "The probabilities of the updates of a command must sum to 1. A difference of up to 0.00001 is treated as a "
    "rounding error in the text: it is reported, and the probabilities are divided by the sum."};
const Rule empty_range{"PRISM-E06", Severity::error, "the range of '{}' is empty: {}..{}",
                       "The lower bound of a range must not exceed the upper bound, and both must fit into 32 bits."};
const Rule no_initial_state{"PRISM-E07", Severity::error, "{}",
                            "The expression of init ... endinit must hold in at least one state. All variables must "
                            "have ranges, so that the states can be listed."};
const Rule deadlocks{
    "PRISM-E08", Severity::warning, "no command is enabled in {}, so a self loop was added",
    "A state without an enabled command gets a loop to itself, so that every path is infinite. The label \"deadlock\" "
    "still marks this state. E [ F \"deadlock\" ] shows whether such a state is reachable."};
const Rule negative_reward{"PRISM-E09", Severity::error, "the reward {} is negative",
                           "Expected rewards are computed only if no reward is negative."};
const Rule bad_steps{"PRISM-E10", Severity::error, "{}",
                     "A bound on steps is a number from zero, and the lower bound must not exceed the upper bound. F<k "
                     "means F<=k-1, and F>k means F>=k+1."};
const Rule too_close{"PRISM-E11", Severity::error, "{}",
                     "Decimal numbers are exact and are compared exactly. Logarithms and roots are known only up to "
                     "rounding. A comparison that depends on the rounding is rejected, not guessed."};
const Rule normalised{"PRISM-E12", Severity::warning, "the probabilities sum to {}, so they were divided by this sum",
                      "The probabilities of a command sum almost to 1, as if they were rounded in the text. To avoid "
                      "this, write exact fractions such as 1/3."};
const Rule not_exact{"PRISM-E13", Severity::error, "{} is not known exactly",
                     "With --exact, every number of the model must be a fraction. Logarithms and roots are not "
                     "fractions, and fractions with many thousand digits are not stored."};
const Rule bad_bound{"PRISM-E14", Severity::error, "the bound {} is not a probability",
                     "The bound of P and S must be between 0 and 1. The bound of R must not be negative."};
const Rule left_out{"PRISM-E15", Severity::error, "the file omits a step that would leave the range of a variable",
                    "`emit prism` adds guards to steps that could leave a range in unreachable states, because PRISM's "
                    "default engine evaluates these states too. Here such a state is reachable, so the file has other "
                    "steps than the model. Emit it with wider ranges."};

std::span<const Rule* const> explore() {
    static constexpr std::array<const Rule*, 15> table{
        &constant_open, &arithmetic,       &out_of_range, &bad_probability, &wrong_sum,
        &empty_range,   &no_initial_state, &deadlocks,    &negative_reward, &bad_steps,
        &too_close,     &normalised,       &not_exact,    &bad_bound,       &left_out};
    return table;
}

}  // namespace robochart::prism::rules
