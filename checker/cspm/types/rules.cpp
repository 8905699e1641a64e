// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/types/rules.hpp"

#include <array>

namespace robochart::cspm::types::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule not_in_scope{
    "CSPM-T01", Severity::error, "'{}' is not in scope",
    "No declaration of the name is visible here. Compressions and other extra functions need a line such as "
    "`transparent normal` or `external prioritise`. WAIT and timed_priority exist only in timed sections. Outside a "
    "module, its names are visible as M::name, and only if they are declared after `exports`."};
const Rule declared_twice{
    "CSPM-T02", Severity::error, "'{}' is declared twice in one scope",
    "A list of declarations may declare a name only once, and a variable may occur only once in the patterns of one "
    "equation, comprehension or prefix. The clauses of a function must follow each other directly."};
const Rule wrong_import{"CSPM-T03", Severity::error, "there is no {} function '{}'",
                        "`transparent` declares compressions (normal, sbisim, dbisim, wbisim, diamond, explicate, "
                        "tau_loop_factor, model_compress, chase ...). `external` declares the other extra functions "
                        "(prioritise, chase, deter, loop, mtransclose ...)."};
const Rule wrong_kind_of_name{
    "CSPM-T04", Severity::error, "'{}' is {}, not {}",
    "Modules are not values. Only modules have instances. The clauses of a subtype name constructors of a datatype."};
const Rule qualified_pattern{
    "CSPM-T05", Severity::error, "'{}' is not a constructor or channel, so it cannot be matched",
    "In a pattern, a plain name that is not a constructor or channel is a new variable. A name with `::` cannot be a "
    "variable, so it must be a constructor or channel of that module."};
const Rule field_order{"CSPM-T06", Severity::error, "a `$` field must precede all `?` and `!` fields",
                       "`c$x?y` chooses x first and then offers y. After `?` or `!`, a `$` does not have this meaning, "
                       "and FDR rejects it."};
const Rule bad_type_variable{
    "CSPM-T07", Severity::error, "{}",
    "In an annotation, a name is a type variable unless it is a datatype or Int, Bool, Char, Event or Proc. "
    "Constraints apply to variables of the same annotation. The left side of `=>*` is a variable."};
const Rule mismatch{
    "CSPM-T08", Severity::error, "expected {}, found {}",
    "The expression does not have the type that is needed here. Types are written as in FDR: {a} is a set, <a> a "
    "sequence, (a, b) a tuple, (a) -> b a function, and a => b a value that becomes a b when it is dotted with an a."};
const Rule wrong_arity{"CSPM-T09", Severity::error, "{} takes {}, but is given {}",
                       "A call must give exactly the arguments of one group of parameters: f(x, y) differs from "
                       "f(x)(y) and from f((x, y))."};
const Rule not_a_function{"CSPM-T10", Severity::error, "this is {}, not a function, so it cannot be applied",
                          "Only functions are applied to arguments in parentheses. Channels and constructors take "
                          "their fields after dots: c.x, not c(x)."};
const Rule lacks_constraint{
    "CSPM-T11", Severity::error, "{} {}",
    "Some operations need a type with a property. Eq (==, member, card, elem, patterns of sets): all types except "
    "processes and functions. Ord (<, <=): integers, characters, and sets or sequences, which are compared by "
    "inclusion and by prefix. Set (elements of sets): the types of Eq, and processes. Complete (fields and inputs): "
    "values without missing fields. Yieldable ({| |}): events and datatypes."};
const Rule infinite_type{"CSPM-T12", Severity::error, "the type {} would have to be {}, which contains it",
                         "No finite type fits. Examples are a function that is applied to itself, and a sequence that "
                         "is its own element. If you need a recursive structure, declare a datatype."};
const Rule too_many_fields{"CSPM-T13", Severity::error, "too many fields: {} takes no further field, but {} follows",
                           "A channel or constructor with all fields of its declaration is an event or a value. With "
                           "`channel c : Int`, c.1 is an event, so c.1.2 has no type."};
const Rule too_few_fields{"CSPM-T14", Severity::error, "too few fields: this is {} only when followed by {}",
                          "A channel or constructor is an event or a value only with all its fields. In `{| c |}`, in "
                          "renamings and in links, the last fields may be missing."};
const Rule open_fields{"CSPM-T15", Severity::error, "the type of the fields of '{}' is not determined: {}",
                       "Each field of a channel or constructor must have one known type, because this type determines "
                       "what can be communicated. An empty set as a field is a common cause: `channel c : {}`. Add an "
                       "annotation, or a set that determines the type."};
const Rule subtype_fields{"CSPM-T16", Severity::error, "constructor '{}' has {}, but the subtype gives {}",
                          "A clause of a subtype restricts the fields of its constructor. It cannot add fields."};
const Rule fixed_extension{"CSPM-T17", Severity::error,
                           "'{}' stands for fields that are not known here, so they cannot be fixed",
                           "In `a =>* b` of an annotation, the variable stands for the fields that are still missing "
                           "in the caller's value. The body of the function may not determine these fields."};
const Rule module_arguments{"CSPM-T18", Severity::error, "module '{}' takes {}, but the instance gives {}",
                            "`instance I = M(x)` gives one argument for each parameter of the module."};
const Rule module_cycle{"CSPM-T19", Severity::error, "module '{}' uses '{}', an instance of itself",
                        "The module alone must determine its instances. If the declarations of a module use an "
                        "instance of this module, directly or through other modules, the expansion never ends."};
const Rule type_overflow{"CSPM-T20", Severity::error, "the types here are {}",
                         "The depth of types and the work to compute them are limited, so that no script exhausts the "
                         "memory. Such types come from repeated doubling of tuples. Use a datatype instead."};
const Rule print_ill_typed{
    "CSPM-T21", Severity::warning, "this print statement cannot be evaluated: {}",
    "FDR evaluates a print statement only on request, so a wrong print statement does not make the script wrong."};

const Rule bad_pattern{
    "CSPM-T22", Severity::error, "this pattern is not allowed: {}",
    "A pattern must determine the parts of a value uniquely. `xs ^ ys` could split a sequence at any place, {x, y} "
    "names elements without an order, and in a prefix each field is matched only once."};
const Rule not_timed{"CSPM-T23", Severity::error, "{} is not allowed in a timed section",
                     "In a timed section, every process lets time pass by the event tock. FDR does not define this for "
                     "linked parallel and for nondeterministic inputs."};

std::span<const Rule* const> all_rules() {
    static constexpr std::array<const Rule*, 23> table{
        &not_in_scope,     &declared_twice,    &wrong_import,     &wrong_kind_of_name, &qualified_pattern,
        &field_order,      &bad_type_variable, &mismatch,         &wrong_arity,        &not_a_function,
        &lacks_constraint, &infinite_type,     &too_many_fields,  &too_few_fields,     &open_fields,
        &subtype_fields,   &fixed_extension,   &module_arguments, &module_cycle,       &type_overflow,
        &print_ill_typed,  &bad_pattern,       &not_timed};
    return table;
}

}  // namespace robochart::cspm::types::rules
