// SPDX-License-Identifier: Apache-2.0
#include "csp_emit/swarm/rules.hpp"

namespace robochart::csp_emit::swarm_rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule syntax{
    "RC-V01", Severity::error, "expected {}, found {}",
    "A swarm is `swarm NAME for COMPONENT { ... }` with items such as `robots 3`, `grid 5 by 5`, `drive by "
    "forward on OPERATION`, `feed EVENT with count(1) on OPERATION` and `accept recurrent linked(1)` "
    "(docs/emergence.md)."};
const Rule unknown_name{"RC-V02", Severity::error, "{} has no {} '{}'{}",
                        "A swarm names the component that each robot runs, and the operations, events and constants of "
                        "this component that the swarm provides."};
const Rule no_fit{"RC-V03", Severity::error, "{}",
                  "Robots have positions only if the swarm has a grid, and they move only while time passes. A sensed "
                  "value must be in the range of its type in the model."};

std::vector<const Rule*> all() {
    return {&syntax, &unknown_name, &no_fit};
}

}  // namespace robochart::csp_emit::swarm_rules
