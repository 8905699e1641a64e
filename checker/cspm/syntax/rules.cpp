// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/syntax/rules.hpp"

#include <array>

namespace robochart::cspm::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule unexpected_token{
    "CSPM-P01", Severity::error, "expected {}, found {}",
    "The text does not follow CSPM's grammar here. A line end closes an expression unless the "
    "next line begins with an operator or the last line ended with one (FDR manual, chapter CSPM)."};
const Rule bad_character{"CSPM-P02", Severity::error, "no CSPM token begins with {}",
                         "CSPM is written with ASCII letters, digits and operators; other characters may stand in "
                         "comments and strings only."};
const Rule foreign_name{"CSPM-P17", Severity::error,
                        "'{}' is no name in CSPM: names are made of the letters a to z and A to Z, digits and _",
                        "FDR reads ASCII letters only: write the name without accents."};
const Rule open_comment{"CSPM-P03", Severity::error, "comment is not closed",
                        "A block comment begins with {- and ends with -}; such comments nest. Note that `{-1}` begins "
                        "one: write `{ -1}`."};
const Rule open_literal{"CSPM-P04", Severity::error, "{} is not closed on its line",
                        "Strings end with \" and characters with ' on the line they begin."};
const Rule big_number{"CSPM-P05", Severity::error, "number {} is too large",
                      "Integers are limited to 64 bits, signed."};
const Rule bad_property{"CSPM-P06", Severity::error, "unknown property or model '{}'",
                        "After `:[` stands one of: deadlock free, divergence free, livelock free, deterministic, has "
                        "trace (each with an optional model [T], [F], [FD], [R], [RD], [V], [VD]), tau priority, "
                        "partial order reduce."};
const Rule too_deep{"CSPM-P07", Severity::error, "nested too deeply (the limit is {} levels)",
                    "Expressions may nest to a fixed depth only, so that hostile input cannot exhaust the stack. "
                    "Name the inner parts."};
const Rule not_associative{"CSPM-P08", Severity::error, "operator {} does not associate: add parentheses",
                           "FDR reads neither `P [|A|] Q [|B|] R` nor `a == b == c`: these operators are not "
                           "associative."};
const Rule misplaced_declaration{"CSPM-P09", Severity::error, "{} cannot be declared {}",
                                 "In a `let` only functions, values, annotations, transparent, external and timed "
                                 "sections may be declared; modules may hold no assertions or print statements, timed "
                                 "sections no print statements."};
const Rule annotation_unused{"CSPM-P10", Severity::error, "type annotation for '{}', which is not declared here",
                             "A type annotation belongs to a declaration in the same list of declarations."};
const Rule annotation_repeated{"CSPM-P11", Severity::error, "second type annotation for '{}'",
                               "Give each name one annotation; names of one channel declaration share theirs."};
const Rule bad_annotation{"CSPM-P12", Severity::error, "the arguments of a function type stand in parentheses",
                          "A type annotation of a function names its arguments in parentheses: `f :: (Int) -> Bool`."};
const Rule option_repeated{"CSPM-P13", Severity::error, "option '{}' is given twice",
                           "Each option of an assertion may be given once."};
const Rule bad_include{"CSPM-P14", Severity::error, "include needs a file name in double quotes",
                       "Write `include \"file.csp\"` on a line of its own."};
const Rule include_failed{
    "CSPM-P15", Severity::error, "cannot read '{}': {}",
    "An included file is looked for beside the file that includes it; it is missing or cannot be read."};
const Rule include_cycle{"CSPM-P16", Severity::error, "file '{}' includes itself",
                         "A file may not be included by itself, directly or through others."};

const Rule arrow_comment{"CSPM-P18", Severity::warning, "`-->` begins a comment; a prefix is written `a -> P`",
                         "Two hyphens begin a comment, which reaches to the end of the line, so the process behind the "
                         "arrow is not read."};

std::span<const Rule* const> all_rules() {
    static constexpr std::array<const Rule*, 18> table{
        &unexpected_token,    &bad_character,  &open_comment,    &open_literal,          &big_number,
        &bad_property,        &too_deep,       &not_associative, &misplaced_declaration, &annotation_unused,
        &annotation_repeated, &bad_annotation, &option_repeated, &bad_include,           &include_failed,
        &include_cycle,       &foreign_name,   &arrow_comment};
    return table;
}

}  // namespace robochart::cspm::rules
