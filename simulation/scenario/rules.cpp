// SPDX-License-Identifier: Apache-2.0
#include "simulation/scenario/rules.hpp"

#include <array>

namespace robochart::simulation::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule syntax{
    "RC-M01", Severity::error, "expected {}, found {}",
    "A scenario is `scenario NAME for COMPONENT { ... }` with a list of items: times, the arena, robots, sensors and "
    "the events that they feed, actuators and the operations that drive them, measures and bands (docs/scenarios.md)."};
const Rule wrong_unit{"RC-M02", Severity::error, "{} takes {}",
                      "Every quantity of a scenario needs a unit, because models and simulators use different units: "
                      "mm, cm, m; ms, s; deg, rad; cm/s, m/s; deg/s, rad/s; %. Counts and seeds have no unit."};
const Rule out_of_range{"RC-M03", Severity::error, "{}",
                        "The value is impossible in a world: examples are a step of length 0, no robots, a wall "
                        "outside the arena, or a share above 100 %."};
const Rule missing{"RC-M04", Severity::error, "the scenario does not state {}",
                   "There are no defaults for items that affect the results. A scenario must state its steps, "
                   "duration, arena, robots and their initial places, and the light for a light sensor."};
const Rule said_twice{
    "RC-M05", Severity::error, "{} is given twice",
    "A name, or an item that may occur only once in a scenario, is given a second time. Remove one of the two."};
const Rule unknown_part{"RC-M06", Severity::error, "there is no {} '{}'",
                        "Refer to sensors, actuators, lights and measures by the names that the scenario gives them. "
                        "docs/scenarios.md lists their kinds and readings."};
const Rule unknown_name{"RC-M07", Severity::error, "'{}' has no {} '{}'",
                        "A scenario can feed an event that the controller receives from its platform, or a shared "
                        "variable that it reads. An actuator can be driven by an operation that the platform provides, "
                        "or by a shared variable that the controller writes."};
const Rule wrong_type{
    "RC-M08", Severity::error, "'{}' carries {}, which {} cannot {}",
    "A reading that is either present or absent feeds an event without a value. A truth value feeds an event of type "
    "boolean, and a measured quantity an event of type real. Reals drive actuators. A stimulus gives an event a "
    "number, a truth value, a literal of its enumeration or a constant of the model. No reading is a literal."};
const Rule no_space{"RC-M09", Severity::error, "{} robots of radius {} cm do not fit in the region",
                    "Robots are placed without overlap. The scenario has no initial state if the robots would cover "
                    "more than two fifths of the region, or if two thousand attempts in a row find no place."};
const Rule no_controller{"RC-M10", Severity::error, "no controller '{}' in {}",
                         "A scenario names the module, controller or state machine that drives each robot. The model "
                         "is in the folder of the scenario, or is the one that `model` names."};
const Rule not_compiled{
    "RC-M11", Severity::error, "the generated controller cannot be built: {}",
    "The compiler of the system (`c++` on PATH) compiles the generated C++, and the program loads the result. Either "
    "the compiler fails, or the program cannot write to the temporary folder or run files in it."};
const Rule stopped{
    "RC-M12", Severity::error, "the controller of {} stopped trial {} at {} s: {}, at {}",
    "A controller is wrong if it does not end its cycle within its bound of steps, calls an operation outside its "
    "precondition, or misses a deadline. The trial ends there, and the message names the element of the model."};
const Rule uneven_steps{
    "RC-M13", Severity::error, "{} is not a whole multiple of {}",
    "A control step consists of whole physics steps, and of whole time units of the model's clocks."};
const Rule not_fed{"RC-M14", Severity::warning, "the scenario never raises the event '{}' of '{}'",
                   "The controller waits for an event that the scenario never raises. Feed the event from a sensor or "
                   "a stimulus, or write `ignore EVENT`."};

const Rule not_there{"RC-M15", Severity::error, "{} has no {}",
                     "The adapter of another simulator may not support everything that a scenario contains. The "
                     "embedded world supports all scenarios."};

const Rule wrong_instant{"RC-M16", Severity::error, "{}",
                         "`way <= 50 cm` is a condition at an instant. `way <= 50 cm within 60 s` and `always ...` are "
                         "conditions about a whole trial. `within`, `until`, `always`, `stays for`, `at` and `first` "
                         "apply to conditions at an instant, and `and` and `or` join two conditions of the same kind. "
                         "Write `(a and b) within 60 s` or `a at end and b within 60 s`."};

const Rule not_in_chain{"RC-M17", Severity::error, "{}",
                        "A chain has only information about its states. It can answer conditions on measures of "
                        "`abstract`, at the levels of these measures, and at times at which the chain has a state: "
                        "`CONDITION within TIME`, `time until CONDITION` and `average MEASURE`."};

const Rule excluded{
    "RC-M18", Severity::error, "trial {} went from '{}' to '{}' at {} s, but the model excludes this",
    "In the timed semantics of the model, no group of robots can make this change of states. Either the generated code "
    "does not conform to the model, or the proof does not cover all behaviour of the code."};

const Rule not_done{"RC-M19", Severity::warning, "the operation '{}' of '{}' does nothing here",
                    "The controller calls an operation that has no effect in the scenario: there is no `drive`, `feed` "
                    "or command of the environment `on` this operation. Add a `drive`, or write `ignore OPERATION`."};

std::span<const Rule* const> all_rules() {
    static constexpr std::array table = {&syntax,        &wrong_unit,   &out_of_range, &missing,  &said_twice,
                                         &unknown_part,  &unknown_name, &wrong_type,   &no_space, &no_controller,
                                         &not_compiled,  &stopped,      &uneven_steps, &not_fed,  &not_there,
                                         &wrong_instant, &not_in_chain, &excluded,     &not_done};
    return table;
}

}  // namespace robochart::simulation::rules
