// SPDX-License-Identifier: Apache-2.0
// The messages of csp_emit's rules. The codes are ours; they do not change once published.
#include "csp_emit/base/rules.hpp"

#include <array>

namespace robochart::csp_emit::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule unsupported{
    "RC-C01", Severity::error, "{} has no CSP semantics here yet",
    "The construct is well-formed RoboChart, but no rule of the emitter covers it. It is refused by name rather than "
    "left out, because a script without it would describe another model. Write the behaviour without it."};
const Rule recursive_call{
    "RC-C02", Severity::error, "operation {} calls itself: {}",
    "The machine of a defined operation is put in the place of its call, so every chain of calls must end."};
const Rule missing_in_caller{
    "RC-C03", Severity::error, "operation {} needs the {} {}, which its caller {} does not have",
    "An operation works on the variables, events and clocks of the machine that calls it; each that it requires must "
    "be declared or required there under the same name (rules STM8, STM9, STM10)."};
const Rule reserved_name{
    "RC-C04", Severity::note, "the name {} means something else in CSPM; in the script it is {}",
    "Events, states and components keep their names in the CSP script, for csp blocks to use. Keywords of CSPM and "
    "functions that the script itself uses cannot be names there: a number is put behind the name. A csp block speaks "
    "of the element by the name that it has in the model; a block Instantiations that defines a function of such a "
    "name defines the model's."};
const Rule name_of_another{
    "RC-C09", Severity::note, "another element is called {} in the script; this one is {} there",
    "What RoboChart keeps apart shares one name space in CSPM: a state and an event of its machine, a function and an "
    "event, an event `set_x` and the channel on which variable x is written, an event `opCall` and the calls of op. "
    "The state, the type or function, or the event that looks like such a channel gets a number behind its name."};
const Rule one_name_for_two{
    "RC-C10", Severity::error, "{} and {} are both called {} in the script",
    "A component is a module of the script under its package's and its own name, `::` of a package's name being `_`; "
    "a constant is called after everything around it. Two elements of one name there would be taken for each other. "
    "Rename one of them, or check the files apart if they do not belong together."};
// RC-C05 is no longer used: exits that race with the store of a trigger's value now run in parallel with the store.
const Rule too_many_points{
    "RC-C06", Severity::error, "{} has more than {}",
    "During actions of nested states run concurrently, and each combination of their positions is a point of the "
    "script. The model multiplies too many of them."};
const Rule instantiations_replaced{
    "RC-C07", Severity::note, "the csp block {} replaces the generated instantiations",
    "A block named Instantiations is used instead of the generated carriers, constants and functions, as RoboTool "
    "does; what it does not define is generated."};

const Rule constant_without_use{
    "RC-C08", Severity::warning, "assertion {} sets {}, which nothing that it is about takes",
    "A constant or parameter that an assertion sets counts for the components that have it: where the value is "
    "declared, or where it is provided to what requires it. Here neither side of the assertion takes it, so the "
    "assertion is decided as if the clause were not there."};
const Rule block_without_process{
    "RC-C11", Severity::error, "assertion {0} is about the csp block {1}, which defines no process {1}",
    "An assertion names a block, and the script has what the block defines: so a block that an assertion names defines "
    "a process of its own name. It may define others beside it."};
const Rule inputs_hidden{
    "RC-C12", Severity::warning, "assertion {} compares what {} refuses, but there inputs are hidden: {}",
    "A hidden event happens by itself, without anybody who sends it. A state that can do one is unstable and refuses "
    "nothing, so the claim demands nothing of it, and may hold where the model is wrong. Hide only calls, outputs and "
    "writes; leave inputs visible, and let the specification say what it thinks of them."};
const Rule definition_unread{
    "RC-C13", Severity::warning, "nothing reads '{}', which the block Instantiations defines{}",
    "A block Instantiations gives values to carriers, constants and functions by the names that they have in the "
    "script. What it leaves out has the generated value. A definition of another name changes nothing, so a misspelt "
    "one lets the claims be decided with the generated value."};
const Rule block_of_other_time{"RC-C14", Severity::error,
                               "assertion {0} is about the {1} csp block {2}, but not {1} alone",
                               "A csp block with `timed` or `untimed` is part of that semantics only. An assertion "
                               "without such a word is decided in "
                               "both, so it and the blocks that it names agree on the word."};
const Rule name_of_robotool{"RC-C15", Severity::error,
                            "{} is a name of RoboTool's that this script does not have: it {}",
                            "The names in csp blocks are those that RoboTool's generators of 2024 to 2026 show. Older "
                            "ones had an event for the "
                            "return of a call and one channel for all states that are entered; what is inside a "
                            "machine is not a process of its "
                            "own here."};
const Rule name_of_machine_decides{
    "RC-C17", Severity::note,
    "{0} = {1} does not count in claims about the controller or a module: there the machine's own name of the constant "
    "decides, {2} = {3}",
    "A machine's constant has a name for the machine alone and one for each controller that runs it. In claims about a "
    "controller or a module RoboTool binds the second to the first, so the first counts where a block defines both. "
    "The "
    "second is what a csp block that mentions it reads."};
const Rule two_values_of_constant{
    "RC-C18", Severity::error, "{0} = {1} and {2} = {3} are two values of one constant; define {4}",
    "A machine's constant has a name for the machine alone and one for each controller that runs it. In claims about a "
    "controller or a module RoboTool binds the second to the first, so in its scripts both parts have the value of the "
    "first. A claim gives one part a value of its own with `with constant c of C::ref set to v`."};
const Rule probabilistic_choice{
    "RC-C21", Severity::note, "probabilistic junction {} counts as a free choice: CSP has no probabilities",
    "Every transition that leaves the junction may be taken, whatever its probability, as at a junction whose "
    "conditions all hold. What holds of the free choice holds of every probabilistic one; a claim that something can "
    "happen may rest on a transition of probability 0."};

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
