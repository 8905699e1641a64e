// SPDX-License-Identifier: Apache-2.0
// Warnings about well-formed models. They report constructs that are probably not intended, and explain their meaning.
#include "frontend/rules/rules.hpp"

namespace robochart::frontend::rules {

using enum diagnostics::Severity;

const Rule w_loose_machine{
    "RC-W01", warning,
    "{} of {} {} connected to nothing in controller `{}` and hidden there: triggers fire by themselves, outputs reach "
    "nobody",
    "An event that no connection of the controller mentions is hidden inside it: a trigger on it fires by itself, with "
    "any value, and an output on it never waits for anyone. Connect it to another machine or to the controller."};
const Rule w_loose_controller{
    "RC-W01", warning,
    "{} of {} {} connected to nothing in module `{}` and hidden there: inputs come by themselves, outputs reach nobody",
    "The controller passes the event on, but the module does not connect it to the platform or another controller, so "
    "it is hidden there: inputs on it arrive by themselves, outputs go nowhere."};
const Rule w_loose_platform{"RC-W01", warning, "{} of {} {} connected to nothing in module `{}` and never happen{}",
                            "The platform declares the event, but the module connects it to no controller, so it never "
                            "happens. Connect it, or leave it out of the platform."};
const Rule w_stuck{
    "RC-W02", warning, "{} `{}` has no enabled transition: {}{}",
    "Control cannot rest in a junction: when no guard of its transitions holds, the machine is stuck "
    "there, and nothing outside can interrupt it. Add a transition with `condition else`, or guards that "
    "cover all cases."};
const Rule w_unreachable{"RC-W03", warning, "{} `{}` is never reached",
                         "No path of transitions leads from the initial junction of its container to this node."};
const Rule w_never{"RC-W04", warning, "transition `{}` is never taken: `{}` never holds",
                   "No values of the variables make this guard true."};
const Rule w_else_never{
    "RC-W04", warning, "transition `{}` is never taken: the other transitions from `{}` cover all cases",
    "`condition else` holds when no other transition of the same source has a guard that holds; here "
    "one always has."};
const Rule w_always{"RC-W05", warning, "the guard of transition `{}` always holds: `{}`",
                    "All values of the variables make this guard true; either it can be left out, or something else "
                    "was meant."};
const Rule w_unset{
    "RC-W06", warning, "`{}` may be read here before anything sets it; it is {} then",
    "On some path from the initial junction to this place nothing assigns the variable. It has no initial "
    "value, so it holds the default of its type: 0 for numbers, true for a boolean, the first literal "
    "of an enumeration, the empty set or sequence. Give it an initial value, or set it on every path."};
const Rule w_unused{"RC-W07", warning, "{} `{}` is never {}",
                    "Nothing in the project uses what is declared here. A clock that is only reset measures nothing."};
const Rule w_unread{"RC-W08", warning, "`{}` is assigned but never read",
                    "The value of the variable has no effect on anything; either it can be left out, or something that "
                    "should depend on it does not."};
const Rule w_loop{
    "RC-W09", warning, "{} can go round for ever without an event and without time",
    "A transition without trigger is taken at once. A cycle of them, with nothing on it that waits, calls, "
    "communicates or changes a guard, runs without end while no time passes: the machine diverges. Give "
    "one of them a trigger, a clock condition with a reset, or put a wait on the cycle."};
const Rule w_negative{
    "RC-W10", warning, "`{}` can be negative here, but is taken for a nat: {}",
    "A difference of natural numbers is an integer; taking it for a nat is only right where a guard or "
    "condition makes sure that it is not negative."};
const Rule w_zero{
    "RC-W11", warning, "division by `{}`, which is 0",
    "Division by 0 has no value. RoboTool's scripts silently divide by 1 instead; the meaning of the model "
    "should not rest on that."};
const Rule w_maybe_zero{
    "RC-W11", warning, "the divisor `{}` may be 0 here",
    "Neither the guard nor a condition around makes sure that the divisor is not 0, and division by 0 "
    "has no value. RoboTool's scripts silently divide by 1 instead."};
const Rule w_shadows{"RC-W12", warning, "{} `{}` hides a {} of that name",
                     "The nearer declaration wins: inside its scope the name never means the other one."};
const Rule w_hidden_member{
    "RC-W12", warning, "`{}` of interface `{}` is hidden by a {} of that name in `{}`",
    "A component's own declarations come first, then its interfaces in order: the name never means the later one here, "
    "and the two variables are not the same."};
const Rule w_endless{
    "RC-W13", warning, "the call of `{}` never returns",
    "A call returns when the operation reaches a final state at its top. This one has none that is "
    "reached, so what follows the call never happens, and nothing can interrupt it in an entry, exit or "
    "transition action."};
const Rule w_copy{"RC-W14", warning, "transition `{}` is a copy of `{}`",
                  "The two have the same source, target, trigger, guard and action; one is enough."};
const Rule w_self{"RC-W15", warning, "`{}` is assigned to itself",
                  "The assignment changes nothing; perhaps one of the two names is wrong."};
const Rule w_deadline{"RC-W16", warning, "`{}` takes longer than its deadline of {}",
                      "The statement waits for longer than the deadline allows, so the deadline is always missed, and "
                      "time cannot go on."};
const Rule w_deaf{"RC-W17", warning, "`{}` is connected, but {} never takes part in it",
                  "A connection is a meeting of both ends. If one end never uses the event, the other waits for ever."};
const Rule w_never_reset{"RC-W18", warning, "clock `{}` is read but never reset",
                         "Without a reset a clock counts from the start of its machine: once the conditions on it have "
                         "changed, they never change back. Reset it where the counting is meant to begin."};
const Rule w_broken_promise{"RC-W19", warning, "operation `{}` is declared to terminate, but no final state is reached",
                            "An operation ends by reaching a final state at its top. Without one every call goes on "
                            "for ever, and what callers do next never happens."};

const Rule w_missed{
    "RC-W20", warning, "nothing takes {} while {} waits for {} time units",
    "An entry, exit or transition action is not interrupted: what the states around it await is taken only once it has "
    "ended, and what the platform raises meanwhile is lost. Where that matters, wait in the state, with a clock and a "
    "transition that may be taken later."};

const Rule w_grows{
    "RC-W21", warning, "`{}` grows without bound: no condition reads it, and nothing sets it back",
    "Generated code keeps the last value that its type has, and a check ends at the last value of the finite "
    "instantiation, so both differ from the model behind that value. Bound the growth by a condition, or set the "
    "variable "
    "back."};

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
