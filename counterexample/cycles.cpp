// SPDX-License-Identifier: Apache-2.0
// Divides a run into cycles. A cycle begins with the first step after time has passed that reads a register, writes an
// output or ends the execution. Between the time units of one cycle, a component has only internal steps.
#include "counterexample/cycles.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "counterexample/text.hpp"

namespace robochart::runs {

namespace {

bool is_of_cycles(const Step& step) {
    return step.event.kind == Kind::read || step.event.kind == Kind::empty_read || step.event.kind == Kind::cycle_end;
}

bool is_write(const Step& step) {
    if (step.hidden) return false;
    return step.event.kind == Kind::output || step.event.kind == Kind::call || step.event.kind == Kind::assignment;
}

/// Returns the text of an event without its first word, which is its kind: "lit(true)".
std::string without_kind(const std::string& text) {
    return text.substr(text.find(' ') + 1);
}

std::vector<std::string> states_of(const std::vector<Machine>& machines) {
    std::vector<std::string> result;
    for (const Machine& machine : machines) result.push_back(text_of(machine));
    return result;
}

}  // namespace

std::vector<RunCycle> cycles_of(const Run& run) {
    std::vector<RunCycle> result;
    if (std::ranges::none_of(run.steps, is_of_cycles)) return result;
    bool passed = true;  // whether time has passed since the last step of a cycle
    for (const Step& step : run.steps) {
        if (step.event.kind == Kind::tock) {
            passed = true;
            continue;
        }
        if (passed && !is_of_cycles(step) && !is_write(step)) continue;
        if (passed) {
            result.emplace_back().time = step.time.value_or(0);
            passed = false;
        }
        RunCycle& cycle = result.back();
        if (step.event.kind == Kind::read && !step.hidden) cycle.inputs.push_back(without_kind(step.event.text));
        if (is_write(step)) cycle.outputs.push_back(without_kind(step.event.text));
        cycle.states = states_of(step.machines);
    }
    return result;
}

std::string text_of(const RunCycle& cycle) {
    return fmt::format("in {{{}}}  out <{}>  {}", fmt::join(cycle.inputs, ", "), fmt::join(cycle.outputs, ", "),
                       fmt::join(cycle.states, "; "));
}

}  // namespace robochart::runs
