// SPDX-License-Identifier: Apache-2.0
// Texts of the rules of the semantics. Codes are ours; they do not change once published.
#include "semantics/rules.hpp"

#include <array>

namespace robochart::ir::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule unsupported_construct{
    "RC-S01", Severity::error, "{} is not supported yet",
    "The construct is well-formed RoboChart, but the semantics here has no rule for it. It is refused rather than "
    "left out, because leaving it out would change what is verified. Write the behaviour without it."};
const Rule recursive_operation{
    "RC-S02", Severity::error, "operation {} calls itself: {}; recursive operations are not supported yet",
    "RoboTool bounds the depth of recursive calls by a constant of the instantiation. Here every chain of calls must "
    "end. Example of a refused chain: the body of `walk` calls `turn`, and the body of `turn` calls `walk`."};
const Rule number_too_large{
    "RC-S03", Severity::error, "the number {} does not fit into 64 bits",
    "Numbers of a model are kept exactly: whole numbers within -(2^63)..2^63-1, decimals as a whole number and at most "
    "18 decimal places."};
const Rule too_deep{
    "RC-S04", Severity::error, "{} nested deeper than {} levels",
    "Expressions, statements, types and states may be nested up to a fixed depth; no readable model comes near it."};
const Rule unresolved{
    "RC-S05", Severity::error, "{} does not lead to a declaration",
    "A name that name resolution should have followed was left open, so the element that uses it has no meaning. "
    "Fix the errors reported before this one."};
// RC-S06 to RC-S08 are no longer used, because name resolution finds the components of assertions (RC-Q01 to RC-Q05).
const Rule unknown_constant_option{
    "RC-S10", Severity::error, "--const {}: the model has no constant of this name{}",
    "Name a constant by its own name, which sets all constants of that name, or by its path: `--const stm::limit=3`."};
const Rule bad_constant_value{
    "RC-S11", Severity::error, "--const {}: '{}' is not a value of type {}",
    "Values are RoboChart literals: 3, -1, 0.25, true, red or Colour::red. Decimals need type real; nat has no "
    "negative numbers."};
const Rule unknown_range_option{
    "RC-S12", Severity::error, "--range {}: only nat, int, real, Seq, clock and given have a range{}",
    "`--range nat=0..4` says which numbers the type holds while the model is checked, `--range Seq=0..3` how long "
    "sequences are, `--range clock=0..20` how far clocks count, `--range given=0..2` how many elements every given "
    "type "
    "has."};
const Rule bad_range{
    "RC-S13", Severity::error, "--range {}={}..{}: {}",
    "A range runs from its least to its greatest number; nat starts at 0 or above; every type must hold 0, where "
    "variables start. Lengths of sequences, clocks and elements of given types are counted from 0, and clocks as far "
    "as "
    "the model compares them."};
const Rule ranges_not_nested{"RC-S14", Severity::error,
                             "--range {}={}..{}: must hold all of {} ({}..{}), because a {} may be used as {}",
                             "nat is usable as int and int as real, so the numbers of each must be numbers of the "
                             "next. Ranges without an option "
                             "are widened by themselves."};
const Rule range_too_large{
    "RC-S15", Severity::error, "type {} would have {} values, more than {}; narrow it with --range {}=LOW..HIGH",
    "Checking explores every value of an input. The range of a type covers the numbers that the model compares and "
    "assigns; a model with large numbers needs a range that is chosen."};
const Rule scale_too_large{
    "RC-S16", Severity::error,
    "the model's decimal numbers need a scale above 10^18 or values beyond 64 bits at scale {}",
    "Reals are kept exactly as whole numbers of units 1/scale, where the scale is the smallest power of ten that makes "
    "every decimal number of the model whole."};
const Rule literal_outside_range{
    "RC-S17", Severity::warning, "{} lies outside the range {}..{} chosen for {}",
    "Comparisons with the number still mean what they say, but no variable can hold it, and arithmetic that reaches it "
    "leaves its first operand as it is (RoboTool's rule for results outside the type)."};
const Rule function_without_definition{
    "RC-S18", Severity::warning,
    "function {} has no definition: it counts as a constant (0, true or the first literal) unless a csp block defines "
    "it",
    "RoboChart functions are specified by pre- and postconditions, which do not say how to compute a result. RoboTool "
    "takes such a function as a constant until it is defined in CSPM, and so does this tool; only its "
    "precondition "
    "counts."};
const Rule function_by_contract{
    "RC-S20", Severity::note,
    "function {} is computed from its postcondition, by search over the values of its result type, unless a csp block "
    "defines it",
    "The result is the default value of the type (0, true, the first literal) where that satisfies the postcondition, "
    "as "
    "RoboTool has it for every function without a definition; else the least value that does. A call for which no "
    "value does has no meaning: a check that meets it is inconclusive."};
const Rule no_beginning{
    "RC-S21", Severity::error, "{} {} has {} initial junctions, so nothing says where it begins",
    "A composite state and an operation with nodes begin at their only initial junction. RoboChart's rule STM3 is a "
    "warning for them; but without exactly one there is no meaning to check and no code to generate."};
const Rule declared_twice{
    "RC-S22", Severity::error, "{} has two {}s called {}",
    "Where two declarations of one kind share a name, a reference means the first (RC-N03 warns). Semantics and code "
    "know members, literals, fields, parameters and what an expression binds by their names, so they refuse it. Rename "
    "one of the two."};
const Rule no_literals{
    "RC-S23", Severity::error, "enumeration {} has no literals, so nothing can have a value of it",
    "A variable, an event or a parameter of an enumeration without literals has no value that it could begin with or "
    "communicate, so the model has no behaviour. Give the enumeration a literal, or make it a given type: `type T`."};
const Rule ambiguous_constant{
    "RC-S19", Severity::error,
    "operation {} requires constant {}, which its callers in {} provide with different values: {}",
    "A constant that an operation requires is its caller's constant of that name. Where callers have constants of "
    "their own, the operation would need one process for each; give it a parameter instead."};

const Rule constant_named_twice{
    "RC-S24", Severity::error, "--const {} and --const {} both name the constant {}",
    "A constant has one value. Its own name means all constants of that name, the end of a path those whose paths end "
    "so: keep one of the two, or name each constant by a path that means no other."};

namespace {
const std::array<const Rule*, 20> table{&unsupported_construct,
                                        &recursive_operation,
                                        &number_too_large,
                                        &too_deep,
                                        &unresolved,
                                        &unknown_constant_option,
                                        &bad_constant_value,
                                        &unknown_range_option,
                                        &bad_range,
                                        &ranges_not_nested,
                                        &range_too_large,
                                        &scale_too_large,
                                        &literal_outside_range,
                                        &function_without_definition,
                                        &ambiguous_constant,
                                        &function_by_contract,
                                        &no_beginning,
                                        &declared_twice,
                                        &no_literals,
                                        &constant_named_twice};
}  // namespace

std::span<const Rule* const> all() {
    return table;
}

}  // namespace robochart::ir::rules
