// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/code/cycles.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cpp_emit/plan/names.hpp"
#include "cpp_emit/plan/types.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::cpp_emit {

using ir::StmtKind;

namespace {

std::string written_member(const std::string& method) {
    return fmt::format("wrote_{}_", method);
}

std::string written_member(const StoredVariable& variable) {
    return written_member(variable.once.empty() ? variable.output : variable.once);
}

std::string written_member(const Component& component, const EventUse& use) {
    return written_member(use.outlets.empty() ? to_identifier(use.once) : component.events[use.outlets.front()].output);
}

/// Returns the members that record which outputs are written, without duplicates.
std::vector<std::string> written_members(const Component& component) {
    std::vector<std::string> members;
    const auto add = [&](std::string member) {
        if (std::ranges::find(members, member) == members.end()) members.push_back(std::move(member));
    };
    for (const PlatformCall& call : component.calls)
        if (call.signature->output) add(written_member(call.method));
    for (const Part& part : component.parts)
        for (const EventUse& use : part.events)
            if (use.sent) add(written_member(component, use));
    for (const StoredVariable& variable : component.variables)
        if (!variable.writer.empty()) add(written_member(variable));
    return members;
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
        return written_member(component, component.find_event(unit, stmt.communication.event));
    }
    if (stmt.kind == StmtKind::call && unit.machine->operations[stmt.operation.index].output)
        return written_member(component.find_platform_call(unit, stmt.operation).method);
    if (stmt.kind != StmtKind::assign) return {};
    const StoredVariable* const stored = component.stored_variable(unit, stmt.variable);
    return stored == nullptr || !stored->visible ? "" : written_member(*stored);
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

std::string buffer_type(const Generation& generation, const Buffer& buffer) {
    return buffer.type ? fmt::format("robochart::Buffer<{}>", cpp_type(generation.system, *buffer.type))
                       : std::string("robochart::Flag");
}

void read_registers_between_machines(const Generation& generation, CodeWriter& out) {
    if (!generation.component.robosim) return;
    for (const StoredVariable& variable : generation.component.variables)
        if (const StoredVariable* const memory = generation.component.memory_of(variable);
            memory != nullptr && variable.local)
            out.line(fmt::format("{}.write(state_.{});", variable.field, memory->path));
    for (const Buffer& buffer : generation.component.buffers) {
        out.line(fmt::format("latched_{0}_ = state_.{0};", buffer.field));
        if (!generation.mutation.hits(Fault::buffer_kept)) out.line(fmt::format("state_.{} = {{}};", buffer.field));
    }
}

void write_cycle_members(const Generation& generation, CodeWriter& out) {
    const Component& component = generation.component;
    if (!component.robosim) return;
    for (const Part& part : component.parts)
        out.line_with_doc(fmt::format("bool {} = false;", ended_member(component, component.units[part.root])),
                          "the cycle has ended: nothing but time happens before the next one");
    for (const std::string& member : written_members(component)) out.line(fmt::format("bool {} = false;", member));
    for (const Buffer& buffer : component.buffers)
        out.line_with_doc(fmt::format("{} latched_{}_{{}};", buffer_type(generation, buffer), buffer.field),
                          "event between machines, as this cycle reads it");
}

}  // namespace robochart::cpp_emit
