// SPDX-License-Identifier: Apache-2.0
// Rules about clocks, waiting and deadlines.
#include "frontend/rules/rules.hpp"

namespace robochart::frontend::rules {

using enum diagnostics::Severity;

const Rule tt1{
    "TT1", error, "transition `{}` has a deadline but no trigger",
    "The deadline of a transition says how long its trigger may stay away; without a trigger there is nothing to "
    "wait for."};
const Rule te1{"TE1", error, "`{}` cannot stand in an action",
               "Clocks are read in conditions only. Measure in the condition of a transition instead."};
const Rule te1_elsewhere{"TE1", error, "`{}` cannot stand in {}",
                         "Clocks are read in the conditions of transitions only."};
const Rule te2{"TE2", error, "clock `{}` does not belong to {} `{}`",
               "A clock is declared by the machine that reads it, or by an interface that it uses or requires."};
const Rule te3{
    "TE3", error, "`sinceEntry({})` needs a state of {} `{}`{}",
    "Time since entry is measured for a state of the same machine that can be left again, not for a final state."};
const Rule te4{"TE4", error, "`{}` must stand alone on one side of `<`, `<=`, `>`, `>=` or `==`",
               "The semantics watches clocks through such comparisons only: no arithmetic on the time, no `!=`."};
const Rule te4_type{"CE2", error, "time is compared with a {}, which is no number",
                    "The other side of the comparison is of type nat, int or real."};
const Rule te5{"TE5", error, "`sinceEntry({})` refers to a state that is not beside the transition",
               "Time since entry is read on transitions that stand in the same machine or composite state as the state "
               "itself."};
const Rule ts1{"TS1", error, "clock `{}` does not belong to {} `{}`",
               "`#C` resets a clock of the machine in which it stands."};
const Rule untimed{
    "RC-U01", warning, "conditions of `{}` read clocks; untimed checks take their comparisons with clocks for true",
    "Without time a comparison with a clock cannot be decided, so the untimed semantics takes it for true. What else "
    "a condition says stays. Timed checks decide the whole."};

const std::vector<const Rule*>& of_time() {
    static const std::vector<const Rule*> rules = {&tt1, &te1,      &te1_elsewhere, &te2, &te3,
                                                   &te4, &te4_type, &te5,           &ts1, &untimed};
    return rules;
}

}  // namespace robochart::frontend::rules
