// SPDX-License-Identifier: Apache-2.0
#include "prism/syntax/rules.hpp"

#include <array>

namespace robochart::prism::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule unexpected_token{"PRISM-P01", Severity::error, "expected {}, found {}",
                            "The text does not follow the grammar of PRISM here. Declarations and commands end with a "
                            "semicolon. The parts of an update are in parentheses: (x'=1) & (y'=2)."};
const Rule bad_character{"PRISM-P02", Severity::error, "no PRISM token begins with {}",
                         "PRISM consists of ASCII letters, digits and operators. Other characters are allowed only in "
                         "comments, which begin with //."};
const Rule open_label{"PRISM-P03", Severity::error, "the name in double quotes is not closed on its line",
                      "Names of labels, properties and reward structures are written in double quotes, on one line: "
                      "label \"done\" = s=3;"};
const Rule big_number{
    "PRISM-P04", Severity::error, "the number {} is too large",
    "Integers of PRISM have 32 bits including the sign. The exponent of a decimal number has at most three digits."};
const Rule too_deep{"PRISM-P05", Severity::error, "nested too deeply (the limit is {} levels)",
                    "The depth of expressions is limited, so that hostile input cannot exhaust the stack. Define "
                    "formulas for the inner parts."};
const Rule not_supported{"PRISM-P06", Severity::error, "this tool does not support {}",
                         "Discrete-time Markov chains (dtmc) and Markov decision processes (mdp) are supported "
                         "completely. Other kinds of models, and constructs that only they have, are rejected."};
const Rule given_twice{"PRISM-P07", Severity::error, "{} is given twice",
                       "A model has one type, at most one init ... endinit and at most one system ... endsystem."};
const Rule unreadable{"PRISM-P08", Severity::error, "cannot read '{}': {}",
                      "The file of the model or of the properties does not exist, is not a file, or cannot be read."};
const Rule unclear_operand{
    "PRISM-P09", Severity::error, "'{}' needs parentheses here, because it continues beyond the end of the operand",
    "The operand of X, F, G, U, W and R extends to the right as far as possible: F a & b is F (a & b). As operands of "
    "connectives they need parentheses, unless they come last: (F a) & (F b)."};

std::span<const Rule* const> syntax() {
    static constexpr std::array<const Rule*, 9> table{&unexpected_token, &bad_character, &open_label,
                                                      &big_number,       &too_deep,      &not_supported,
                                                      &given_twice,      &unreadable,    &unclear_operand};
    return table;
}

}  // namespace robochart::prism::rules
