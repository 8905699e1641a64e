// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/syntax/rules.hpp"

#include <array>

namespace robochart::cspm::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule unexpected_token{
    "CSPM-P01", Severity::error, "expected {}, found {}",
    "The text does not follow the grammar of CSPM here. The end of a line ends an expression, unless the line ends "
    "with an operator or the next line begins with one (FDR manual, chapter CSPM)."};
const Rule bad_character{
    "CSPM-P02", Severity::error, "no CSPM token begins with {}",
    "CSPM consists of ASCII letters, digits and operators. Other characters are allowed only in comments and strings."};
const Rule foreign_name{"CSPM-P17", Severity::error,
                        "'{}' is not a name of CSPM: a name consists of the letters a to z and A to Z, digits and _",
                        "FDR reads only ASCII letters. Write the name without accents."};
const Rule open_comment{"CSPM-P03", Severity::error, "this comment is not closed",
                        "A block comment begins with {- and ends with -}; such comments nest. `{-1}` also begins a "
                        "comment: write `{ -1}`."};
const Rule open_literal{"CSPM-P04", Severity::error, "{} is not closed on its line",
                        "A string ends with \" and a character with ' on the line on which it begins."};
const Rule big_number{"CSPM-P05", Severity::error, "the number {} is too large",
                      "Integers are signed and have 64 bits."};
const Rule bad_property{
    "CSPM-P06", Severity::error, "unknown property or model '{}'",
    "`:[` is followed by one of: deadlock free, divergence free, livelock free, deterministic, has trace (each with an "
    "optional model [T], [F], [FD], [R], [RD], [V], [VD]), tau priority, partial order reduce."};
const Rule too_deep{"CSPM-P07", Severity::error, "nested too deeply (the limit is {} levels)",
                    "The depth of expressions is limited, so that hostile input cannot exhaust the stack. Give names "
                    "to the inner parts."};
const Rule not_associative{
    "CSPM-P08", Severity::error, "operator {} is not associative: add parentheses",
    "FDR reads neither `P [|A|] Q [|B|] R` nor `a == b == c`, because these operators are not associative."};
const Rule misplaced_declaration{
    "CSPM-P09", Severity::error, "{} cannot be declared {}",
    "A `let` may declare only functions, values, annotations, transparent and external functions, and timed sections. "
    "Modules may not contain assertions or print statements. Timed sections may not contain print statements."};
const Rule annotation_unused{"CSPM-P10", Severity::error, "'{}' has a type annotation, but is not declared here",
                             "A type annotation belongs to a declaration in the same list of declarations."};
const Rule annotation_repeated{
    "CSPM-P11", Severity::error, "'{}' has a second type annotation",
    "Give each name one annotation. The names of one channel declaration share their annotation."};
const Rule bad_annotation{
    "CSPM-P12", Severity::error, "the arguments of a function type must be in parentheses",
    "The type annotation of a function lists the types of its arguments in parentheses: `f :: (Int) -> Bool`."};
const Rule option_repeated{"CSPM-P13", Severity::error, "option '{}' is given twice",
                           "Give each option of an assertion only once."};
const Rule bad_include{"CSPM-P14", Severity::error, "include must be followed by a file name in double quotes",
                       "Write `include \"file.csp\"` on a line of its own."};
const Rule include_failed{"CSPM-P15", Severity::error, "cannot read '{}': {}",
                          "The program looks for an included file in the folder of the file that includes it. The file "
                          "does not exist or cannot be read."};
const Rule include_cycle{"CSPM-P16", Severity::error, "file '{}' includes itself",
                         "A file may not include itself, either directly or through other files."};

const Rule arrow_comment{
    "CSPM-P18", Severity::warning, "`-->` begins a comment; a prefix is written `a -> P`",
    "Two hyphens begin a comment, which extends to the end of the line. So the process after the arrow is not read."};

std::span<const Rule* const> all_rules() {
    static constexpr std::array<const Rule*, 18> table{
        &unexpected_token,    &bad_character,  &open_comment,    &open_literal,          &big_number,
        &bad_property,        &too_deep,       &not_associative, &misplaced_declaration, &annotation_unused,
        &annotation_repeated, &bad_annotation, &option_repeated, &bad_include,           &include_failed,
        &include_cycle,       &foreign_name,   &arrow_comment};
    return table;
}

}  // namespace robochart::cspm::rules
