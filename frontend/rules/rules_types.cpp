// SPDX-License-Identifier: Apache-2.0
// Rules about types. Tg: rules about communications, after the published rules about triggers.
#include "frontend/rules/rules.hpp"

namespace robochart::frontend::rules {

using enum diagnostics::Severity;

const Rule initial_type{
    "RC-T01", error, "`{}` has type {}, but its initial value has type {}",
    "The initial value must fit the declared type: nat fits int, and int fits real, but not the other way round."};
const Rule assignment_type{"RC-T02", error, "`{}` has type {}, but the assigned value has type {}",
                           "The value must fit the type of the variable: nat fits int, and int fits real, but not the "
                           "other way round. The difference of two nats is an int."};
const Rule if_type{"RC-T03", error, "the condition of `if` must be boolean, but this is {}",
                   "A boolean decides which branch of `if` runs. Write a comparison, as in `if x > 0 then ... end`."};
const Rule condition_type{
    "RC-T04", error, "the condition of a transition must be boolean, but this is {}",
    "A guard is true or false. Write a comparison, as in `condition x > 0`, or a boolean variable."};
const Rule wait_type{"RC-T05", error, "`wait` takes an integer or a set of integers, but this is {}",
                     "Time passes in whole units: `wait(2)` takes two units, and `wait([1,3])` takes one to three."};
const Rule call_count{"RC-T06", error, "operation `{}` takes {} argument{}, but this call has {}",
                      "A call must give one argument for each parameter of the operation."};
const Rule call_type{"RC-T07", error, "argument {} of operation `{}` must be {}, but this is {}",
                     "The arguments of a call must fit the types of the operation's parameters."};
const Rule tg5{"Tg5", error, "event `{}` carries no value, so nothing can be {} on it",
               "Declare the event with a type, so that it carries values."};
const Rule tg2{"Tg2", error, "event `{}` carries a value of type {}, which is ignored here",
               "Write `e?x` to receive the value or `e!v` to send one."};
const Rule comm_input{"RC-T08", error, "event `{}` carries {}, which does not fit variable `{}` of type {}",
                      "The variable must be able to hold every value that the event can carry."};
const Rule comm_value{"RC-T09", error, "event `{}` carries {}, but this value is {}",
                      "The value that is sent must fit the event's type."};
const Rule literal_count{"RC-T10", error, "literal `{}` takes {} argument{}, but this one has {}",
                         "A literal that is declared with types needs a value for each of them."};
const Rule literal_bare{"RC-T11", warning, "literal `{}` takes no arguments; remove the parentheses",
                        "`L()` means the same as `L`. Write a literal without arguments without parentheses."};
const Rule literal_type{"RC-T12", error, "argument {} of literal `{}` must be {}, but this is {}",
                        "The arguments of a literal must fit the types in its declaration."};
const Rule function_count{"RC-T13", error, "function `{}` takes {} argument{}, but this call has {}",
                          "A call must give one argument for each parameter of the function."};
const Rule function_type{"RC-T14", error, "argument {} of function `{}` must be {}, but this is {}",
                         "The arguments of a call must fit the types of the function's parameters."};
const Rule not_callable{"RC-T15", error, "`{}` cannot be applied to arguments, because it is {}",
                        "Only functions, sequences and literals with parameters take arguments."};
const Rule tuple_index{"RC-T16", error, "a tuple of {} parts has no part `{}`; parts are numbered from 1",
                       "The index of a tuple is a number literal, from 1 to the number of its parts."};
const Rule index_count{"RC-T17", error, "{} takes {} ind{}, but this has {}",
                       "A tuple, sequence or vector takes one index. A matrix takes two."};
const Rule not_indexable{"RC-T18", error, "a value of type {} has no parts to select by `[ ]`",
                         "Only tuples, sequences, vectors and matrices have numbered parts."};
const Rule no_field{"RC-T19", error, "{} has no field `{}`", "A value has the fields that its datatype declares."};
const Rule field_type{"RC-T20", error, "field `{}` has type {}, but this value is {}",
                      "The value of a field must fit its declared type."};
const Rule field_missing{
    "RC-T21", warning, "the value of `{}` does not set the field{} {}, so the default of its type is used",
    "A record value should give each field once, but RoboTool accepts a record value without some fields. The default "
    "value of a type is 0, true, the first literal, or the empty set or sequence."};
const Rule cast_type{"RC-T22", error, "a value of type {} is never of type {}",
                     "A cast converts to a wider or a narrower type, not to an unrelated one."};
const Rule operand_type{"RC-T23", error, "`{}` cannot combine {} and {}",
                        "The operator is not defined for operands of these types."};
const Rule unary_type{"RC-T24", error, "`{}` cannot be applied to {}",
                      "The operator is not defined for an operand of this type."};
const Rule compare_type{"RC-T25", error, "{} and {} are never equal",
                        "`==` and `!=` compare two values only if the type of one fits the type of the other."};
const Rule mixed_types{
    "RC-T26", error, "the elements have no common type: {} and {}",
    "All elements of a set, sequence, vector or matrix, and both branches of `if`, must have a common type."};
const Rule size_value{"RC-T27", error,
                      "the size of a vector or matrix must be a positive integer or a constant, but this is `{}`",
                      "Sizes must be known before the model runs: `vector(real, 3)`, or a constant with a value."};
const Rule condition_boolean{
    "RC-T28", error, "{} must be boolean, but this is {}",
    "Conditions, preconditions and operands of logical operators are true or false. Write a comparison."};
const Rule deadline_type{"RC-T29", error, "a deadline is a number of time units, but this is {}",
                         "A deadline counts whole time units: `e <{ 3 }` gives three time units."};
const Rule not_assignable{"RC-T30", error, "`{}` is a {} and cannot be assigned",
                          "The left side of an assignment must be a variable, or a field or element of a variable: `x "
                          "= 1`, `p.x = 1`, `a[1] = 1`."};
const Rule comm_narrow{
    "RC-T31", warning, "event `{}` carries {}, but variable `{}` of type {} cannot hold every such value",
    "RoboTool accepts this, so it is only a warning. A value that does not fit is outside the type of the variable."};
const Rule wrong_contract{
    "RC-T36", warning, "the contract of function `{}` is ignored: {}",
    "RoboTool does not check contracts of functions, and some published models have wrong ones. The function is "
    "treated as if it had no contract: a csp block defines it, or its value is the default of its type."};
const Rule range_bounds{"RC-T33", error, "the bounds of a range must be numbers, but this is {}",
                        "Ranges such as `{a to b}` and `[a, b]` contain all numbers between two bounds."};
const Rule index_type{"RC-T34", error, "an index must be a whole number, but this is {}",
                      "The elements of sequences, vectors and matrices are numbered from 1."};
const Rule function_bare{"RC-T35", error, "function `{}` is called without `()`",
                         "Call a function without parameters with an empty list of arguments: `f()`."};

const std::vector<const Rule*>& of_types() {
    static const std::vector<const Rule*> rules = {&initial_type, &assignment_type,   &if_type,        &condition_type,
                                                   &wait_type,    &call_count,        &call_type,      &tg5,
                                                   &tg2,          &comm_input,        &comm_value,     &literal_count,
                                                   &literal_bare, &literal_type,      &function_count, &function_type,
                                                   &not_callable, &tuple_index,       &index_count,    &not_indexable,
                                                   &no_field,     &field_type,        &field_missing,  &cast_type,
                                                   &operand_type, &unary_type,        &compare_type,   &mixed_types,
                                                   &size_value,   &condition_boolean, &deadline_type,  &not_assignable,
                                                   &comm_narrow,  &wrong_contract,    &range_bounds,   &index_type,
                                                   &function_bare};
    return rules;
}

}  // namespace robochart::frontend::rules
