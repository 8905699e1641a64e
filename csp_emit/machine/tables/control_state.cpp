// SPDX-License-Identifier: Apache-2.0
// Traverses and reconstructs configurations.
#include "csp_emit/machine/tables/control_state.hpp"

#include <algorithm>

namespace robochart::csp_emit {
namespace {

void add_key(const Activation& activation, std::string& out);

void add_key(const Item& item, std::string& out) {
    out += std::to_string(static_cast<int>(item.kind)) + ":";
    if (item.stmt != nullptr) out += std::to_string(item.stmt->point);
    out += ":" + std::to_string(item.node.index) + ":" + std::to_string(item.variable.index);
    for (const CellId cell : item.cells) out += "," + std::to_string(cell);
}

void add_key(const Thread& thread, std::string& out) {
    out += "[";
    if (thread.callee) add_key(*thread.callee, out);
    for (const Link* link = thread.rest.get(); link != nullptr; link = link->tail.get()) {
        add_key(link->head, out);
        out += ";";
    }
    out += "]";
}

void add_key(const Activation& activation, std::string& out) {
    out += std::to_string(activation.frame) + "@" + std::to_string(activation.at.index) + "(";
    for (const ir::NodeId node : activation.entered) out += std::to_string(node.index) + " ";
    out += ")";
    add_key(activation.control, out);
    for (const During& during : activation.durings) {
        out += "|" + std::to_string(during.node.index);
        add_key(during.thread, out);
    }
    if (activation.clocks_read > 0) out += "#" + std::to_string(activation.clocks_read);
}

constexpr std::size_t control_thread = 0;

const Thread& thread_of(const Activation& activation, std::size_t number) {
    return number == control_thread ? activation.control : activation.durings[number - 1].thread;
}

Activation with_thread(const Activation& activation, std::size_t number, Thread changed) {
    Activation result = activation;
    if (number == control_thread) {
        result.control = std::move(changed);
        return result;
    }
    const auto during = result.durings.begin() + static_cast<std::ptrdiff_t>(number - 1);
    if (changed.is_done())
        result.durings.erase(during);
    else
        during->thread = std::move(changed);
    return result;
}

/// Collects the running machines and threads. `during` is true if the machine runs inside a during action, so that
/// other threads and transitions may act between any two of its steps.
void collect_running(const std::shared_ptr<const RunningMachine>& machine, bool during, View& view) {
    view.machines.push_back(*machine);
    for (std::size_t number = 0; number <= machine->activation->durings.size(); ++number) {
        const RunningThread running{machine, number, during || number != control_thread};
        const Thread& thread = running.thread();
        if (thread.is_done()) continue;
        (thread.callee ? view.calls : view.threads).push_back(running);
        if (thread.callee)
            collect_running(
                std::make_shared<const RunningMachine>(RunningMachine{thread.callee.get(), machine, number}),
                running.during, view);
    }
}

}  // namespace

Program push_item(Item head, Program tail) {
    return std::make_shared<const Link>(Link{std::move(head), std::move(tail)});
}

Program program_of(const std::vector<Item>& items) {
    Program program;
    for (auto item = items.rbegin(); item != items.rend(); ++item) program = push_item(*item, program);
    return program;
}

bool is_settled(const Activation& activation) {
    return activation.control.is_done() && activation.at.is_valid();
}

std::string activation_key(const Activation& activation) {
    std::string result;
    add_key(activation, result);
    return result;
}

Activation RunningMachine::replace(Activation changed) const {
    if (!caller) return changed;
    const Thread& calling = thread_of(*caller->activation, thread);
    Thread after{calling.rest, std::make_shared<const Activation>(std::move(changed))};
    return caller->replace(with_thread(*caller->activation, thread, std::move(after)));
}

const Thread& RunningThread::thread() const {
    return thread_of(owner(), number);
}

Activation RunningThread::replace(Thread changed) const {
    return machine->replace(with_thread(owner(), number, std::move(changed)));
}

View view_of(const Activation& config) {
    View result;
    collect_running(std::make_shared<const RunningMachine>(RunningMachine{&config, nullptr, 0}), false, result);
    return result;
}

const Item* running_item(const Activation& activation) {
    const Thread& thread = innermost_activation(activation).control;
    return thread.rest ? &thread.rest->head : nullptr;
}

const Activation& innermost_activation(const Activation& activation) {
    return activation.control.callee ? innermost_activation(*activation.control.callee) : activation;
}

}  // namespace robochart::csp_emit
