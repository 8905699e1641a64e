// SPDX-License-Identifier: Apache-2.0
#include "semantics/data/places.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "semantics/ir/query.hpp"

namespace robochart::ir {
namespace {

template <class Component, class Visit>
void visit_component(Component& component, const Visit& visit) {
    for (auto& variable : component.variables) visit(variable.type);
    for (auto& event : component.events)
        if (event.type) visit(*event.type);
    for (auto& operation : component.operations)
        for (auto& parameter : operation.parameters) visit(parameter);
}

bool is_shared(const Machine& machine, const Variable& variable) {
    return variable.scope == VariableScope::required || variable.scope == VariableScope::reg ||
           (machine.kind == MachineKind::operation && variable.scope == VariableScope::parameter);
}

/// Returns the name that the model uses. In the IR, names of registers of RoboSim begin with `$`, and names of their
/// values end with `?`.
std::string name_in_model(const Variable& variable) {
    if (variable.scope != VariableScope::reg) return variable.name;
    return variable.name.substr(1, variable.name.size() - (variable.name.ends_with('?') ? 2 : 1));
}

}  // namespace

void Places::visit_types(System& system, const std::function<void(TypeId&)>& visit) {
    for (Machine& machine : system.machines) visit_component(machine, visit);
    for (Controller& controller : system.controllers) visit_component(controller, visit);
    for (Module& module : system.modules) visit_component(module.platform, visit);
}

Places::Places(const System& system) {
    number_places(system);
    parents_.resize(places_.size());
    for (PlaceId place = 0; place < parents_.size(); ++place) parents_[place] = place;
    unite_shared_names(system);
    unite_connections(system);
}

void Places::number_places(const System& system) {
    std::uint32_t owner = no_id;
    const auto add = [&](Place place) {
        place.machine = owner;
        places_.push_back(std::move(place));
        return static_cast<PlaceId>(places_.size() - 1);
    };
    const auto add_component = [&](const auto& component, const auto& shared, bool machine) {
        MachinePlaces numbers;
        numbers.variables = static_cast<PlaceId>(places_.size());
        for (const Variable& variable : component.variables)
            add({.type = variable.type,
                 .name = name_in_model(variable),
                 .shared = shared(variable),
                 .opaque = !machine && variable.initial != nullptr,
                 .variable = true});
        for (const Event& event : component.events)
            numbers.events.push_back(event.type ? add({.type = *event.type, .name = event.name, .input = event.input})
                                                : no_id);
        for (const OperationSignature& operation : component.operations) {
            numbers.operations.push_back(static_cast<PlaceId>(places_.size()));
            for (std::size_t i = 0; i < operation.parameters.size(); ++i)
                add({.type = operation.parameters[i], .name = operation.parameter_names.at(i)});
        }
        return numbers;
    };
    const auto always = [](const Variable&) { return true; };
    for (std::uint32_t m = 0; m < system.machines.size(); ++m) {
        const Machine& machine = system.machines[m];
        owner = m;
        machines_.push_back(add_component(
            machine, [&](const Variable& variable) { return is_shared(machine, variable); }, true));
    }
    owner = no_id;
    for (const Controller& controller : system.controllers)
        controllers_.push_back(add_component(controller, always, false));
    for (const Module& module : system.modules) platforms_.push_back(add_component(module.platform, always, false));
}

PlaceId Places::class_of(PlaceId place) const {
    while (parents_[place] != place) place = parents_[place];
    return place;
}

void Places::unite(PlaceId a, PlaceId b) {
    const auto [least, other] = std::minmax({class_of(a), class_of(b)});
    Place& all = places_[least];
    all.opaque = all.opaque || places_[other].opaque || all.type != places_[other].type;
    all.input = all.input || places_[other].input;
    all.shared = all.shared || places_[other].shared;
    all.internal = all.internal || places_[other].internal;
    parents_[other] = least;
}

/// Unites the flow classes of variables with the same name if they are shared, or if an operation requires a variable
/// with this name. Also unites parameters of operations with the same name, and events with the same name in operations
/// and their callers. This may unite places between which no value is copied. It is sound, because a larger flow class
/// only has more conditions.
void Places::unite_shared_names(const System& system) {
    std::map<std::pair<std::string, std::size_t>, PlaceId> first;
    const auto unite_name = [&](const std::string& key, std::size_t position, PlaceId place) {
        const auto [found, added] = first.emplace(std::pair(key, position), place);
        if (!added) unite(found->second, place);
    };
    std::set<std::string> of_operations;
    for (const Machine& machine : system.machines)
        if (machine.kind == MachineKind::operation)
            for (const Variable& variable : machine.variables)
                if (variable.scope == VariableScope::required) of_operations.insert(variable.name);
    const auto unite_signatures = [&](const auto& component, const MachinePlaces& numbers) {
        for (std::size_t i = 0; i < component.operations.size(); ++i)
            for (std::size_t p = 0; p < component.operations[i].parameters.size(); ++p)
                unite_name("operation " + component.operations[i].name, p,
                           numbers.operations[i] + static_cast<PlaceId>(p));
    };
    const auto unite_variables = [&](const auto& component, const MachinePlaces& numbers) {
        for (std::size_t i = 0; i < component.variables.size(); ++i)
            unite_name("variable " + component.variables[i].name, 0, numbers.variables + static_cast<PlaceId>(i));
    };
    bool operations_use_events = false, operations_use_registers = false;
    for (std::size_t m = 0; m < system.machines.size(); ++m) {
        const Machine& machine = system.machines[m];
        std::size_t parameters = 0;
        for (std::uint32_t i = 0; i < machine.variables.size(); ++i) {
            const Variable& variable = machine.variables[i];
            const PlaceId place = machines_[m].variables + i;
            if (variable.scope == VariableScope::parameter)
                unite_name("operation " + machine.name, parameters++, place);
            else if (variable.scope == VariableScope::required || of_operations.contains(variable.name))
                unite_name("variable " + variable.name, 0, place);
            else if (variable.scope == VariableScope::reg && event_register(machine, VariableId{i}) == nullptr)
                unite_name("variable " + name_in_model(variable), 0, place);
        }
        unite_signatures(machine, machines_[m]);
        operations_use_events =
            operations_use_events || (machine.kind == MachineKind::operation && !machine.events.empty());
        operations_use_registers =
            operations_use_registers || (machine.kind == MachineKind::operation && !machine.inputs.empty());
    }
    for (std::size_t m = 0; operations_use_registers && m < system.machines.size(); ++m)
        for (const Input& input : system.machines[m].inputs)
            if (input.content.is_valid())
                unite_name("register " + input.name, 0, machines_[m].variables + input.content.index);
    for (std::size_t m = 0; operations_use_events && m < system.machines.size(); ++m)
        for (std::size_t i = 0; i < system.machines[m].events.size(); ++i)
            if (machines_[m].events[i] != no_id)
                unite_name("event " + system.machines[m].events[i].name, 0, machines_[m].events[i]);
    for (std::size_t c = 0; c < system.controllers.size(); ++c) {
        unite_variables(system.controllers[c], controllers_[c]);
        unite_signatures(system.controllers[c], controllers_[c]);
    }
    for (std::size_t m = 0; m < system.modules.size(); ++m) {
        unite_variables(system.modules[m].platform, platforms_[m]);
        unite_signatures(system.modules[m].platform, platforms_[m]);
    }
}

void Places::unite_connections(const System& system) {
    const auto place_of = [](const std::vector<Event>& events, const MachinePlaces& numbers, const std::string& name) {
        const auto found = std::ranges::find(events, name, &Event::name);
        return found == events.end() ? no_id : numbers.events[static_cast<std::size_t>(found - events.begin())];
    };
    // In RoboSim, an event can be both an input and an output. Both then belong to one flow class.
    const auto place_in_machine = [&](std::uint32_t machine, const std::string& name) {
        const PlaceId output = place_of(system.machines[machine].events, machines_[machine], name);
        const auto& inputs = system.machines[machine].inputs;
        const auto input =
            std::ranges::find_if(inputs, [&](const Input& one) { return one.full.is_valid() && one.name == name; });
        if (input == inputs.end() || !input->content.is_valid()) return output;
        const PlaceId content = machines_[machine].variables + input->content.index;
        if (output != no_id) unite(output, content);
        return content;
    };
    const auto unite_ends = [&](const std::vector<Connection>& connections, const auto& end) {
        for (const Connection& connection : connections) {
            const PlaceId from = end(connection.from), to = end(connection.to);
            if (from == no_id || to == no_id) continue;
            unite(from, to);
            Place& all = places_[class_of(from)];
            all.internal =
                all.internal || (connection.from.kind == EndKind::part && connection.to.kind == EndKind::part);
        }
    };
    for (std::size_t c = 0; c < system.controllers.size(); ++c) {
        const Controller& controller = system.controllers[c];
        unite_ends(controller.connections, [&](const ConnectionEnd& end) {
            if (end.kind == EndKind::self) return place_of(controller.events, controllers_[c], end.event);
            const std::uint32_t machine = controller.machines.at(end.part).machine.index;
            return place_in_machine(machine, end.event);
        });
    }
    for (std::size_t m = 0; m < system.modules.size(); ++m) {
        const Module& module = system.modules[m];
        unite_ends(module.connections, [&](const ConnectionEnd& end) {
            if (end.kind == EndKind::self) return place_of(module.platform.events, platforms_[m], end.event);
            const std::uint32_t controller = module.controllers.at(end.part).controller.index;
            return place_of(system.controllers[controller].events, controllers_[controller], end.event);
        });
    }
}

}  // namespace robochart::ir
