// SPDX-License-Identifier: Apache-2.0
#include "prism/syntax/rules.hpp"

#include <array>

namespace robochart::prism::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule unexpected_token{"PRISM-P01", Severity::error, "expected {}, found {}",
                            "The text does not follow PRISM's grammar here. Declarations and commands end with a "
                            "semicolon; the parts of an update stand in parentheses: (x'=1) & (y'=2)."};
const Rule bad_character{"PRISM-P02", Severity::error, "no PRISM token begins with {}",
                         "PRISM is written with ASCII letters, digits and operators; other characters may stand in "
                         "comments, which begin with //."};
const Rule open_label{"PRISM-P03", Severity::error, "the name in double quotes is not closed on its line",
                      "Names of labels, properties and reward structures stand in double quotes, on one line: "
                      "label \"done\" = s=3;"};
const Rule big_number{"PRISM-P04", Severity::error, "number {} is too large",
                      "Integers of PRISM have 32 bits with a sign; decimal numbers have an exponent of at most three "
                      "digits."};
const Rule too_deep{"PRISM-P05", Severity::error, "nested too deeply (the limit is {} levels)",
                    "Expressions may nest to a fixed depth only, so that hostile input cannot exhaust the stack. Name "
                    "the inner parts by formulas."};
const Rule not_supported{"PRISM-P06", Severity::error, "{}: not supported",
                         "Discrete-time Markov chains (dtmc) and Markov decision processes (mdp) are read whole. Other "
                         "kinds of models, and constructs that only they have, are refused by name."};
const Rule given_twice{"PRISM-P07", Severity::error, "{} is given twice",
                       "A model has one type, at most one init ... endinit and at most one system ... endsystem."};
const Rule unreadable{"PRISM-P08", Severity::error, "cannot read '{}': {}",
                      "The file of the model, or of the properties, is missing, is no file, or cannot be read."};
const Rule unclear_operand{"PRISM-P09", Severity::error,
                           "'{}' needs parentheses here: it is open where an operand ends",
                           "X, F, G, U, W and R take all that follows, as F a & b is F (a & b). In the operands of "
                           "connectives they stand in parentheses unless nothing follows: (F a) & (F b)."};

std::span<const Rule* const> syntax() {
    static constexpr std::array<const Rule*, 9> table{&unexpected_token, &bad_character, &open_label,
                                                      &big_number,       &too_deep,      &not_supported,
                                                      &given_twice,      &unreadable,    &unclear_operand};
    return table;
}

}  // namespace robochart::prism::rules
