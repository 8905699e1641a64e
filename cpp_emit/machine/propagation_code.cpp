// SPDX-License-Identifier: Apache-2.0
// Writes the functions `prompt` and `holds_up`, which test the places of the threads. The threads of an operation are
// tested where the operation is called.
#include "cpp_emit/machine/propagation_code.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace robochart::cpp_emit {

template <class Test>
bool PropagationCode::any_thread(const Test& test) const {
    return test(control_) ||
           std::ranges::any_of(during_, [&](const DuringThread& during) { return test(during.thread); });
}

bool PropagationCode::has_prompt_steps() const {
    return any_thread([&](const Thread& thread) {
        return !thread.prompt_steps.empty() || std::ranges::any_of(thread.calls, [&](const CallFrame& call) {
            return context_.done.at(call.operation).prompt;
        });
    });
}

void PropagationCode::prompt_function() {
    if (!has_prompt_steps()) return;
    out_.open_declaration("Threads that go on with what writes of others may have to wait for do it.",
                          function_head("void prompt"));
    for (const DuringThread& during : during_) prompt_steps(during.thread);
    prompt_steps(control_);
    out_.close();
}

void PropagationCode::prompt_steps(const Thread& thread) {
    for (const PromptStep& step : thread.prompt_steps) {
        out_.open(fmt::format("if ({}) {{", step.there));
        for (const std::string& line : step.lines) out_.line(line);
        out_.close();
    }
    for (const CallFrame& call : thread.calls)
        if (context_.done.at(call.operation).prompt)
            out_.line(fmt::format("if ({}) {};", MachineContext::in_call(thread, call),
                                  context_.call_inside(call, "prompt")));
}

bool PropagationCode::holds_writes() const {
    return any_thread([&](const Thread& thread) {
        return !thread.holding.empty() || std::ranges::any_of(thread.calls, [&](const CallFrame& call) {
            return context_.done.at(call.operation).holds;
        });
    });
}

/// Writes holds_up for a machine in the variable's list of holders (Component::variables), and for the operations that
/// it calls.
void PropagationCode::holds_up_function() {
    if (!holds_writes()) return;
    out_.open_declaration(
        "A thread waits for a communication with a deadline: meanwhile nothing is propagated to the machine.",
        fmt::format("[[nodiscard]] static bool holds_up(const {}& f) noexcept {{", frame_type()));
    for (const DuringThread& during : during_) write_holding(during.thread);
    write_holding(control_);
    out_.line("return false;");
    out_.close();
}

void PropagationCode::write_holding(const Thread& thread) {
    for (const std::string& label : thread.holding)
        out_.line(fmt::format("if ({} == {}) return true;", thread.variable, thread.qualified_label(label)));
    for (const CallFrame& call : thread.calls)
        if (context_.done.at(call.operation).holds)
            out_.line(fmt::format("if (({}) && holds_up(f.{})) return true;", MachineContext::in_call(thread, call),
                                  call.field));
}

}  // namespace robochart::cpp_emit
