// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/code/cycles.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "semantics/ir/query.hpp"

namespace robochart::cpp_emit {

using ir::StmtKind;

namespace {

std::string written_member(const std::string& method) {
    return fmt::format("wrote_{}_", method);
}

}  // namespace

std::string ended_member(const Component& component, const Unit& unit) {
    const std::string& tag = component.part_of(unit).tag;
    return tag.empty() ? "ended_" : fmt::format("ended_{}_", tag);
}

std::string written_member(const Generation& generation, const Unit& unit, const ir::Stmt& stmt) {
    const Component& component = generation.component;
    if (!component.robosim) return {};
    if (stmt.kind == StmtKind::communicate) {
        const EventUse& use = component.find_event(unit, stmt.communication.event);
        return use.ports.empty() ? "" : written_member(component.events[use.ports.front()].output);
    }
    if (stmt.kind == StmtKind::call && unit.machine->operations[stmt.operation.index].output)
        return written_member(component.find_platform_call(unit, stmt.operation).method);
    if (stmt.kind != StmtKind::assign) return {};
    const StoredVariable* const stored = component.stored_variable(unit, stmt.variable);
    return stored == nullptr || !stored->visible ? "" : written_member(stored->output);
}

bool has_parallel_actions(const Component& component, const Unit& unit) {
    return std::ranges::any_of(component.units, [&](const Unit& other) {
        return other.part == unit.part &&
               std::ranges::any_of(other.machine->nodes, [](const ir::Node& node) { return node.during != nullptr; });
    });
}

bool may_await_cycle(const Generation& generation, const Unit& unit, const ir::Stmt& stmt) {
    if (!generation.component.robosim) return false;
    return stmt.kind == StmtKind::exec || !awaits_cycle(generation, unit, stmt).empty();
}

std::string awaits_cycle(const Generation& generation, const Unit& unit, const ir::Stmt& stmt) {
    const Component& component = generation.component;
    if (!component.robosim || !ir::touches_registers(*unit.machine, stmt)) return {};
    const std::string written = written_member(generation, unit, stmt);
    if (!has_parallel_actions(component, unit)) return written;
    const std::string ended = ended_member(component, unit);
    return written.empty() ? ended : fmt::format("{} || {}", ended, written);
}

void write_cycle_members(const Generation& generation, CodeWriter& out) {
    const Component& component = generation.component;
    if (!component.robosim) return;
    for (const Part& part : component.parts)
        out.line_with_doc(fmt::format("bool {} = false;", ended_member(component, component.units[part.root])),
                          "the cycle has ended: nothing but time happens before the next one");
    const auto written = [&](const std::string& method) {
        out.line(fmt::format("bool {} = false;", written_member(method)));
    };
    for (const PlatformCall& call : component.calls)
        if (call.signature->output) written(call.method);
    for (const EventPort& event : component.events)
        if (!event.output.empty()) written(event.output);
    for (const StoredVariable& variable : component.variables)
        if (!variable.output.empty() && !variable.copy) written(variable.output);
}

}  // namespace robochart::cpp_emit
