// SPDX-License-Identifier: Apache-2.0
#include "csp_emit/machine/rules/cycles.hpp"

#include <algorithm>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/base/registers.hpp"
#include "csp_emit/machine/rules/actions.hpp"
#include "csp_emit/machine/rules/shared_variables.hpp"
#include "csp_emit/machine/rules/states.hpp"
#include "csp_emit/machine/rules/time.hpp"
#include "csp_emit/machine/rules/transitions.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;

namespace {

Program waiting_for_cycle(const std::string& label, const Program& rest) {
    Item item;
    item.kind = ItemKind::resume;
    item.label = label;
    return push_item(item, rest);
}

/// True if the machine waits for the next cycle in its final state.
bool waits_at_end(const MachineTables& tables, const Activation& config) {
    if (!config.at.is_valid()) return false;
    const ir::Node& node = tables.machine().nodes[config.at.index];
    return node.kind == ir::NodeKind::final && !node.parent.is_valid();
}

/// Returns the branch `registerRead.i_e?b?v`, after which the register has these contents.
Branch read_register(const MachineTables& tables, const Activation& config, const ir::Input& input) {
    const auto& cells = tables.frames.root_frame().variables;
    std::vector<cspm::Field> fields;
    Values values;
    const auto receive = [&](ir::VariableId variable, const char* name) {
        if (!variable.is_valid()) return;
        fields.push_back(b::input(name));
        values[cells.at(variable.index)] = b::name(name);
    };
    receive(input.full, "full__");
    receive(input.content, "in__");
    return {nullptr, register_read("i_" + input.name), std::move(fields), next_configuration(config, values)};
}

void add_reads(const MachineTables& tables, const Activation& config, std::vector<Branch>& result) {
    std::vector<std::string> seen;
    for (const ir::Input& input : tables.machine().inputs) {
        if (std::ranges::find(seen, input.name) != seen.end()) continue;
        seen.push_back(input.name);
        result.push_back(read_register(tables, config, input));
    }
}

std::vector<Branch> branches_between(MachineTables& tables, const Activation& config, const View& now) {
    std::vector<Branch> result;
    for (const RunningThread& running : now.threads)
        if (running.head().kind == ItemKind::resume)
            result.push_back(
                {nullptr, b::name("startexec"), {}, next_configuration(running.replace(running.tail()), {})});
        else if (!touches_registers(tables, running))
            if (auto branch = head_branch(tables, running, false)) result.push_back(std::move(*branch));
    for (Branch& write : external_writes(tables, config, now)) result.push_back(std::move(write));
    if (tables.machine().kind == ir::MachineKind::state_machine) {
        add_reads(tables, config, result);
        if (waits_at_end(tables, config))
            result.push_back({nullptr, b::name("terminate"), {}, next_process(b::skip())});
    }
    result.push_back(tock_branch(tables, config, now));
    return result;
}

}  // namespace

bool is_between_cycles(const View& now) {
    return std::ranges::any_of(now.threads,
                               [](const RunningThread& running) { return running.head().kind == ItemKind::resume; });
}

bool touches_registers(const MachineTables& tables, const RunningThread& running) {
    const Item& item = running.head();
    const Frame& frame = tables.frames[running.frame()];
    if (item.kind == ItemKind::store)
        return frame.machine->variables.at(item.variable.index).scope == ir::VariableScope::reg;
    if (item.kind == ItemKind::frozen) return true;
    if (item.kind != ItemKind::statement || item.stmt == nullptr) return false;
    return ir::touches_registers(*frame.machine, *item.stmt);
}

Branch end_cycle(const RunningThread& running) {
    const Program rest = waiting_for_cycle(running.head().label, running.tail());
    return {nullptr, b::name("endexec"), {}, next_configuration(running.replace(rest), {})};
}

Activation before_first_cycle(const ir::Machine& machine) {
    Activation start;
    start.at = machine.initial;
    start.control.rest = waiting_for_cycle("initial node", nullptr);
    return start;
}

std::vector<Branch> cycle_branches(MachineTables& tables, const Activation& config) {
    const View now = view_of(config);
    if (is_between_cycles(now)) return branches_between(tables, config, now);
    const bool alone = now.threads.size() == 1;
    std::vector<Branch> result;
    if (is_final(tables, config)) {
        Activation ended = config;
        ended.control.rest = waiting_for_cycle("final state", nullptr);
        result.push_back({nullptr, b::name("endexec"), {}, next_configuration(std::move(ended), {})});
    }
    for (const RunningMachine& running : now.machines)
        for (const ir::TransitionId id : outgoing_transitions(tables, *running.activation))
            result.push_back(fire_transition(tables, running, id));
    for (const RunningThread& running : now.threads)
        if (auto branch = head_branch(tables, running, alone)) result.push_back(std::move(*branch));
    // an operation that is checked separately may require variables of its caller
    for (Branch& write : external_writes(tables, config, now)) result.push_back(std::move(write));
    // a machine's process of the cycle lets no time pass here, but an operation that is checked separately has no such
    // process
    if (tables.machine().kind == ir::MachineKind::operation && !is_urgent(tables, now))
        result.push_back(tock_branch(tables, config, now));
    return result;
}

}  // namespace robochart::csp_emit
