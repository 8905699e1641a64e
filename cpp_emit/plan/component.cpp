// SPDX-License-Identifier: Apache-2.0
// Looks up the elements of the component that a unit refers to by number.
#include <algorithm>
#include <cassert>

#include "cpp_emit/plan/component.hpp"
#include "cpp_emit/plan/types.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::cpp_emit {

std::set<std::string> never_members(const ir::System& system, const Component& component) {
    std::set<std::string> names = {"at", "wait",  "leaving", "next", "filler", "kept", "State", "Inputs",
                                   "At", "Event", "Types",   "Real", "Nat",    "Int",  "std",   "robochart"};
    for (const ir::TypeId type : component.enumerations) names.insert(declared_name(system.type(type)));
    for (const Unit& unit : component.units) names.insert({unit.frame, unit.points});
    return names;
}

NameScope core_type_scope(const Component& component) {
    NameScope scope(own_type_names());
    for (const Unit& unit : component.units) {
        for (const ir::Variable& variable : unit.machine->variables) scope.reserve_name(to_identifier(variable.name));
        for (const ir::Clock& clock : unit.machine->clocks) scope.reserve_name(to_identifier(clock.name));
        for (const ir::Event& event : unit.machine->events) scope.reserve_name(to_identifier(event.name));
    }
    for (const Part& part : component.parts) scope.reserve_name(to_identifier(part.name));
    return scope;
}

const EventUse& Component::find_event(const Unit& of, ir::EventId id) const {
    assert(id.index < of.machine->events.size());
    return *find_event(Peer{of.part, of.machine->events[id.index].name});
}

const EventUse* Component::find_event(const Peer& end) const {
    assert(end.part < parts.size());
    const std::vector<EventUse>& uses = parts[end.part].events;
    const auto found = std::ranges::find_if(uses, [&](const EventUse& use) { return use.name == end.event; });
    return found == uses.end() ? nullptr : &*found;
}

const StoredVariable* Component::stored_variable(const Unit& of, ir::VariableId id) const {
    assert(id.index < of.variable_owners.size() && id.index < of.machine->variables.size());
    if (!unit_at(of.variable_owners[id.index].unit).root) return nullptr;
    return &variables[part_of(of).variables.at(of.machine->variables[id.index].name)];
}

const StoredVariable* Component::memory_of(const StoredVariable& variable) const {
    return variable.memory == no_memory ? nullptr : &variables[variable.memory];
}

const EventUse* Component::find_register(const Unit& of, ir::VariableId id) const {
    const ir::Input* const input = ir::event_register(*of.machine, id);
    return input == nullptr ? nullptr : find_event(Peer{of.part, input->name});
}

const PlatformCall& Component::find_platform_call(const Unit& of, ir::OperationId id) const {
    assert(id.index < of.machine->operations.size());
    const std::string& operation_name = of.machine->operations[id.index].name;
    return *std::ranges::find_if(
        calls, [&](const PlatformCall& candidate) { return candidate.signature->name == operation_name; });
}

const ModelledCall& Component::modelled_call(ir::MachineId definition) const {
    return *std::ranges::find_if(modelled,
                                 [&](const ModelledCall& candidate) { return candidate.definition == definition; });
}

const CarrierUse& Component::find_carrier(ir::TypeId type) const {
    return *std::ranges::find_if(carriers, [&](const CarrierUse& use) { return use.type == type; });
}

std::pair<const Unit*, ir::ClockId> Component::clock_owner(const Unit& of, ir::ClockId id) const {
    assert(id.index < of.clock_owners.size());
    const Owner& owner = of.clock_owners[id.index];
    return {&unit_at(owner.unit), ir::ClockId{owner.place}};
}

}  // namespace robochart::cpp_emit
