// SPDX-License-Identifier: Apache-2.0
#include "conformance/model/rules.hpp"

#include <array>

namespace robochart::conformance::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule log_syntax{
    "RC-L01", Severity::error, "expected {}, found {}",
    "A log of runs begins with `robochart-trace 1` and a header. Runs follow: `run NAME`, and for each cycle the "
    "inputs (`seeRobot?`), the outputs (`Move!0.5`), and a `tock` for every time unit (docs/traces.md)."};
const Rule log_name{
    "RC-L02", Severity::error, "{} has no {} '{}'; it has {}",
    "A log uses the names of the model for the inputs of the component (events that it receives, variables that others "
    "write) and for its outputs (operations that it calls, events that it sends, variables that it writes)."};
const Rule log_value{
    "RC-L03", Severity::error, "{} carries {}, found {}",
    "An event without a value is written `e?` or `e!`, an event with a value `e?v` or `e!v`. An operation has a `!v` "
    "for each parameter. Numbers are decimal, truth values are `true` and `false`, literals of enumerations are "
    "written by name, and values with parts as `(1,true)`, `<1,2>` or `{Red,Green}`."};
const Rule log_of_other{"RC-L04", Severity::error, "the log is about {}, but the model is read as {}",
                        "A log names its component, the number of time units of a control cycle, and the constants of "
                        "the model. It is compared with this component, in cycles of this length, with these "
                        "constants. The options `--component`, `--cycle` and `--const` override them."};

const Rule endless_steps{"RC-K01", Severity::error, "{}",
                         "The model takes infinitely many steps while no time passes, so the control cycle never ends: "
                         "the robot would hang."};
const Rule endless_outputs{"RC-K02", Severity::error, "{}",
                           "The model makes infinitely many outputs while no time passes, so the control cycle never "
                           "ends: the robot would hang."};
const Rule time_stops{"RC-K03", Severity::error, "{}",
                      "The model can take no further step, and time cannot pass, because a deadline has expired. No "
                      "input can change this. A robot cannot stop time, so no code can behave like this model."};
const Rule output_in_mid_cycle{"RC-K04", Severity::error, "{}",
                               "The model must make an output between the ticks of one control cycle, but a robot acts "
                               "only at the beginning of its cycles."};
const Rule end_in_mid_cycle{"RC-K05", Severity::error, "{}",
                            "The model terminates between the ticks of one control cycle, but a robot acts only at the "
                            "beginning of its cycles."};
const Rule input_in_mid_cycle{"RC-K06", Severity::error, "{}",
                              "The model needs an input between the ticks of one control cycle, but a robot reads its "
                              "inputs only at the beginning of its cycles."};
const Rule output_made_twice{
    "RC-K07", Severity::note, "{}",
    "If the outputs of a robot are registers that are read once in a cycle, only the last of these values takes "
    "effect, and the others are lost. If each output is a call, as in generated code, all values take effect."};
const Rule input_not_in_time{
    "RC-K08", Severity::note, "{}",
    "If the input is late, the generated code reports `StepResult::deadline`, and its further behaviour is not "
    "specified. The robot must provide the input in time, or stop at this report."};

const Rule event_missed{"RC-K09", Severity::note, "{}",
                        "An event that is raised in such a cycle is lost: the controller reads it, no transition takes "
                        "it, and it is discarded at the end of the cycle."};

const Rule event_overtaken{"RC-K10", Severity::note, "{}",
                           "If several transitions are enabled in one cycle, transitions of inner states are taken "
                           "before those of the enclosing states, including transitions that depend only on time or "
                           "conditions. An outer state reacts to the event afterwards."};

const Rule precondition_false{
    "RC-K11", Severity::error, "{}",
    "The model calls an operation whose precondition is false, and stops at this call. Generated code ends the cycle "
    "there with `StepResult::precondition`. The model is wrong, not its code."};

std::span<const Rule* const> all() {
    static constexpr std::array table = {
        &log_syntax,        &log_name,          &log_value,           &log_of_other,     &endless_steps,
        &endless_outputs,   &time_stops,        &output_in_mid_cycle, &end_in_mid_cycle, &input_in_mid_cycle,
        &output_made_twice, &input_not_in_time, &event_missed,        &event_overtaken,  &precondition_false};
    return table;
}

}  // namespace robochart::conformance::rules
