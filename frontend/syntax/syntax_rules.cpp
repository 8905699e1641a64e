// SPDX-License-Identifier: Apache-2.0
// See syntax_rules.hpp. Codes RC-P are about parsing, codes RC-F about finding files. Retired codes are never reused.
#include "frontend/syntax/syntax_rules.hpp"

#include <algorithm>

namespace robochart::frontend::syntax {

using enum diagnostics::Severity;

const Rule unexpected{
    "RC-P01", error, "expected {}, found {}",
    "The text does not follow the grammar of RoboChart at this place. Reading goes on at the next declaration, so that "
    "other mistakes are found in the same run."};
const Rule too_deep{
    "RC-P02", error, "nested deeper than {} levels",
    "Expressions, statements, types, packages and composite states may be nested 256 levels deep, and chains of "
    "operators may have 1000 links. No model written by people comes near this; the limit protects the tool's stack."};
const Rule open_comment{"RC-P03", error, "this comment is never closed",
                        "A comment that begins with `/*` ends with the next `*/`; comments do not nest."};
const Rule open_string{"RC-P04", error, "this string is never closed",
                       "A string ends with the quote it began with. Write `\\\"` for a quote inside it."};
const Rule strange_character{
    "RC-P05", error, "`{}` is not allowed here",
    "Names consist of the letters a-z and A-Z, digits and `_`. Other characters are fine in comments and strings."};
const Rule huge_integer{"RC-P06", error, "the number {} is too large",
                        "Integers are at most 9223372036854775807 (64 bits)."};
const Rule long_real{"RC-P07", error, "the number {} has too many digits",
                     "Decimal numbers are kept exactly, with at most 18 digits in all."};
const Rule not_text{"RC-P08", error, "this file is not text",
                    "The file contains a zero byte, which text never does. It was probably not meant to be a model."};
const Rule legacy_trigger{
    "RC-P09", warning, "`trigger` without an event is an old form; leave the word `trigger` out",
    "Early versions of RoboChart wrote clock resets after `trigger` even where no event is awaited. The form is still "
    "read, with the meaning it would have without the word `trigger`."};
const Rule blank_in_set{"RC-P10", error, "`{0} (` must be written `{0}(`, without a blank",
                        "`Set(` and `Seq(` are single words of the grammar."};
const Rule reserved_name{
    "RC-P11", error, "`{0}` is a reserved word; as a name it is written `^{0}`",
    "Words of the grammar cannot be names unless a `^` precedes them. The `^` is not part of the name."};
const Rule bare_value{
    "RC-P12", error, "a communicated value must be a single atom or call; put this expression in parentheses",
    "After `!` and `.` the grammar takes a literal, a name, a call or a parenthesised expression: `e!(x+1)`."};
const Rule open_csp_block{"RC-P13", error, "`csp-begin` without `csp-end`",
                          "Everything from `csp-begin` to `csp-end` is CSPM text, handed on as it is."};
const Rule too_many{"RC-P14", error, "too many mistakes; the rest of this file was not read",
                    "After 100 mistakes in one file further messages rarely help."};
const Rule bare_quantifier{
    "RC-P15", error, "`{}` binds weaker than the operator before it; put it in parentheses",
    "Quantifiers, lambda, let, the and not reach further right than the operator in front of them; parentheses make "
    "plain what belongs together."};
const Rule late_package{"RC-P16", error, "the package clause must come first, and once",
                        "`package P` names the package of the whole file."};
const Rule parameter_list{
    "RC-P17", error, "a list of parameters ends with `and`",
    "After `with`, parameters are separated by commas and the last one is announced by `and`: `with constant a of S "
    "set to 1, and constant b of S set to 2`."};
const Rule clause_order{
    "RC-P18", error, "`{}` must come before `{}` in a transition",
    "The clauses of a transition have a fixed order: from, to, trigger or probability, clock resets, deadline, "
    "condition, action."};
const Rule stray_bracket{"RC-P19", error, "this `}}` closes nothing",
                         "There are more closing braces than opening ones."};
const Rule ragged_matrix{"RC-P20", error, "this row has {} entries, the first row has {}",
                         "All rows of a matrix have the same number of entries."};
const Rule single_equal{"RC-P21", error, "`=` assigns; values are compared with `==`",
                        "In expressions equality is `==`; `=` stands in assignments and initial values only."};
const Rule colon_equal{"RC-P22", error, "an assignment is written with `=`, not `:=`",
                       "RoboChart assigns with `=` and compares with `==`."};
const Rule too_long{"RC-P23", error, "this file has more than {} words; the rest was not read",
                    "A file of this size was made by a program, probably by mistake. The limit protects the memory."};
const Rule c_operator{"RC-P24", error, "`{}` is written `{}` here",
                      "The logical operators of RoboChart are `/\\`, `\\/` and `not`, as in mathematics."};
const Rule plain_name{
    "RC-P25", error, "`{}` has to be a simple name here",
    "Transitions join nodes of their own container, connections the parts of their own component, and "
    "events and clocks are those that the component sees: their names stand without `::`."};
const Rule needs_parentheses{"RC-P26", error, "{} needs parentheses",
                             "The grammar gives this form no place here; in parentheses it may stand anywhere: "
                             "`(a.f)[1]`, `(f(1))(2)`, `(if c then a else b end) + 1`, `A * (vector(B, 3))`."};
const Rule neural{
    "RC-P27", error, "`{}` is a construct of the neural-network extension, which is not read",
    "Newer grammars of RoboChart have controllers and operations that are artificial neural networks. They "
    "have no semantics here. Model the component by a state machine or by an operation without a body."};
const Rule clause_twice{
    "RC-P28", error, "a transition has one {} clause",
    "Of trigger (or probability), deadline, condition and action, each stands once in a transition. "
    "Join conditions by `/\\` and statements by `;`."};
const Rule trailing_semicolon{"RC-P29", error, "no statement follows this `;`",
                              "`;` stands between two statements, not behind the last one."};
const Rule legacy_list{
    "RC-P30", warning, "several interfaces in one `{}` clause are an old form",
    "The grammar has one interface for each `uses`, `requires` or `provides`. Lists are still read, as "
    "one clause for each name."};
const Rule clock_time{"RC-P31", error, "`{}` cannot stand before an assertion about a clock",
                      "Whether a clock is initialised is asked without `timed` or `untimed`: "
                      "`assertion A: clock C is initialised`."};
const Rule hyphenated{
    "RC-P32", error, "`{}` is one word, with a hyphen and without blanks",
    "`deadlock-free`, `divergence-free`, `timelock-free` and `tick-tock` are single words of the grammar."};
const Rule foreign_assertion{
    "RC-P33", warning, "assertion `{}` is not checked: `{} assertion` is of another tool",
    "Assertions here begin with `assertion`, `timed assertion`, `untimed assertion` or `sleec assertion`. A "
    "claim of another kind is left to "
    "the tool that it is for, and a run that checks says so and does not succeed."};
const Rule other_notation{"RC-P34", error, "`{}` is not RoboChart here: {}",
                          "Words of UML, SCXML, Stateflow, UPPAAL, PRISM and programming languages are recognised "
                          "where people write them, and the message says what RoboChart has instead."};
const Rule probabilistic_clause_order{
    "RC-P35", error, "`with {}` must come before `with {}`, and once",
    "A probabilistic assertion names its constants, definitions, modules and options in this order: `with constants C "
    "with definitions D with modules M with cmdoptions \"…\"`."};
const Rule unreadable{"RC-F01", error, "cannot read `{}`: {}", "The path given cannot be opened for reading."};
const Rule empty_input{"RC-F02", error, "`{}` declares nothing",
                       "There is no interface, machine, controller, module, type or function to look at."};
const Rule no_files{"RC-F03", error, "`{}` contains no RoboChart files",
                    "A project is a folder with files whose names end in `.rct` or `.assertions`."};
const Rule empty_file{"RC-F04", warning, "`{}` is empty", "The file holds nothing but blanks and comments."};

const std::vector<const Rule*>& rule_list() {
    static const std::vector<const Rule*> rules = {&unexpected,
                                                   &too_deep,
                                                   &open_comment,
                                                   &open_string,
                                                   &strange_character,
                                                   &huge_integer,
                                                   &long_real,
                                                   &not_text,
                                                   &legacy_trigger,
                                                   &blank_in_set,
                                                   &reserved_name,
                                                   &bare_value,
                                                   &open_csp_block,
                                                   &too_many,
                                                   &bare_quantifier,
                                                   &late_package,
                                                   &parameter_list,
                                                   &clause_order,
                                                   &stray_bracket,
                                                   &ragged_matrix,
                                                   &single_equal,
                                                   &colon_equal,
                                                   &unreadable,
                                                   &empty_input,
                                                   &no_files,
                                                   &empty_file,
                                                   &too_long,
                                                   &c_operator,
                                                   &plain_name,
                                                   &needs_parentheses,
                                                   &neural,
                                                   &clause_twice,
                                                   &trailing_semicolon,
                                                   &legacy_list,
                                                   &clock_time,
                                                   &hyphenated,
                                                   &foreign_assertion,
                                                   &other_notation,
                                                   &probabilistic_clause_order};
    return rules;
}

bool is_syntax(const Rule& rule) {
    return std::find(rule_list().begin(), rule_list().end(), &rule) != rule_list().end();
}

}  // namespace robochart::frontend::syntax
