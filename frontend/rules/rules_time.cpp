// SPDX-License-Identifier: Apache-2.0
// Rules about clocks, waiting and deadlines.
#include "frontend/rules/rules.hpp"

namespace robochart::frontend::rules {

using enum diagnostics::Severity;

const Rule tt1{
    "TT1", error, "transition `{}` has a deadline but no trigger",
    "The deadline of a transition limits how long its trigger may take. Without a trigger there is nothing to limit."};
const Rule te1{"TE1", error, "`{}` is not allowed in an action",
               "Clocks are read only in conditions. Test the clock in the condition of a transition instead."};
const Rule te1_elsewhere{"TE1", error, "`{}` is not allowed in {}",
                         "Clocks are read only in the conditions of transitions."};
const Rule te2{"TE2", error, "clock `{}` does not belong to {} `{}`",
               "A machine can read its own clocks, and those of the interfaces that it uses or requires."};
const Rule te3{"TE3", error, "`sinceEntry({})` needs a state of {} `{}`{}",
               "`sinceEntry` measures the time since the entry of a state of the same machine. Final states are "
               "excluded, because no transition leaves them."};
const Rule te4{"TE4", error, "`{}` must stand alone on one side of `<`, `<=`, `>`, `>=` or `==`",
               "The semantics supports only such comparisons of clocks: no arithmetic on the time, and no `!=`."};
const Rule te4_type{"CE2", error, "time is compared with a {}, which is not a number",
                    "The other side of the comparison must be of type nat, int or real."};
const Rule te5{"TE5", error, "`sinceEntry({})` refers to a state that is not on the same level as the transition",
               "A transition can read the time since the entry of a state only if both are in the same machine or "
               "composite state."};
const Rule ts1{"TS1", error, "clock `{}` does not belong to {} `{}`",
               "`#C` resets a clock of the machine that contains the reset."};
const Rule untimed{"RC-U01", warning,
                   "conditions of `{}` read clocks, and untimed checks treat these comparisons as true",
                   "Without time, a comparison with a clock cannot be decided, so the untimed semantics treats it as "
                   "true. The rest of the condition still applies. Timed checks decide the whole condition."};

const std::vector<const Rule*>& of_time() {
    static const std::vector<const Rule*> rules = {&tt1, &te1,      &te1_elsewhere, &te2, &te3,
                                                   &te4, &te4_type, &te5,           &ts1, &untimed};
    return rules;
}

}  // namespace robochart::frontend::rules
