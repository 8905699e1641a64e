// SPDX-License-Identifier: Apache-2.0
// Texts of the rules of the semantics. Codes are ours; they do not change once published.
#include "semantics/rules.hpp"

#include <array>

namespace robochart::ir::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule unsupported_construct{
    "RC-S01", Severity::error, "{} is not supported yet",
    "The construct is well-formed RoboChart, but the semantics in this tool has no rule for it. It is rejected, "
    "because a model without it would have another behaviour. Write the behaviour without it."};
const Rule recursive_operation{"RC-S02", Severity::error,
                               "operation {} calls itself: {}; recursive operations are not supported yet",
                               "RoboTool bounds the depth of recursive calls by a constant of the instantiation. In "
                               "this tool, every chain of calls must end. Example of a rejected chain: the body of "
                               "`walk` calls `turn`, and the body of `turn` calls `walk`."};
const Rule number_too_large{"RC-S03", Severity::error, "the number {} does not fit into 64 bits",
                            "Numbers of a model are stored exactly: whole numbers from -(2^63) to 2^63-1, and decimal "
                            "numbers with at most 18 decimal places."};
const Rule too_deep{
    "RC-S04", Severity::error, "{} are nested deeper than {} levels",
    "The nesting of expressions, statements, types and states is limited. No readable model comes near the limit."};
const Rule unresolved{"RC-S05", Severity::error, "{} does not lead to a declaration",
                      "Name resolution found no declaration for this name, so the element that uses it has no meaning. "
                      "Fix the errors that are reported before this one."};
// RC-S06 to RC-S08 are no longer used, because name resolution finds the components of assertions (RC-Q01 to RC-Q05).
const Rule unknown_constant_option{"RC-S10", Severity::error, "--const {}: the model has no constant of this name{}",
                                   "Use the name of a constant, which sets all constants with this name, or the path "
                                   "of one constant: `--const stm::limit=3`."};
const Rule bad_constant_value{"RC-S11", Severity::error, "--const {}: '{}' is not a value of type {}",
                              "Values are RoboChart literals: 3, -1, 0.25, true, red or Colour::red. Decimal numbers "
                              "need type real, and nat has no negative numbers."};
const Rule unknown_range_option{"RC-S12", Severity::error,
                                "--range {}: only nat, int, real, Seq, clock and given have a range{}",
                                "`--range nat=0..4` sets the numbers that the type contains during the check, `--range "
                                "Seq=0..3` the lengths of sequences, `--range clock=0..20` the greatest value of "
                                "clocks, and `--range given=0..2` the number of elements of every given type."};
const Rule bad_range{"RC-S13", Severity::error, "--range {}={}..{}: {}",
                     "A range extends from its least to its greatest number. nat starts at 0 or above. Every type must "
                     "contain 0, because variables start there. Lengths of sequences, clocks and elements of given "
                     "types are counted from 0, and clocks must reach the numbers with which the model compares them."};
const Rule ranges_not_nested{
    "RC-S14", Severity::error,
    "--range {0}={1}..{2} must contain all of {3} ({4}..{5}), because a {6} may be used as {7}",
    "A nat can be used as an int, and an int as a real. So each of these ranges must contain the previous one. Ranges "
    "without an option are extended automatically."};
const Rule range_too_large{"RC-S15", Severity::error,
                           "type {} would have {} values, more than {}; narrow it with --range {}=LOW..HIGH",
                           "The check explores every value of an input. The range of a type covers the numbers that "
                           "the model compares and assigns. If the model has large numbers, choose a smaller range."};
const Rule scale_too_large{
    "RC-S16", Severity::error,
    "the decimal numbers of the model need a scale above 10^18, or values beyond 64 bits at scale {}",
    "Reals are stored exactly, as whole numbers of units 1/scale. The scale is the smallest power of ten that makes "
    "every decimal number of the model whole."};
const Rule literal_outside_range{"RC-S17", Severity::warning, "{} is outside the range {}..{} chosen for {}",
                                 "Comparisons with the number keep their meaning, but no variable can hold it. "
                                 "Arithmetic with a result outside the range gives its first operand, as in RoboTool."};
const Rule function_without_definition{
    "RC-S18", Severity::warning,
    "function {} has no definition, so it is treated as a constant (0, true or the first literal) unless a csp block "
    "defines it",
    "RoboChart functions are specified by preconditions and postconditions, which do not determine how to compute a "
    "result. RoboTool treats such a function as a constant until it is defined in CSPM, and so does this tool. Only "
    "its precondition applies."};
const Rule function_by_contract{
    "RC-S20", Severity::note,
    "function {} is computed from its postcondition, by search over the values of its result type, unless a csp block "
    "defines it",
    "The result is the default value of the type (0, true, the first literal) if this satisfies the postcondition, as "
    "in RoboTool for every function without a definition. Otherwise it is the least value that satisfies the "
    "postcondition. If there is no such value, a check that evaluates the call is inconclusive."};
const Rule no_beginning{"RC-S21", Severity::error,
                        "{} {} has {} initial junctions, so its initial state is not defined",
                        "A composite state and an operation with nodes begin at their only initial junction. "
                        "RoboChart's rule STM3 is only a warning for them. But without exactly one initial junction, "
                        "there is no meaning to check and no code to generate."};
const Rule declared_twice{"RC-S22", Severity::error, "{} has two {}s called {}",
                          "If two declarations of the same kind share a name, a reference means the first (RC-N03 "
                          "warns). Semantics and code identify members, literals, fields, parameters and bound "
                          "variables by their names, so they reject the duplicate. Rename one of the two."};
const Rule no_literals{
    "RC-S23", Severity::error, "enumeration {} has no literals, so it has no values",
    "A variable, an event or a parameter of such a type has no initial value and no value to communicate, so the model "
    "has no behaviour. Give the enumeration a literal, or make it a given type: `type T`."};
const Rule ambiguous_constant{
    "RC-S19", Severity::error,
    "operation {} requires constant {}, which its callers in {} provide with different values: {}",
    "A constant that an operation requires is the constant with the same name in its caller. If callers have different "
    "values, the operation would need one process for each of them. Use a parameter instead."};

const Rule constant_named_twice{
    "RC-S24", Severity::error, "--const {} and --const {} both name the constant {}",
    "A constant has one value. A name means all constants with this name, and the end of a path means all constants "
    "whose paths end with it. Remove one of the two options, or use paths that name different constants."};

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
