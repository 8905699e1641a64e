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
                        "A swarm names the component that each robot runs, and of it the operations, events and "
                        "constants that its platform has to do with."};
const Rule no_fit{"RC-V03", Severity::error, "{}",
                  "Where robots are is known on a grid alone, and only where time passes do they move; what a robot "
                  "senses has to be a value that the model calculates with."};

std::vector<const Rule*> all() {
    return {&syntax, &unknown_name, &no_fit};
}

}  // namespace robochart::csp_emit::swarm_rules
