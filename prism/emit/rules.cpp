// SPDX-License-Identifier: Apache-2.0
#include "prism/emit/rules.hpp"

#include <array>

namespace robochart::prism_emit::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule no_module{"RC-E01", Severity::error, "no PRISM for '{}': it is no module of the model",
                     "RoboTool's encoding in PRISM is one of whole modules: a platform and its controllers."};
const Rule unsupported_construct{
    "RC-E02", Severity::error, "no PRISM for {} in '{}'",
    "RoboTool's encoding in PRISM has nothing for exit and during actions, waits, conditional statements, final states "
    "of "
    "state machines, transitions between levels, and variables that a controller shares."};
const Rule unsupported_type{
    "RC-E03", Severity::error, "no PRISM for '{}': its type {} is not encoded",
    "Variables of PRISM are truth values and ranges of whole numbers: boolean, nat, int, real and "
    "enumerations without arguments are encoded."};
const Rule unsupported_expression{
    "RC-E04", Severity::error, "no PRISM for {} in '{}'",
    "Encoded: literals, variables, constants, arithmetic, comparisons, logic, if-then-else, and functions "
    "with a postcondition `result == ...`. Values of type real are whole numbers, except in probabilities and "
    "comparisons."};
const Rule unsupported_event{
    "RC-E05", Severity::error, "no PRISM for the event '{}' of '{}': {}",
    "An event that is used leads through connections to one other machine or to the platform. Values go to and from "
    "the platform, or through asynchronous connections."};
const Rule unsupported_operation{"RC-E06", Severity::error, "no PRISM for the operation '{}' of '{}': {}",
                                 "Operations are defined in the model, do not call themselves, have no conditions and "
                                 "at most one final state."};

const Rule bad_preferences{
    "RC-E07", Severity::error, "preferences {}: {}",
    "A file of RoboTool's preferences has lines KEY=VALUE: whole numbers of 32 bits for NAT_MIN, "
    "NAT_MAX, INT_MIN, INT_MAX, REAL_MIN and REAL_MAX, dtmc or mdp for PRISM_MODELTYPE."};
const Rule ignored_preferences{
    "RC-E08", Severity::warning, "preferences {}: {} {} not followed",
    "Followed are the ranges of nat, int and real, and PRISM_MODELTYPE. RoboTool's translator has more settings; with "
    "them its file may be of another model."};

std::span<const Rule* const> all() {
    static constexpr std::array table = {
        &no_module,         &unsupported_construct, &unsupported_type, &unsupported_expression,
        &unsupported_event, &unsupported_operation, &bad_preferences,  &ignored_preferences,
    };
    return table;
}

}  // namespace robochart::prism_emit::rules
