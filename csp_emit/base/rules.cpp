// SPDX-License-Identifier: Apache-2.0
// The messages of csp_emit's rules. The codes are ours; they do not change once published.
#include "csp_emit/base/rules.hpp"

#include <array>

namespace robochart::csp_emit::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule unsupported{"RC-C01", Severity::error, "{} has no CSP semantics in this tool yet",
                       "The construct is well-formed RoboChart, but the emitter has no rule for it. It is rejected, "
                       "because a script without it would describe another model. Write the behaviour without it."};
const Rule recursive_call{"RC-C02", Severity::error, "operation {} calls itself: {}",
                          "The emitter replaces the call of a defined operation by the machine of the operation, so "
                          "every chain of calls must end."};
const Rule missing_in_caller{
    "RC-C03", Severity::error, "operation {} needs the {} {}, which its caller {} does not have",
    "An operation works on the variables, events and clocks of the machine that calls it. This machine must declare or "
    "require each of them under the same name (rules STM8, STM9, STM10)."};
const Rule reserved_name{"RC-C04", Severity::note, "the name {} has another meaning in CSPM; in the script it is {}",
                         "Events, states and components keep their names in the CSP script, so that csp blocks can use "
                         "them. Keywords of CSPM and functions that the script uses cannot be names of elements, so a "
                         "number is appended to the name. In csp blocks, use the name from the model. A function of "
                         "this name in a block Instantiations defines the function of the model."};
const Rule name_of_another{
    "RC-C09", Severity::note, "another element is called {} in the script, so this one is called {} there",
    "Elements with separate name spaces in RoboChart share one name space in CSPM: a state and an event of its "
    "machine, a function and an event, an event `set_x` and the channel for writes of variable x, an event `opCall` "
    "and the channel for calls of op. A number is appended to the name of the state, of the type or function, or of "
    "the event that would hide such a channel."};
const Rule one_name_for_two{
    "RC-C10", Severity::error, "{} and {} are both called {} in the script",
    "A component is a module of the script. Its name consists of the package and the component, and `::` in the name "
    "of the package becomes `_`. The name of a constant contains the names of everything around it. The script could "
    "not distinguish two elements with the same name. Rename one of them, or check the files separately if they do not "
    "belong together."};
// RC-C05 is no longer used: exits that race with the store of a trigger's value now run in parallel with the store.
const Rule too_many_points{"RC-C06", Severity::error, "{} has more than {}",
                           "During actions of nested states run concurrently, and each combination of their positions "
                           "is a point of the script. This model has too many combinations."};
const Rule instantiations_replaced{
    "RC-C07", Severity::note, "the csp block {} replaces the generated instantiations",
    "As in RoboTool, a block named Instantiations is used instead of the generated carriers, constants and functions. "
    "Definitions that the block omits are generated."};

const Rule constant_without_use{"RC-C08", Severity::warning,
                                "assertion {} sets {}, but no component in this assertion uses it",
                                "A value that an assertion sets applies to the component that declares the constant or "
                                "parameter, and to components that require it from there. Neither side of this "
                                "assertion has such a component, so the assertion is decided without the clause."};
const Rule block_without_process{"RC-C11", Severity::error,
                                 "assertion {0} is about the csp block {1}, which defines no process {1}",
                                 "If an assertion names a csp block, the block must define a process with the name of "
                                 "the block. The block may also define other processes."};
const Rule inputs_hidden{
    "RC-C12", Severity::warning, "assertion {} compares the refusals of {}, but hides inputs there: {}",
    "A hidden event occurs without a sender. A state in which a hidden event is possible is unstable and has no "
    "refusals, so the claim does not restrict this state and may hold although the model is wrong. Hide only calls, "
    "outputs and writes. Leave inputs visible, and let the specification state which inputs it accepts."};
const Rule definition_unread{
    "RC-C13", Severity::warning, "the block Instantiations defines '{}', but the script does not use this name{}",
    "A block Instantiations gives values to carriers, constants and functions by their names in the script. Names that "
    "the block omits have the generated value. A definition of another name has no effect, so if a name is misspelt, "
    "the claims are decided with the generated value."};
const Rule block_of_other_time{
    "RC-C14", Severity::error, "assertion {0} is about the {1} csp block {2}, but not {1} alone",
    "A csp block with `timed` or `untimed` belongs only to that semantics. An assertion without such a word is decided "
    "in both semantics. So use the same word, or none, for the assertion and its blocks."};
const Rule name_of_robotool{"RC-C15", Severity::error,
                            "{} is a name of RoboTool, but this script does not have it: it {}",
                            "csp blocks use the names of the generators of RoboTool from 2024 to 2026. Older "
                            "generators had an event for the return of a call, and one channel for all states that are "
                            "entered. The parts of a machine are not separate processes here."};
const Rule name_of_machine_decides{
    "RC-C17", Severity::note,
    "{0} = {1} does not apply to claims about the controller or a module: there the machine's own name of the constant "
    "decides, {2} = {3}",
    "The constant of a machine has one name for the machine alone, and one for each controller that runs the machine. "
    "In claims about a controller or a module, RoboTool binds the second name to the first. So the first applies if a "
    "block defines both. A csp block that mentions the second name reads the second value."};
const Rule two_values_of_constant{
    "RC-C18", Severity::error, "{0} = {1} and {2} = {3} are two values of one constant; define {4}",
    "The constant of a machine has one name for the machine alone, and one for each controller that runs the machine. "
    "In claims about a controller or a module, RoboTool binds the second name to the first, so in its scripts both "
    "parts have the value of the first. To give one part a separate value, write `with constant c of C::ref set to v` "
    "in the claim."};
const Rule probabilistic_choice{
    "RC-C21", Severity::note, "probabilistic junction {} is treated as a free choice, because CSP has no probabilities",
    "Every transition that leaves the junction may be taken, regardless of its probability. A property of all runs "
    "that holds for this free choice holds for all probabilities. But a claim that something can happen may hold only "
    "because of a transition with probability 0."};

std::span<const Rule* const> all() {
    static constexpr std::array<const Rule*, 17> table{
        &unsupported,         &recursive_call,          &missing_in_caller,       &reserved_name,
        &too_many_points,     &instantiations_replaced, &constant_without_use,    &name_of_another,
        &one_name_for_two,    &block_without_process,   &inputs_hidden,           &definition_unread,
        &block_of_other_time, &name_of_robotool,        &name_of_machine_decides, &two_values_of_constant,
        &probabilistic_choice};
    return table;
}

}  // namespace robochart::csp_emit::rules
