// SPDX-License-Identifier: Apache-2.0
// See event_order.hpp.
#include "app/claims/event_order.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "claims/checks/components.hpp"
#include "driver/model/project_claims.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::app {
namespace {

/// True if the order is about the component, a part of it, or a machine that runs in it.
bool is_about(const claims::CheckedOrder& order, const claims::Component& component) {
    const std::string& path = order.component.path;
    if (path == component.path || path.starts_with(component.path + "::")) return true;
    return order.component.kind == ir::ComponentKind::machine &&
           std::ranges::any_of(component.machines, [&](const claims::MachinePart& part) {
               return part.machine == order.component.machines.front().machine;
           });
}

}  // namespace

cpp_emit::EventOrder event_order(const driver::Project& project, const ir::ComponentRef& component) {
    cpp_emit::EventOrder result;
    const std::vector<claims::CheckedOrder>& orders = project.claims->checked.orders;
    if (orders.empty()) return result;
    const std::vector<claims::Component> components = claims::components_of(project.system);
    const auto of = std::ranges::find(components, ir::qualified_name(component), &claims::Component::path);
    if (of == components.end()) return result;
    for (const claims::CheckedOrder& order : orders) {
        if (!is_about(order, *of)) continue;
        for (const std::string& name : order.first) {
            const ir::MachineId id = order.component.machines.front().machine;
            const std::vector<ir::Event>& events = project.system.machine(id).events;
            const auto event = std::ranges::find(events, name, &ir::Event::name);
            result.first[id.index].push_back(ir::EventId{static_cast<std::uint32_t>(event - events.begin())});
        }
        for (const claims::CheckedOrder::Drop& drop : order.drops) result.drops.push_back({drop.event, drop.dropped});
    }
    return result;
}

std::string why_unlike_model(const driver::Project& project, const ir::ComponentRef& component) {
    return event_order(project, component).drops.empty() ? ""
                                                         : "its declared order drops events, and the model does not";
}

std::string order_text(const ir::System& system, const cpp_emit::EventOrder& order) {
    std::vector<std::string> parts;
    for (const auto& [machine, events] : order.first)
        for (const ir::EventId event : events)
            parts.push_back(fmt::format("{} first", system.machines[machine].events[event.index].name));
    for (const cpp_emit::EventOrder::Drop& drop : order.drops)
        parts.push_back(fmt::format("{} dropped where {} is raised", drop.dropped, drop.event));
    return fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace robochart::app
