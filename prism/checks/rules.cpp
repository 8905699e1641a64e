// SPDX-License-Identifier: Apache-2.0
#include "prism/checks/rules.hpp"

#include <array>

namespace robochart::prism::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule not_declared{"PRISM-T01", Severity::error, "{} '{}' is not declared",
                        "The name is that of no constant, variable, formula, label, module, property or action, "
                        "whichever is asked for here. Actions are those of commands."};
const Rule declared_twice{"PRISM-T02", Severity::error, "'{}' is declared twice",
                          "Constants, variables and formulas share one space of names; modules, labels, reward "
                          "structures and properties have one each. Each name is declared once."};
const Rule wrong_type{"PRISM-T03", Severity::error, "expected {}, found {}",
                      "Values are of type int, double or bool. An int may stand where a double is wanted, nothing else "
                      "is converted. `/` always gives a double: use floor(a/b) for an int."};
const Rule wrong_function{"PRISM-T04", Severity::error, "{}",
                          "The functions are min and max (one argument or more), floor, ceil and round (one), pow, mod "
                          "and log (two)."};
const Rule defined_by_itself{"PRISM-T05", Severity::error, "'{}' is defined by itself: {}",
                             "Constants and formulas may use each other, but never, through others, themselves."};
const Rule not_constant{"PRISM-T06", Severity::error, "{} must be constant, but '{}' is a variable",
                        "Ranges, initial values, values of constants, bounds of probabilities and numbers of steps are "
                        "evaluated before there is any state."};
const Rule foreign_variable{"PRISM-T07", Severity::error, "module '{}' may not write '{}', a variable of module '{}'",
                            "A module may read every variable, but writes its own and the global ones only."};
const Rule global_written{"PRISM-T08", Severity::error, "'{}' is global: a command with an action may not write it",
                          "Commands with an action are combined over modules; two of them could write the same global "
                          "variable at once. Write it in a command without action."};
const Rule assigned_twice{"PRISM-T09", Severity::error, "'{}' is assigned twice in one update",
                          "All assignments of an update happen at once, so each variable has one new value."};
const Rule bad_renaming{"PRISM-T10", Severity::error, "module '{}': {}",
                        "A module made by renaming needs a base module that is not made of itself, new names for all "
                        "variables of the base, and one new name for each."};
const Rule bad_composition{"PRISM-T11", Severity::error, "module '{}' stands {} in system ... endsystem",
                           "The composition names every module of the model exactly once."};
const Rule two_initials{"PRISM-T12", Severity::error, "'{}' has an initial value, and the model has init ... endinit",
                        "Initial states are given by init ... endinit, or variable by variable, not by both."};
const Rule own_label{"PRISM-T13", Severity::error, "label \"{}\" is predefined",
                     "\"deadlock\" holds where no command is enabled, \"init\" in the initial states. No label may be "
                     "declared by these names."};
const Rule misplaced{"PRISM-T14", Severity::error, "{} may not stand here",
                     "Questions (P, S, R, A, E, filter) stand in properties; path formulas (X, F, G, U, W, R) in the "
                     "brackets of P, A, E and R; labels in properties."};
const Rule no_rewards{"PRISM-T15", Severity::error, "{}",
                      "R asks for a reward structure of the model: by its name, R{\"n\"}, by its number from 1, R{2}, "
                      "or the first, R."};
const Rule no_optimum{"PRISM-T16", Severity::error, "an mdp has no single value: write {}min=? or {}max=?",
                      "Over the choices of an mdp a probability or an expected reward lies between a minimum and a "
                      "maximum; say which is asked for. Bounds (P>=0.5) need no such word: they ask for the worst."};
const Rule no_module{"PRISM-T17", Severity::error, "the model has no variables",
                     "A state is a value for each variable; a model needs at least one variable, in a module or "
                     "global."};
const Rule expands_too_far{"PRISM-T18", Severity::error, "the formulas expand to more than {}",
                           "Formulas are replaced by what they stand for. Formulas that use each other can grow "
                           "without end in this way."};

std::span<const Rule* const> checks() {
    static constexpr std::array<const Rule*, 18> table{
        &not_declared,     &declared_twice, &wrong_type,     &wrong_function, &defined_by_itself, &not_constant,
        &foreign_variable, &global_written, &assigned_twice, &bad_renaming,   &bad_composition,   &two_initials,
        &own_label,        &misplaced,      &no_rewards,     &no_optimum,     &no_module,         &expands_too_far};
    return table;
}

}  // namespace robochart::prism::rules
