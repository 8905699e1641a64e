// SPDX-License-Identifier: Apache-2.0
#include "conformance/model/rules.hpp"

#include <array>

namespace robochart::conformance::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule log_syntax{"RC-L01", Severity::error, "expected {}, found {}",
                      "A log of runs begins with `robochart-trace 1`, a header, and then runs: `run NAME`, and in each "
                      "cycle what was read "
                      "(`seeRobot?`), what was written (`Move!0.5`), and `tock` for every time unit (docs/traces.md)."};
const Rule log_name{"RC-L02", Severity::error, "{} has no {} '{}'; it has {}",
                    "A log speaks of the component's inputs (events it receives, variables written from outside) and "
                    "outputs (operations "
                    "it calls, events it sends, variables it writes) by their names in the model."};
const Rule log_value{
    "RC-L03", Severity::error, "{} carries {}, found {}",
    "An event without value is `e?` or `e!`, one with a value `e?v` or `e!v`; an operation has a `!v` for each "
    "parameter. Numbers are decimal, truth values `true` and `false`, literals of enumerations by their names, values "
    "with parts `(1,true)`, `<1,2>`, `{Red,Green}`."};
const Rule log_of_other{
    "RC-L04", Severity::error, "the log is of {}, the model is read as {}",
    "A log says which component it comes from, how many time units a control cycle has, and which constants the model "
    "had. It is compared with that component of the model, in cycles of that length, with these constants "
    "(`--component`, `--cycle`, `--const` are stronger)."};

const Rule endless_steps{"RC-K01", Severity::error, "{}",
                         "The model does infinitely many steps while no time passes, so the control cycle never ends: "
                         "the robot would hang."};
const Rule endless_outputs{"RC-K02", Severity::error, "{}",
                           "The model makes outputs without end while no time passes, so the control cycle never ends: "
                           "the robot would hang."};
const Rule time_stops{"RC-K03", Severity::error, "{}",
                      "The model can do nothing more and does not let time pass: a deadline is over, and no input can "
                      "put that right. A robot cannot stop time."};
const Rule output_in_mid_cycle{
    "RC-K04", Severity::error, "{}",
    "The model must make an output between the ticks of one control cycle, but a robot acts at the beginning of its "
    "cycles only."};
const Rule end_in_mid_cycle{"RC-K05", Severity::error, "{}",
                            "The model terminates between the ticks of one control cycle, but a robot acts at the "
                            "beginning of its cycles only."};
const Rule input_in_mid_cycle{
    "RC-K06", Severity::error, "{}",
    "The model needs an input between the ticks of one control cycle, but a robot reads its inputs at the beginning of "
    "its cycles only."};
const Rule output_made_twice{
    "RC-K07", Severity::note, "{}",
    "A robot that takes its outputs from registers once in a cycle sees the last of these values only: the others are "
    "lost. A robot on which each output is a call, as in generated code, sees all of them."};
const Rule input_not_in_time{
    "RC-K08", Severity::note, "{}",
    "If the input does not come in time, the generated code reports `StepResult::deadline`, and what it does then is "
    "not specified: the robot must provide the input in time, or stop at that report."};

const Rule event_missed{"RC-K09", Severity::note, "{}",
                        "An event that is raised in such a cycle is lost: the controller reads it, nothing takes it, "
                        "and it is forgotten at the end of the cycle."};

const Rule event_overtaken{"RC-K10", Severity::note, "{}",
                           "Where several transitions are enabled in one cycle, those of inner states go first, those "
                           "of timeouts and conditions too. What an outer state does at the event comes after them."};

const Rule precondition_false{"RC-K11", Severity::error, "{}",
                              "The model calls an operation whose precondition is false. It stops at this call, and "
                              "generated code ends the cycle there with `StepResult::precondition`: the model is "
                              "wrong, not its code."};

std::span<const Rule* const> all() {
    static constexpr std::array table = {
        &log_syntax,        &log_name,          &log_value,           &log_of_other,     &endless_steps,
        &endless_outputs,   &time_stops,        &output_in_mid_cycle, &end_in_mid_cycle, &input_in_mid_cycle,
        &output_made_twice, &input_not_in_time, &event_missed,        &event_overtaken,  &precondition_false};
    return table;
}

}  // namespace robochart::conformance::rules
