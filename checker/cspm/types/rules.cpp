// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/types/rules.hpp"

#include <array>

namespace robochart::cspm::types::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule not_in_scope{
    "CSPM-T01", Severity::error, "'{}' is not in scope",
    "The name is declared nowhere that this place can see. Compressions and other extra functions "
    "need a line such as `transparent normal` or `external prioritise`; WAIT and timed_priority exist "
    "in timed sections only; names of a module are seen outside it as M::name, and only if they stand "
    "below its `exports`."};
const Rule declared_twice{"CSPM-T02", Severity::error, "'{}' is declared twice in one scope",
                          "A name may be declared once in a list of declarations, and a variable may occur once in the "
                          "patterns of one equation, comprehension or prefix. The clauses of a function must stand "
                          "together."};
const Rule wrong_import{
    "CSPM-T03", Severity::error, "there is no {} function '{}'",
    "`transparent` makes the compressions known (normal, sbisim, dbisim, wbisim, diamond, explicate, "
    "tau_loop_factor, model_compress, chase ...), `external` the other extra functions (prioritise, "
    "chase, deter, loop, mtransclose ...)."};
const Rule wrong_kind_of_name{"CSPM-T04", Severity::error, "'{}' is {}, not {}",
                              "Modules are not values; only modules have instances; the clauses of a subtype name "
                              "constructors of a datatype."};
const Rule qualified_pattern{
    "CSPM-T05", Severity::error, "'{}' is no constructor or channel, so it cannot be matched",
    "In patterns, a plain name that is no constructor or channel is a new variable. A name with "
    "`::` cannot be one, so it must be a constructor or channel of that module."};
const Rule field_order{"CSPM-T06", Severity::error, "a `$` field must stand before all `?` and `!` fields",
                       "`c$x?y` chooses x first and then offers y. After `?` or `!` a `$` has no such meaning, and FDR "
                       "rejects it."};
const Rule bad_type_variable{
    "CSPM-T07", Severity::error, "{}",
    "In annotations a name that is no datatype and not Int, Bool, Char, Event or Proc is a type "
    "variable. Constraints are put on variables of the same annotation, and the left of `=>*` is a "
    "variable."};
const Rule mismatch{
    "CSPM-T08", Severity::error, "expected {}, found {}",
    "The expression has one type and its place asks for another. Types are written as in FDR: {a} a set, "
    "<a> a sequence, (a, b) a tuple, (a) -> b a function, a => b what becomes a b when dotted with an a."};
const Rule wrong_arity{
    "CSPM-T09", Severity::error, "{} takes {} but is given {}",
    "A function is applied to exactly the arguments of its group: f(x, y) is not f(x)(y), and neither is "
    "f((x, y))."};
const Rule not_a_function{
    "CSPM-T10", Severity::error, "this is not a function but {}, so it cannot be applied",
    "Only functions are applied to arguments in parentheses. Channels and constructors take their "
    "fields by dots: c.x, not c(x)."};
const Rule lacks_constraint{
    "CSPM-T11", Severity::error, "{} {}",
    "Some operations ask for more than a type. Eq (==, member, card, elem, patterns of sets): all but "
    "processes and functions. Ord (<, <=): integers, characters, and sets or sequences, which are "
    "compared by inclusion and by prefix. Set (elements of sets): as Eq, and processes. Complete "
    "(fields and inputs): no value that still lacks fields. Yieldable ({| |}): events and datatypes."};
const Rule infinite_type{
    "CSPM-T12", Severity::error, "the type {} would have to be {}, which contains it",
    "No finite type fits, for example of a function applied to itself or a sequence that is its own "
    "element. Where a recursive structure is meant, declare a datatype."};
const Rule too_many_fields{
    "CSPM-T13", Severity::error, "too many fields: {} takes no more, yet {} follows",
    "A channel or constructor takes the fields of its declaration and then is an event or a value: "
    "with `channel c : Int`, c.1 is an event, so c.1.2 is not typed."};
const Rule too_few_fields{"CSPM-T14", Severity::error, "too few fields: this is {} only when followed by {}",
                          "A channel or constructor is an event or a value only with all its fields. In `{| c |}`, in "
                          "renamings and links it may stand without its last ones."};
const Rule open_fields{
    "CSPM-T15", Severity::error, "the type of the fields of '{}' is not determined: {}",
    "Each field of a channel or constructor must have one known type, else nothing could be said about "
    "what is communicated. An empty set as a field is a common cause: `channel c : {}`. Add an annotation "
    "or a set that fixes it."};
const Rule subtype_fields{"CSPM-T16", Severity::error, "constructor '{}' has {}, the subtype gives {}",
                          "A clause of a subtype restricts the fields its constructor has; it cannot add any."};
const Rule fixed_extension{
    "CSPM-T17", Severity::error, "'{}' stands for fields that are not known here, so they cannot be fixed",
    "In `a =>* b` of an annotation, the variable stands for whatever fields the caller's value still "
    "takes. The body of the function may not give it a particular meaning."};
const Rule module_arguments{"CSPM-T18", Severity::error, "module '{}' takes {}, the instance gives {}",
                            "`instance I = M(x)` gives one argument for each parameter of the module."};
const Rule module_cycle{
    "CSPM-T19", Severity::error, "module '{}' uses '{}', an instance of itself",
    "What an instance is must be known from its module alone; a module whose declarations use an instance "
    "of it, directly or through others, would never end."};
const Rule type_overflow{
    "CSPM-T20", Severity::error, "the types here are {}",
    "Types are bounded in depth and in the work they take, so that no script exhausts memory. Such types "
    "come from tuples of tuples doubled again and again; a datatype would do better."};
const Rule print_ill_typed{
    "CSPM-T21", Severity::warning, "this print statement cannot be evaluated: {}",
    "FDR looks at print statements only when it is asked to evaluate them, so a wrong one does not make "
    "the script wrong."};

const Rule bad_pattern{
    "CSPM-T22", Severity::error, "this pattern matches nothing definite: {}",
    "A pattern says of a value in one way what its parts are. `xs ^ ys` would split a sequence anywhere, {x, y} names "
    "elements that have no order, and in a prefix each field is matched once."};
const Rule not_timed{
    "CSPM-T23", Severity::error, "{} is not allowed in a timed section",
    "In a timed section every process lets time pass by the event tock. FDR defines no such reading of linked parallel "
    "and of nondeterministic inputs."};

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
