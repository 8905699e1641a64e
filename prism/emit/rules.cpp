// SPDX-License-Identifier: Apache-2.0
#include "prism/emit/rules.hpp"

#include <array>

namespace robochart::prism_emit::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule no_module{"RC-E01", Severity::error, "no PRISM model is generated for '{}', because it is not a module",
                     "RoboTool's encoding in PRISM describes a whole module: a platform and its controllers."};
const Rule unsupported_construct{
    "RC-E02", Severity::error, "{} in '{}' has no encoding in PRISM",
    "RoboTool's encoding in PRISM does not support exit and during actions, waits, conditional statements, final "
    "states of state machines, transitions between levels, and variables that a controller shares."};
const Rule unsupported_type{"RC-E03", Severity::error, "the type {1} of '{0}' has no encoding in PRISM",
                            "Variables of PRISM are truth values and ranges of whole numbers. So boolean, nat, int, "
                            "real and enumerations without arguments can be encoded."};
const Rule unsupported_expression{"RC-E04", Severity::error, "{} in '{}' has no encoding in PRISM",
                                  "Expressions can contain literals, variables, constants, arithmetic, comparisons, "
                                  "logic, if-then-else, and functions with a postcondition `result == ...`. Values of "
                                  "type real are whole numbers, except in probabilities and comparisons."};
const Rule unsupported_event{
    "RC-E05", Severity::error, "the event '{}' of '{}' has no encoding in PRISM: {}",
    "Connections must lead from an event that is used to one other machine or to the platform. Values can be sent to "
    "and from the platform, or through asynchronous connections."};
const Rule unsupported_operation{"RC-E06", Severity::error, "the operation '{}' of '{}' has no encoding in PRISM: {}",
                                 "An operation must be defined in the model, must not call itself, must have no "
                                 "conditions, and may have at most one final state."};

const Rule bad_preferences{
    "RC-E07", Severity::error, "preferences {}: {}",
    "A preferences file of RoboTool consists of lines KEY=VALUE. The values are whole numbers of 32 bits for NAT_MIN, "
    "NAT_MAX, INT_MIN, INT_MAX, REAL_MIN and REAL_MAX, and dtmc or mdp for PRISM_MODELTYPE."};
const Rule ignored_preferences{"RC-E08", Severity::warning, "preferences {}: {} {} ignored",
                               "The emitter uses only the ranges of nat, int and real, and PRISM_MODELTYPE. The "
                               "translator of RoboTool has more settings. With them it may generate another model."};

std::span<const Rule* const> all() {
    static constexpr std::array table = {
        &no_module,         &unsupported_construct, &unsupported_type, &unsupported_expression,
        &unsupported_event, &unsupported_operation, &bad_preferences,  &ignored_preferences,
    };
    return table;
}

}  // namespace robochart::prism_emit::rules
