// SPDX-License-Identifier: Apache-2.0
#include "simulation/scenario/rules.hpp"

#include <array>

namespace robochart::simulation::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule syntax{
    "RC-M01", Severity::error, "expected {}, found {}",
    "A scenario is `scenario NAME for COMPONENT { ... }` with one item after the other: times, the arena, "
    "robots, sensors and what they feed, actuators and what drives them, measures and bands "
    "(docs/scenarios.md)."};
const Rule wrong_unit{
    "RC-M02", Severity::error, "{} takes {}",
    "Every quantity of a scenario has a unit, because models and simulators use different ones: mm, cm, m; ms, "
    "s; deg, rad; cm/s, m/s; deg/s, rad/s; %. Counts and seeds have none."};
const Rule out_of_range{
    "RC-M03", Severity::error, "{}",
    "A quantity that no world can have: a step of no length, no robots, a wall outside the arena, a share "
    "beyond 100 %."};
const Rule missing{
    "RC-M04", Severity::error, "the scenario does not say {}",
    "Nothing is assumed that changes results: the scenario states its steps, duration, arena, robots and where "
    "they are placed; a light sensor its light."};
const Rule said_twice{
    "RC-M05", Severity::error, "{} is said twice",
    "An item that stands once for the whole scenario, or a name, is given a second time; which one is meant "
    "cannot be known."};
const Rule unknown_part{
    "RC-M06", Severity::error, "there is no {} '{}'",
    "Sensors, actuators, lights and measures are known by the names that the scenario gives them; their kinds "
    "and readings are listed in docs/scenarios.md."};
const Rule unknown_name{
    "RC-M07", Severity::error, "'{}' has no {} '{}'",
    "What a scenario feeds must be an event that the controller receives from its platform (or a shared "
    "variable that it reads), and what drives an actuator an operation that the platform provides or a shared "
    "variable that the controller writes."};
const Rule wrong_type{
    "RC-M08", Severity::error, "'{}' carries {}, which {} cannot {}",
    "A reading that is there or not feeds an event without value, a truth value an event of type boolean, a "
    "measured quantity an event of type real; an actuator is driven by reals. A stimulus gives an event a number, a "
    "truth value, a literal of its enumeration or a constant of the model; no reading is a literal."};
const Rule no_space{
    "RC-M09", Severity::error, "{} robots of radius {} cm do not fit in the region",
    "Robots are placed without overlap. Where they would cover more than two fifths of the region, or two "
    "thousand throws in a row find no place, the scenario has no start."};
const Rule no_controller{
    "RC-M10", Severity::error, "no controller '{}' in {}",
    "A scenario names the module, controller or state machine that drives each robot, of the model in its "
    "own folder, or of the one that `model` names."};
const Rule not_compiled{
    "RC-M11", Severity::error, "the generated controller cannot be built: {}",
    "Generated C++ is compiled by the system's compiler (`c++` on PATH) and loaded. Either the compiler "
    "fails, or the temporary folder cannot be written or run from."};
const Rule stopped{
    "RC-M12", Severity::error, "the controller of {} stopped trial {} at {} s: {}, at {}",
    "A controller that does not end its cycle within its bound of steps repeats without time passing; one that "
    "calls an operation outside its precondition, or misses a deadline, is wrong too. The trial ends there, at the "
    "element of the model that is named."};
const Rule uneven_steps{
    "RC-M13", Severity::error, "{} is no whole multiple of {}",
    "A control step consists of whole physics steps, and of whole time units of the model's clocks."};
const Rule not_fed{
    "RC-M14", Severity::warning, "nothing feeds the event '{}' of '{}'",
    "The controller waits for an event that the scenario never raises. Feed it from a sensor or a stimulus, "
    "or write `ignore EVENT`."};

const Rule not_there{
    "RC-M15", Severity::error, "{} has no {}",
    "A scenario may ask for more than another simulator offers through its adapter. The embedded world has "
    "everything that scenarios can say."};

const Rule wrong_instant{
    "RC-M16", Severity::error, "{}",
    "`way <= 50 cm` holds or not at an instant; `way <= 50 cm within 60 s` and `always ...` hold or not of a whole "
    "trial. "
    "`within`, `until`, `always`, `stays for`, `at` and `first` are about conditions at an instant, and `and` and `or` "
    "join "
    "two of one kind: `(a and b) within 60 s` and `a at end and b within 60 s` say which is meant."};

const Rule not_in_chain{
    "RC-M17", Severity::error, "{}",
    "A chain answers from its states alone: conditions on measures that `abstract` tells apart, at its levels, at "
    "times "
    "at which it has a state; `CONDITION within TIME`, `time until CONDITION` and `average MEASURE`."};

const Rule excluded{
    "RC-M18", Severity::error, "trial {} went from '{}' to '{}' at {} s, which the model excludes",
    "By the timed semantics of the model no robots can do that between two states of the chain. The generated "
    "code then does not conform, or the proof is about less than what the code does."};

const Rule not_done{"RC-M19", Severity::warning, "the operation '{}' of '{}' does nothing here",
                    "The controller calls an operation, and nothing in the scenario answers: no `drive`, no `feed` and "
                    "no command of the "
                    "environment is `on` it. Add a `drive`, or write `ignore OPERATION`."};

std::span<const Rule* const> all_rules() {
    static constexpr std::array table = {&syntax,        &wrong_unit,   &out_of_range, &missing,  &said_twice,
                                         &unknown_part,  &unknown_name, &wrong_type,   &no_space, &no_controller,
                                         &not_compiled,  &stopped,      &uneven_steps, &not_fed,  &not_there,
                                         &wrong_instant, &not_in_chain, &excluded,     &not_done};
    return table;
}

}  // namespace robochart::simulation::rules
