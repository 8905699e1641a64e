// SPDX-License-Identifier: Apache-2.0
// Rules about assertions and csp blocks (assertion language 4 and its validator).
#include "frontend/rules/rules.hpp"

namespace robochart::frontend::rules {

using enum diagnostics::Severity;

const Rule unknown_component{
    "RC-Q01", error, "there is no {} `{}`{}",
    "An assertion is about a module, controller, state machine, operation or csp block. A component is named by its "
    "path through references (`Module::controller_ref::machine_ref`), preceded by its package unless this is imported "
    "or the package of the file."};
const Rule not_a_component{
    "RC-Q02", error,
    "`{}` is a {}; an assertion is about a module, controller, state machine, operation or csp process",
    "Only these have a process that can be checked. In this case RoboTool reports a warning and generates no check."};
const Rule no_state{
    "RC-Q03", error, "`{}` is not a state of `{}`{}",
    "`S is reachable in X` names a state of the component X, by its path from the top of its machine or by the full "
    "path through X. Initial nodes and junctions are left at once, so claims cannot name them."};
const Rule no_clock{"RC-Q04", error, "`{}` is not the clock of a state machine or operation",
                    "`clock X::C is initialised` names a clock C by the path of its machine X."};
const Rule no_constant{
    "RC-Q05", error, "{} `{}` has no {} `{}`",
    "`with constant c of X set to e` names a constant that X declares, uses or requires; `with parameter p of O` a "
    "parameter of the operation O."};
const Rule constant_type{"RC-Q06", error, "`{}` has type {}, but the value given here has type {}",
                         "The value of a constant or parameter must fit its declared type."};
const Rule constant_twice{"RC-Q07", warning, "`{}` of `{}` is given a value twice",
                          "An assertion sets a constant or parameter once. With two values it would make two claims."};
const Rule constants_open{
    "RC-Q08", warning, "`{}` requires the constant{} {}, which this assertion leaves open",
    "The environment of a component determines the constants that the component requires. If the assertion sets no "
    "value, the value of `--const` applies, or the default of the instantiation."};
const Rule part_passed_over{"RC-Q10", warning, "`{}` is ignored, because this tool does not use it",
                            "`instantiate T as S`, and definitions whose names are in quotation marks, are ignored. "
                            "Types have the carriers of the finite instantiation."};
const Rule not_a_property{"RC-Q11", error,
                          "`{}` is a number, but a property must be true or false, or a query with `=?`",
                          "`prob property P: e` claims that e holds, or queries a probability or an expected reward: "
                          "`Prob=? of [φ]`. RoboTool reports the same as NotBooleanOrQueryInProbAssertion."};
const Rule path_property{
    "RC-Q12", error,
    "`{}` is a formula about one path; a property needs `Prob`, `Reward`, `Forall` or `Exists` around it",
    "`Finally`, `Globally`, `Next`, `Until`, `Weak Until` and `Release` form formulas about one path, but many paths "
    "begin in a state. `Prob=? of [φ]` gives the probability of these paths, and `Forall [φ]` and `Exists [φ]` "
    "quantify over them. RoboTool reports the same as NotPathFormulaInProbAssertion."};

const Rule missed_where{"RC-Q13", error, "a claim about a missed event needs {}",
                        "In `event E is not missed in S`, S is the path of a state machine, an operation or one of "
                        "their states, and E is the name of an event of this machine. S cannot be a module or "
                        "controller, because buffers may store their events."};

const std::vector<const Rule*>& of_assertions() {
    static const std::vector<const Rule*> rules = {
        &unknown_component, &not_a_component, &no_state,         &no_clock,       &no_constant,   &constant_type,
        &constant_twice,    &constants_open,  &part_passed_over, &not_a_property, &path_property, &missed_where};
    return rules;
}

}  // namespace robochart::frontend::rules
