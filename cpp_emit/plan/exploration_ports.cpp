// SPDX-License-Identifier: Apache-2.0
// Lists registers and outputs of a component in the order of the exploration interface.
#include "cpp_emit/plan/exploration_ports.hpp"

#include <algorithm>

#include "semantics/ir/number_parts.hpp"

namespace robochart::cpp_emit {

std::vector<Register> exploration_registers(const Component& component) {
    std::vector<Register> result;
    for (const EventPort& event : component.events)
        if (event.received) result.push_back({event.outside + ".in", event.input, event.type});
    for (const StoredVariable& variable : component.variables)
        if (!variable.input.empty() && !variable.copy)
            result.push_back({"set_EXT_" + variable.name(), variable.input, variable.variable->type});
    return result;
}

std::vector<Output> exploration_outputs(const Component& component) {
    std::vector<Output> result;
    for (const PlatformCall& call : component.calls)
        result.push_back({call.signature->name + "Call", call.method, call.signature->parameters});
    for (const EventPort& event : component.events) {
        if (event.output.empty()) continue;
        result.push_back({event.outside + ".out", event.output, {}});
        if (event.type) result.back().types.push_back(*event.type);
    }
    for (const StoredVariable& variable : component.variables)
        if (variable.visible && !variable.copy)
            result.push_back({"set_" + variable.name(), variable.output, {variable.variable->type}});
    return result;
}

std::vector<ir::TypeId> tracked_types(const ir::System& system, const Component& component) {
    std::vector<ir::TypeId> result;
    const auto add = [&](ir::TypeId type) {
        const bool numbers = !ir::number_parts(system, type).empty() || ir::is_number_sequence(system, type);
        if (numbers && std::ranges::find(result, type) == result.end()) result.push_back(type);
    };
    for (const Register& input : exploration_registers(component))
        if (input.type) add(*input.type);
    for (const Output& output : exploration_outputs(component)) std::ranges::for_each(output.types, add);
    return result;
}

}  // namespace robochart::cpp_emit
