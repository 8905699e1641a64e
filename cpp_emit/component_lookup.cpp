// Looking up what a unit's numbers stand for in the component.
#include <algorithm>

#include "cpp_emit/component.hpp"

namespace robochart::cpp_emit {

const Unit& Component::unit(ir::MachineId id) const {
    return *std::find_if(units.begin(), units.end(), [&](const Unit& candidate) { return candidate.id == id; });
}

const EventPort& Component::event(const Unit& of, ir::EventId id) const {
    const std::string& wanted = of.machine->events[id.index].name;
    return *std::find_if(events.begin(), events.end(),
                         [&](const EventPort& port) { return port.model_name == wanted; });
}

const StoredVariable* Component::stored(const Unit& of, ir::VariableId id) const {
    const ir::Variable& variable = of.machine->variables[id.index];
    if (!of.root && variable.scope != ir::VariableScope::required) return nullptr;
    const auto found = std::find_if(variables.begin(), variables.end(),
                                    [&](const StoredVariable& entry) { return entry.variable->name == variable.name; });
    return &*found;
}

const PlatformCall& Component::call(const Unit& of, ir::OperationId id) const {
    const std::string& wanted = of.machine->operations[id.index].name;
    return *std::find_if(calls.begin(), calls.end(),
                         [&](const PlatformCall& candidate) { return candidate.signature->name == wanted; });
}

const ModelledCall& Component::modelled_call(ir::MachineId definition) const {
    return *std::find_if(modelled.begin(), modelled.end(),
                         [&](const ModelledCall& candidate) { return candidate.definition == definition; });
}

std::pair<const Unit*, ir::ClockId> Component::clock(const Unit& of, ir::ClockId id) const {
    const ir::Clock& wanted = of.machine->clocks[id.index];
    if (of.root || !wanted.required) return {&of, id};
    const auto& clocks = root().machine->clocks;
    for (std::uint32_t index = 0; index < clocks.size(); ++index)
        if (clocks[index].name == wanted.name) return {&root(), ir::ClockId{index}};
    return {&of, id};
}

}  // namespace robochart::cpp_emit
