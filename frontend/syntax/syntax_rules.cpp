// SPDX-License-Identifier: Apache-2.0
// See syntax_rules.hpp. Codes RC-P are about parsing, codes RC-F about finding files. Retired codes are never reused.
#include "frontend/syntax/syntax_rules.hpp"

#include <algorithm>

namespace robochart::frontend::syntax {

using enum diagnostics::Severity;

const Rule unexpected{"RC-P01", error, "expected {}, found {}",
                      "The text does not follow the grammar of RoboChart at this place. Reading continues at the next "
                      "declaration, so that the same run finds other mistakes."};
const Rule too_deep{"RC-P02", error, "this is nested deeper than {} levels",
                    "Expressions, statements, types, packages and composite states may be nested 256 levels deep, and "
                    "chains of operators may have 1000 links. The limit protects the stack of the tool. No model "
                    "written by people comes near it."};
const Rule open_comment{"RC-P03", error, "this comment is never closed",
                        "A comment that begins with `/*` ends with the next `*/`. Comments cannot be nested."};
const Rule open_string{
    "RC-P04", error, "this string is never closed",
    "A string ends with the same kind of quote with which it begins. Write `\\\"` for a quote inside it."};
const Rule strange_character{
    "RC-P05", error, "`{}` is not allowed here",
    "Names consist of the letters a-z and A-Z, digits and `_`. Other characters are allowed in comments and strings."};
const Rule huge_integer{"RC-P06", error, "the number {} is too large",
                        "Integers are at most 9223372036854775807 (64 bits)."};
const Rule long_real{"RC-P07", error, "the number {} has too many digits",
                     "Decimal numbers are stored exactly, with at most 18 digits."};
const Rule not_text{"RC-P08", error, "this file is not text",
                    "The file contains a zero byte, so it is not a text file. It is probably not a model."};
const Rule legacy_trigger{"RC-P09", warning, "`trigger` without an event is an old form; remove the word `trigger`",
                          "Early versions of RoboChart had `trigger` before clock resets even if the transition waits "
                          "for no event. The form is still read, as if the word `trigger` were not there."};
const Rule blank_in_set{"RC-P10", error, "`{0} (` must be written `{0}(`, without a space",
                        "`Set(` and `Seq(` are single words of the grammar."};
const Rule reserved_name{
    "RC-P11", error, "`{0}` is a reserved word; to use it as a name, write `^{0}`",
    "A word of the grammar can be a name only if a `^` precedes it. The `^` is not part of the name."};
const Rule bare_value{
    "RC-P12", error, "a communicated value must be a single atom or call; put this expression in parentheses",
    "After `!` and `.`, the grammar allows only a literal, a name, a call or an expression in parentheses: `e!(x+1)`."};
const Rule open_csp_block{"RC-P13", error, "`csp-begin` without `csp-end`",
                          "The text from `csp-begin` to `csp-end` is CSPM, and is used without changes."};
const Rule too_many{"RC-P14", error, "too many mistakes; the rest of this file is not read",
                    "After 100 mistakes in one file, further messages rarely help."};
const Rule bare_quantifier{"RC-P15", error, "`{}` binds weaker than the operator before it; put it in parentheses",
                           "Quantifiers, lambda, let and `the` do not extend beyond the operator before them. "
                           "Parentheses show which operands belong together."};
const Rule late_package{"RC-P16", error, "the package clause must come first, and only once",
                        "`package P` names the package of the whole file."};
const Rule parameter_list{"RC-P17", error, "the last parameter of a list must follow `and`",
                          "After `with`, commas separate the parameters, and `and` precedes the last one: `with "
                          "constant a of S set to 1, and constant b of S set to 2`."};
const Rule clause_order{
    "RC-P18", error, "`{}` must come before `{}` in a transition",
    "The clauses of a transition have a fixed order: from, to, trigger or probability, clock resets, deadline, "
    "condition, action."};
const Rule stray_bracket{"RC-P19", error, "this `}}` has no matching `{{`",
                         "The text has more closing braces than opening ones."};
const Rule ragged_matrix{"RC-P20", error, "this row has {} entries, but the first row has {}",
                         "All rows of a matrix must have the same number of entries."};
const Rule single_equal{"RC-P21", error, "`=` assigns a value; to compare values, write `==`",
                        "In expressions, `==` means equality. `=` is allowed only in assignments and initial values."};
const Rule colon_equal{"RC-P22", error, "write an assignment with `=`, not `:=`",
                       "RoboChart assigns with `=` and compares with `==`."};
const Rule too_long{"RC-P23", error, "this file has more than {} words; the rest is not read",
                    "A program generated a file of this size, probably by mistake. The limit protects the memory."};
const Rule c_operator{"RC-P24", error, "write `{1}` instead of `{0}` here",
                      "The logical operators of RoboChart are `/\\`, `\\/` and `not`, as in mathematics."};
const Rule plain_name{
    "RC-P25", error, "`{}` must be a simple name here",
    "Transitions join nodes of their own container. Connections join components of the component that contains them. "
    "Events and clocks are those that the component sees. Write their names without `::`."};
const Rule needs_parentheses{"RC-P26", error, "{} needs parentheses",
                             "The grammar allows this form here only in parentheses: `(a.f)[1]`, `(f(1))(2)`, `(if c "
                             "then a else b end) + 1`, `A * (vector(B, 3))`."};
const Rule neural{
    "RC-P27", error, "`{}` belongs to the neural-network extension, which this tool does not read",
    "Newer grammars of RoboChart have controllers and operations that are artificial neural networks. This tool has no "
    "semantics for them. Model the component as a state machine, or as an operation without a body."};
const Rule clause_twice{"RC-P28", error, "a transition may have only one {} clause",
                        "A transition may have each of these clauses once: trigger (or probability), deadline, "
                        "condition and action. Join conditions by `/\\` and statements by `;`."};
const Rule trailing_semicolon{"RC-P29", error, "no statement follows this `;`",
                              "`;` separates two statements. Remove it after the last statement."};
const Rule legacy_list{
    "RC-P30", warning, "several interfaces in one `{}` clause are an old form",
    "The grammar has one interface for each `uses`, `requires` or `provides`. Lists are still read, as "
    "one clause for each name."};
const Rule clock_time{
    "RC-P31", error, "`{}` is not allowed before an assertion about a clock",
    "An assertion that a clock is initialised has no `timed` or `untimed`: `assertion A: clock C is initialised`."};
const Rule hyphenated{
    "RC-P32", error, "`{}` is one word, with a hyphen and without spaces",
    "`deadlock-free`, `divergence-free`, `timelock-free` and `tick-tock` are single words of the grammar."};
const Rule foreign_assertion{
    "RC-P33", warning, "assertion `{}` is not checked: `{} assertion` is for another tool",
    "Assertions begin with `assertion`, `timed assertion`, `untimed assertion` or `sleec assertion`. Assertions of "
    "other kinds are for other tools and are not checked here. A run of `check` reports this and does not succeed."};
const Rule other_notation{
    "RC-P34", error, "`{}` is not RoboChart here: {}",
    "The reader recognises words of UML, SCXML, Stateflow, UPPAAL, PRISM and programming languages where people often "
    "write them. The message shows what to write in RoboChart instead."};
const Rule probabilistic_clause_order{
    "RC-P35", error, "`with {}` must come before `with {}`, and only once",
    "A probabilistic assertion has its constants, definitions, modules and options in this order: `with constants C "
    "with definitions D with modules M with cmdoptions \"…\"`."};
const Rule unreadable{"RC-F01", error, "cannot read `{}`: {}", "The file or folder does not exist or cannot be read."};
const Rule empty_input{"RC-F02", error, "`{}` declares nothing",
                       "The input contains no interface, machine, controller, module, type or function."};
const Rule no_files{"RC-F03", error, "`{}` contains no RoboChart files",
                    "A project is a folder with files whose names end with `.rct` or `.assertions`."};
const Rule empty_file{"RC-F04", warning, "`{}` is empty", "The file contains only white space and comments."};

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
