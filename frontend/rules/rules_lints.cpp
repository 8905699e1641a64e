// SPDX-License-Identifier: Apache-2.0
// Warnings about well-formed models. They report constructs that are probably not intended, and explain their meaning.
#include "frontend/rules/rules.hpp"

namespace robochart::frontend::rules {

using enum diagnostics::Severity;

const Rule w_loose_machine{
    "RC-W01", warning,
    "{} of {} {} not connected in controller `{}`: triggers fire by themselves, and outputs reach no component",
    "An event without a connection in the controller is hidden: a trigger on it fires by itself, with any value, and "
    "an output on it never waits. Connect the event to another machine or to the controller."};
const Rule w_loose_controller{
    "RC-W01", warning,
    "{} of {} {} not connected in module `{}`: inputs arrive by themselves, and outputs reach no component",
    "The controller passes the event on, but the module does not connect it to the platform or to another controller. "
    "So it is hidden: inputs on it arrive by themselves, and outputs are lost. Connect the event in the module."};
const Rule w_loose_platform{"RC-W01", warning, "{} of {} {} not connected in module `{}` and never happen{}",
                            "The platform declares the event, but the module does not connect it to a controller, so "
                            "it never happens. Connect the event, or remove it from the platform."};
const Rule w_stuck{
    "RC-W02", warning, "{} `{}` has no enabled transition: {}{}",
    "Control cannot rest in a junction. If no guard of its transitions holds, the machine is stuck there, and no event "
    "can interrupt it. Add a transition with `condition else`, or guards that cover all cases."};
const Rule w_unreachable{"RC-W03", warning, "{} `{}` is never reached",
                         "No path of transitions leads from the initial junction of the container to this node."};
const Rule w_never{"RC-W04", warning, "transition `{}` is never taken: `{}` never holds",
                   "This guard is false for all values of the variables."};
const Rule w_else_never{"RC-W04", warning,
                        "transition `{}` is never taken: the other transitions from `{}` cover all cases",
                        "`condition else` holds if no guard of another transition from the same source holds. Here one "
                        "of these guards always holds."};
const Rule w_always{
    "RC-W05", warning, "the guard of transition `{}` always holds: `{}`",
    "This guard is true for all values of the variables. Remove it, or check whether another guard was intended."};
const Rule w_unset{
    "RC-W06", warning, "`{}` may be read here before it is set; its value is {} then",
    "On some path from the initial junction to this place, the variable is not assigned. It has no initial value, so "
    "it has the default value of its type: 0 for numbers, true for a boolean, the first literal of an enumeration, the "
    "empty set or sequence. Give it an initial value, or set it on every path."};
const Rule w_unused{"RC-W07", warning, "{} `{}` is never {}",
                    "The project does not use this declaration. A clock that is only reset measures no time."};
const Rule w_unread{"RC-W08", warning, "`{}` is assigned but never read",
                    "The value of the variable has no effect. Remove the variable, or check whether the behaviour "
                    "should depend on it."};
const Rule w_loop{
    "RC-W09", warning, "{} can form an endless loop without an event and without time",
    "A transition without a trigger is taken at once. If a cycle of such transitions neither waits, nor calls, nor "
    "communicates, nor changes a guard, it never ends while no time passes: the machine diverges. Give one of the "
    "transitions a trigger or a clock condition with a reset, or add a wait to the cycle."};
const Rule w_negative{"RC-W10", warning, "`{}` can be negative here, but is used as a nat: {}",
                      "The difference of natural numbers is an integer. It may be used as a nat only if a guard or "
                      "condition ensures that it is not negative."};
const Rule w_zero{"RC-W11", warning, "division by `{}`, which is 0",
                  "Division by 0 has no value. RoboTool's scripts silently divide by 1 instead. The meaning of the "
                  "model should not depend on this."};
const Rule w_maybe_zero{"RC-W11", warning, "the divisor `{}` may be 0 here",
                        "Neither the guard nor an enclosing condition ensures that the divisor is not 0, and division "
                        "by 0 has no value. RoboTool's scripts silently divide by 1 instead."};
const Rule w_shadows{"RC-W12", warning, "{} `{}` hides a {} with the same name",
                     "The inner declaration takes precedence: inside its scope, the name never means the outer one."};
const Rule w_hidden_member{
    "RC-W12", warning, "`{}` of interface `{}` is hidden by a {} with the same name in `{}`",
    "Declarations of a component take precedence over those of its interfaces, and earlier interfaces over later ones. "
    "The name never means the hidden variable here, and the two variables are different."};
const Rule w_endless{"RC-W13", warning, "the call of `{}` never returns",
                     "A call returns when the operation reaches a final state at its top. This operation has no "
                     "reachable final state, so the statements after the call are never executed. Nothing can "
                     "interrupt the call in an entry, exit or transition action."};
const Rule w_copy{"RC-W14", warning, "transition `{}` is a copy of `{}`",
                  "Both transitions have the same source, target, trigger, guard and action. Remove one of them."};
const Rule w_self{"RC-W15", warning, "`{}` is assigned to itself",
                  "The assignment has no effect. Probably one of the two names is wrong."};
const Rule w_deadline{
    "RC-W16", warning, "`{}` takes longer than its deadline of {}",
    "The statement waits longer than the deadline allows, so the deadline is always missed, and time cannot pass."};
const Rule w_deaf{"RC-W17", warning, "`{}` is connected, but {} never takes part in it",
                  "Both ends of a connection take part in each communication. If one end never uses the event, the "
                  "other end waits forever."};
const Rule w_never_reset{"RC-W18", warning, "clock `{}` is read but never reset",
                         "Without a reset, a clock counts from the start of its machine. Once the conditions on it "
                         "have changed, they never change back. Reset the clock where the measurement should begin."};
const Rule w_broken_promise{
    "RC-W19", warning, "operation `{}` is declared to terminate, but no final state is reached",
    "An operation ends when it reaches a final state at its top. Without a reachable final state, every call continues "
    "forever, and the statements after the call are never executed."};

const Rule w_missed{"RC-W20", warning, "no transition takes {} while {} waits for {} time units",
                    "An entry, exit or transition action cannot be interrupted. Until the action ends, the enclosing "
                    "states take no transitions, and events that the platform raises in the meantime are lost. To "
                    "avoid this, wait in a state, with a clock and a transition that is taken later."};

const Rule w_grows{"RC-W21", warning, "`{}` grows without bound: no condition reads it, and it is never reset",
                   "Generated code stops counting at the last value of the type, and a check at the last value of the "
                   "finite instantiation. Beyond these values, both differ from the model. Bound the growth by a "
                   "condition, or reset the variable."};

const std::vector<const Rule*>& of_lints() {
    static const std::vector<const Rule*> rules = {&w_loose_machine,  &w_loose_controller,
                                                   &w_loose_platform, &w_stuck,
                                                   &w_unreachable,    &w_never,
                                                   &w_else_never,     &w_always,
                                                   &w_unset,          &w_unused,
                                                   &w_unread,         &w_loop,
                                                   &w_negative,       &w_zero,
                                                   &w_maybe_zero,     &w_shadows,
                                                   &w_hidden_member,  &w_endless,
                                                   &w_copy,           &w_self,
                                                   &w_deadline,       &w_deaf,
                                                   &w_never_reset,    &w_broken_promise,
                                                   &w_missed,         &w_grows};
    return rules;
}

}  // namespace robochart::frontend::rules
