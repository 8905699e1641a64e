// SPDX-License-Identifier: Apache-2.0
// Rules about assertions and csp blocks (assertion language 4 and its validator).
#include "frontend/rules/rules.hpp"

namespace robochart::frontend::rules {

using enum diagnostics::Severity;

const Rule unknown_component{
    "RC-Q01", error, "there is no {} `{}`{}",
    "An assertion speaks of a module, controller, state machine, operation or csp block. Components are named by their "
    "path through references (`Module::controller_ref::machine_ref`), with the package in front unless it is imported "
    "or the file's own."};
const Rule not_a_component{
    "RC-Q02", error,
    "`{}` is a {}; an assertion is about a module, controller, state machine, operation or csp process",
    "Only these have a process that can be checked. RoboTool warns here and then generates no check."};
const Rule no_state{
    "RC-Q03", error, "`{}` is no state of `{}`{}",
    "`S is reachable in X` names a state below the component X, by its path from the top of its machine or by the full "
    "path through X. Initial nodes and junctions are left at once and cannot be asked for."};
const Rule no_clock{"RC-Q04", error, "`{}` is not the clock of a state machine or operation",
                    "`clock X::C is initialised` names a clock C by the path of its machine X."};
const Rule no_constant{
    "RC-Q05", error, "{} `{}` has no {} `{}`",
    "`with constant c of X set to e` names a constant that X declares, uses or requires; `with parameter p of O` a "
    "parameter of the operation O."};
const Rule constant_type{"RC-Q06", error, "`{}` has type {}, but the value given here has type {}",
                         "The value of a constant or parameter fits its declared type."};
const Rule constant_twice{"RC-Q07", warning, "`{}` of `{}` is given a value twice",
                          "An assertion sets a constant or parameter once; two values would make two questions."};
const Rule constants_open{
    "RC-Q08", warning, "`{}` requires the constant{} {}, which this assertion leaves open",
    "What a component requires is decided outside it. Without a value in the assertion the default of the "
    "instantiation counts, or what `--const` says."};
const Rule part_passed_over{"RC-Q10", warning, "`{}` is passed over: nothing here reads it",
                            "`instantiate T as S`, and definitions whose name is in quotation marks, are kept as "
                            "text. Types have the carriers of the finite instantiation."};
const Rule not_a_property{
    "RC-Q11", error, "`{}` is a number; a property is true or false, or asks with `=?`",
    "`prob property P: e` claims that e holds, or asks for a probability or an expected reward: `Prob=? of [φ]`. "
    "RoboTool has this as NotBooleanOrQueryInProbAssertion."};
const Rule path_property{
    "RC-Q12", error, "`{}` speaks of one path; a property says of which: `Prob`, `Reward`, `Forall` or `Exists`",
    "`Finally`, `Globally`, `Next`, `Until`, `Weak Until` and `Release` are formulas about a path. A state has many: "
    "`Prob=? of [φ]` measures them, `Forall [φ]` and `Exists [φ]` quantify. RoboTool has this as "
    "NotPathFormulaInProbAssertion."};

const Rule missed_where{
    "RC-Q13", error, "a claim about a missed event needs {}",
    "`event E is not missed in S` speaks of a state machine (or operation) S, or of a state S of one, by its path, and "
    "of an event E of this machine by its name. What an event is outside the machine, a buffer may keep."};

const std::vector<const Rule*>& of_assertions() {
    static const std::vector<const Rule*> rules = {
        &unknown_component, &not_a_component, &no_state,         &no_clock,       &no_constant,   &constant_type,
        &constant_twice,    &constants_open,  &part_passed_over, &not_a_property, &path_property, &missed_where};
    return rules;
}

}  // namespace robochart::frontend::rules
