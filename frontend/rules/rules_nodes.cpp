// SPDX-License-Identifier: Apache-2.0
// Rules about nodes, transitions and actions.
#include "frontend/rules/rules.hpp"

namespace robochart::frontend::rules {

using enum diagnostics::Severity;

const Rule s2{"S2", error, "state `{}` has more than one {} action",
              "A state has at most one entry, one during and one exit action. Write several steps as one action, "
              "separated by `;`."};
const Rule ij1{"IJ1", error, "transition `{}` leads to the initial junction `{}`",
               "A machine or composite state begins at its initial junction. Control never returns to it. Let the "
               "transition lead to the state after the initial junction."};
const Rule ij2{"IJ2", error, "initial junction `{}` has {} outgoing transitions, but it needs exactly one",
               "A machine or composite state begins by taking the only transition of its initial junction."};
const Rule fs1{"FS1", error, "transition `{}` starts in the final state `{}`",
               "A final state ends the machine, operation or composite state, so no transition can leave it."};
const Rule fs2{"FS2", error, "final state `{}` has actions",
               "A final state has no entry, during or exit action. Put the action on the transition that leads to it."};
const Rule fs3{"FS3", error, "final state `{}` has {}", "A final state contains no nodes and no transitions."};
const Rule j1{"J1", error, "junction `{}` has no outgoing transition",
              "Control never rests in a junction, so a junction needs an outgoing transition."};
const Rule j2{"J2", error, "junction `{}` has no incoming transition",
              "A junction without an incoming transition is never reached, because only initial junctions start a "
              "machine or state."};
const Rule j3{"J3", error, "transition `{}` has a trigger but does not start in a state",
              "Control passes junctions without waiting, so a transition from a junction cannot wait for an event. "
              "Move the trigger to the transition that leads to the junction."};
const Rule t1{"T1", error, "{} `{}` of transition `{}` is not in the same container",
              "A transition connects two nodes of one machine or of one composite state. It never crosses the border "
              "of a state."};
const Rule t2{"T2", error, "the trigger of transition `{}` {} a value; a trigger only receives",
              "A trigger is written `e` or `e?x`. Write outputs (`e!v`) and synchronisations (`e.v`) in actions."};
const Rule pj1{"PJ1", error, "transition `{}` starts in the probabilistic junction `{}` but has no probability",
               "Each outgoing transition of a probabilistic junction must have a probability."};
const Rule pj2{"PJ2", error, "transition `{}` starts in the probabilistic junction `{}` and cannot have a condition",
               "Only probabilities determine the choice at a probabilistic junction."};
const Rule pj3{"PJ3", warning, "the probabilities of the transitions from `{}` add up to {}, not to 1",
               "The outgoing transitions of a probabilistic junction must cover all cases."};
const Rule pj3_unknown{"PJ3", warning, "the probabilities of the transitions from `{}` cannot be added up here",
                       "Some of the probabilities are not constant. Make sure that they add up to 1."};
const Rule pt1{"PT1", error,
               "transition `{}` has a probability but starts in `{}`, which is not a probabilistic junction",
               "Only outgoing transitions of a probabilistic junction have probabilities."};
const Rule pt2{"PT2", error, "the probability {} is not between 0 and 1",
               "A probability is a number from 0 to 1, for example `probability 0.5`. The probabilities of one "
               "junction add up to 1."};
const Rule pt2_unknown{"PT2", warning,
                       "this probability cannot be computed here; make sure that it lies between 0 and 1",
                       "The expression is not constant, so its range was not checked."};
const Rule stm3{"STM3", error, "state machine `{}` has {} initial junctions, but it needs exactly one",
                "A state machine begins at its only initial junction."};
const Rule stm3_inner{"STM3", warning, "{} `{}` has {} initial junctions, but it should have exactly one",
                      "A composite state or operation with nodes begins at its only initial junction."};
const Rule stm4{"STM4", error, "{} `{}` has no state and no final state",
                "The transitions from an initial junction must lead to a state. So a machine, composite state or "
                "operation with nodes needs a state or a final state."};
const Rule parameter_assigned{
    "PARAM", error, "parameter `{}` cannot be assigned",
    "The parameters of an operation are constant during a call. Declare a variable in the operation instead."};

const std::vector<const Rule*>& of_nodes() {
    static const std::vector<const Rule*> rules = {
        &s2,  &ij1, &ij2, &fs1,         &fs2, &fs3, &j1,          &j2,   &j3,         &t1,   &t2,
        &pj1, &pj2, &pj3, &pj3_unknown, &pt1, &pt2, &pt2_unknown, &stm3, &stm3_inner, &stm4, &parameter_assigned};
    return rules;
}

}  // namespace robochart::frontend::rules
