// SPDX-License-Identifier: Apache-2.0
#include "prism/checks/rules.hpp"

#include <array>

namespace robochart::prism::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule not_declared{"PRISM-T01", Severity::error, "{} '{}' is not declared",
                        "No constant, variable, formula, label, module, property or action of the required kind has "
                        "this name. Commands declare actions."};
const Rule declared_twice{"PRISM-T02", Severity::error, "'{}' is declared twice",
                          "Constants, variables and formulas share one name space. Modules, labels, reward structures "
                          "and properties have one name space each. Declare each name once."};
const Rule wrong_type{"PRISM-T03", Severity::error, "expected {}, found {}",
                      "Values have type int, double or bool. An int can be used as a double, but there are no other "
                      "conversions. `/` always gives a double. For an int, use floor(a/b)."};
const Rule wrong_function{"PRISM-T04", Severity::error, "{}",
                          "The functions are min and max (one argument or more), floor, ceil and round (one argument), "
                          "and pow, mod and log (two arguments)."};
const Rule defined_by_itself{
    "PRISM-T05", Severity::error, "'{}' is defined by itself: {}",
    "Constants and formulas may use each other, but not themselves, either directly or through others."};
const Rule not_constant{"PRISM-T06", Severity::error, "{} must be constant, but '{}' is a variable",
                        "Ranges, initial values, values of constants, bounds of probabilities and numbers of steps are "
                        "evaluated before the model has a state."};
const Rule foreign_variable{"PRISM-T07", Severity::error,
                            "module '{}' must not write '{}', because it is a variable of module '{}'",
                            "A module may read every variable, but may write only its own and the global variables."};
const Rule global_written{"PRISM-T08", Severity::error, "'{}' is global, so a command with an action must not write it",
                          "Commands with the same action in several modules are combined, so two of them could write "
                          "the same global variable at once. Write it in a command without an action."};
const Rule assigned_twice{"PRISM-T09", Severity::error, "'{}' is assigned twice in one update",
                          "All assignments of an update happen at once, so each variable can have only one new value."};
const Rule bad_renaming{"PRISM-T10", Severity::error, "module '{}': {}",
                        "A renamed module needs a base module that does not depend on it, a new name for each variable "
                        "of the base, and at most one new name for each other name."};
const Rule bad_composition{"PRISM-T11", Severity::error, "module '{}' occurs {} in system ... endsystem",
                           "The composition must contain every module of the model exactly once."};
const Rule two_initials{
    "PRISM-T12", Severity::error, "'{}' has an initial value, but the model has init ... endinit",
    "Give the initial states either by init ... endinit or by initial values of variables, not by both."};
const Rule own_label{"PRISM-T13", Severity::error, "label \"{}\" is predefined",
                     "\"deadlock\" holds in states without an enabled command, and \"init\" in the initial states. A "
                     "model cannot declare labels with these names."};
const Rule misplaced{"PRISM-T14", Severity::error, "{} is not allowed here",
                     "Queries (P, S, R, A, E, filter) are allowed only in properties. Path formulas (X, F, G, U, W, R) "
                     "are allowed only in the brackets of P, A, E and R. Labels are allowed only in properties."};
const Rule no_rewards{"PRISM-T15", Severity::error, "{}",
                      "R refers to a reward structure of the model: by its name, R{\"n\"}, by its number from 1, R{2}, "
                      "or to the first one, R."};
const Rule no_optimum{
    "PRISM-T16", Severity::error, "an mdp has no single value: write {}min=? or {}max=?",
    "A probability or an expected reward of an mdp depends on how its choices are resolved, so it is between a minimum "
    "and a maximum. Write which of them you need. Bounds (P>=0.5) need no such word, because they use the worst case."};
const Rule no_module{
    "PRISM-T17", Severity::error, "the model has no variables",
    "A state consists of the values of the variables. A model needs at least one variable, in a module or global."};
const Rule expands_too_far{
    "PRISM-T18", Severity::error, "the formulas expand to more than {}",
    "A formula is replaced by its definition. Formulas that use each other can grow without limit in this way."};

std::span<const Rule* const> checks() {
    static constexpr std::array<const Rule*, 18> table{
        &not_declared,     &declared_twice, &wrong_type,     &wrong_function, &defined_by_itself, &not_constant,
        &foreign_variable, &global_written, &assigned_twice, &bad_renaming,   &bad_composition,   &two_initials,
        &own_label,        &misplaced,      &no_rewards,     &no_optimum,     &no_module,         &expands_too_far};
    return table;
}

}  // namespace robochart::prism::rules
