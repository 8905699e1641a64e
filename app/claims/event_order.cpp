// SPDX-License-Identifier: Apache-2.0
// See event_order.hpp.
#include "app/claims/event_order.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "claims/checks/components.hpp"
#include "claims/checks/rules.hpp"
#include "cpp_emit/plan/resolve_component.hpp"
#include "driver/model/places.hpp"
#include "driver/model/project_claims.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::app {
namespace {

using claims::CheckedOrder;
using Drop = cpp_emit::EventOrder::Drop;

/// Returns the index of the input that has this name at the boundary of the component.
std::optional<std::uint32_t> input_named(const cpp_emit::Component& component, const std::string& outside) {
    std::uint32_t number = 0;
    for (const cpp_emit::EventPort& port : component.events) {
        if (!port.received) continue;
        if (port.outside == outside) return number;
        ++number;
    }
    return std::nullopt;
}

/// Returns the two events as inputs of the component; no value unless the platform raises both.
std::optional<Drop> drop_of(const cpp_emit::Component& component, const std::optional<std::string>& event,
                            const std::optional<std::string>& dropped) {
    if (!event || !dropped) return std::nullopt;
    const auto one = input_named(component, *event), other = input_named(component, *dropped);
    if (!one || !other) return std::nullopt;
    return Drop{*event, *dropped, *one, *other};
}

/// Returns the event at the boundary that a machine in the component receives as `name`.
std::optional<std::string> outside_of_part(const cpp_emit::Component& component, const cpp_emit::Part& part,
                                           const std::string& name) {
    const auto use = std::ranges::find(part.events, name, &cpp_emit::EventUse::name);
    if (use == part.events.end() || use->ports.empty()) return std::nullopt;
    return component.events[use->ports.front()].outside;
}

/// Returns the event at the boundary of a module that the controller receives as `name`.
std::optional<std::string> outside_of_controller(const ir::Module& module, std::uint32_t controller,
                                                 const std::string& name) {
    const auto is_controller = [&](const ir::ConnectionEnd& end) {
        return end.kind == ir::EndKind::part && end.part == controller && end.event == name;
    };
    for (const ir::Connection& connection : module.connections) {  // a connection may go in either direction
        if (is_controller(connection.to) && connection.from.kind == ir::EndKind::self) return connection.from.event;
        if (is_controller(connection.from) && connection.to.kind == ir::EndKind::self) return connection.to.event;
    }
    return std::nullopt;
}

/// Translates the orders of a component, of its parts, and of the machines and controllers that run in it.
class Translator {
public:
    /// `component` describes the component that `ref` refers to.
    Translator(const driver::Project& project, const ir::ComponentRef& ref, const claims::Component& component)
        : project_(project), ref_(ref), of_(component) {}

    /// True if the order is about the component or a part of it.
    [[nodiscard]] bool is_about(const CheckedOrder& order) const {
        const std::string& path = order.component.path;
        if (path == of_.path || path.starts_with(of_.path + "::")) return true;
        if (order.component.part) return false;
        if (order.component.kind == ir::ComponentKind::machine)
            return std::ranges::any_of(of_.machines, [&](const claims::MachinePart& part) {
                return part.machine == order.component.machines.front().machine;
            });
        return order.component.kind == ir::ComponentKind::controller && !instances_of(order).empty();
    }

    void add_first(const CheckedOrder& order, cpp_emit::EventOrder& result) const {
        for (const std::string& name : order.first) {
            const ir::MachineId id = order.component.machines.front().machine;
            const std::vector<ir::Event>& events = project_.system.machine(id).events;
            const auto event = std::ranges::find(events, name, &ir::Event::name);
            result.first[id.index].push_back(ir::EventId{static_cast<std::uint32_t>(event - events.begin())});
        }
    }

    /// Returns the drop for each part that the order is about. The result is empty if the platform does not raise both
    /// events.
    [[nodiscard]] std::vector<Drop> drops_of(const CheckedOrder& order, const CheckedOrder::Drop& drop,
                                             const cpp_emit::Component& plan) const {
        std::vector<Drop> result;
        const auto add = [&](const std::optional<Drop>& found) {
            if (found) result.push_back(*found);
        };
        if (order.component.path == of_.path) {
            add(drop_of(plan, drop.event, drop.dropped));
        } else if (order.component.kind == ir::ComponentKind::machine) {
            for (const cpp_emit::Part& part : plan.parts)
                if (is_of(order, part, plan))
                    add(drop_of(plan, outside_of_part(plan, part, drop.event),
                                outside_of_part(plan, part, drop.dropped)));
        } else {
            for (const std::uint32_t instance : instances_of(order)) {
                const ir::Module& module = project_.system.modules[ref_.definition];
                add(drop_of(plan, outside_of_controller(module, instance, drop.event),
                            outside_of_controller(module, instance, drop.dropped)));
            }
        }
        return result;
    }

private:
    [[nodiscard]] bool is_of(const CheckedOrder& order, const cpp_emit::Part& part,
                             const cpp_emit::Component& plan) const {
        if (order.component.part) return order.component.path == of_.path + "::" + part.name;
        return plan.units[part.root].id == order.component.machines.front().machine;
    }

    /// Returns the controllers of this module that the order is about.
    [[nodiscard]] std::vector<std::uint32_t> instances_of(const CheckedOrder& order) const {
        std::vector<std::uint32_t> result;
        if (ref_.kind != ir::ComponentKind::module) return result;
        const ir::Module& module = project_.system.modules[ref_.definition];
        for (std::uint32_t i = 0; i < module.controllers.size(); ++i)
            if (controller_path(module.controllers[i], order) == order.component.path) result.push_back(i);
        return result;
    }

    /// Returns the name that the order uses for a controller: the path of the controller in this module, or the name of
    /// its definition.
    [[nodiscard]] std::string controller_path(const ir::ControllerInstance& instance, const CheckedOrder& order) const {
        if (order.component.part) return of_.path + "::" + instance.name;
        const ir::Controller& controller = project_.system.controller(instance.controller);
        return ir::qualified_name({ir::ComponentKind::controller, controller.path, controller.package});
    }

    const driver::Project& project_;
    const ir::ComponentRef& ref_;
    const claims::Component& of_;
};

/// A drop that a component cannot obey, because its platform does not raise both events.
struct Foreign {
    const CheckedOrder* order = nullptr;
    CheckedOrder::Drop drop;
};

cpp_emit::EventOrder translate(const driver::Project& project, const ir::ComponentRef& component,
                               std::vector<Foreign>& foreign) {
    cpp_emit::EventOrder result;
    const std::vector<CheckedOrder>& orders = project.claims->checked.orders;
    if (orders.empty()) return result;
    const std::vector<claims::Component> components = claims::components_of(project.system);
    const auto of = std::ranges::find(components, ir::qualified_name(component), &claims::Component::path);
    if (of == components.end() || ir::is_robosim(project.system, component)) return result;
    const Translator translator(project, component, *of);
    diagnostics::Diagnostics apart;  // discarded, because the generator reports the same findings
    std::optional<cpp_emit::Component> plan;
    for (const CheckedOrder& order : orders) {
        if (!translator.is_about(order)) continue;
        translator.add_first(order, result);
        if (order.drops.empty()) continue;
        if (!plan) plan = cpp_emit::resolve_component(project.system, project.instantiation, component, apart);
        if (!plan) return result;
        for (const CheckedOrder::Drop& drop : order.drops) {
            const std::vector<Drop> drops = translator.drops_of(order, drop, *plan);
            if (drops.empty()) foreign.push_back({&order, drop});
            result.drops.insert(result.drops.end(), drops.begin(), drops.end());
        }
    }
    return result;
}

}  // namespace

cpp_emit::EventOrder event_order(driver::Project& project, const ir::ComponentRef& component) {
    std::vector<Foreign> foreign;
    cpp_emit::EventOrder result = translate(project, component, foreign);
    for (const Foreign& one : foreign)
        project.diagnostics.report(
            claims::rules::wrong_form, one.order->span,
            {fmt::format("the platform of {} does not raise both `{}` and `{}` of {}, so it cannot drop one",
                         ir::qualified_name(component), one.drop.event, one.drop.dropped, one.order->component.path)});
    return result;
}

driver::FollowedClaim::Drops dropped_events(const driver::Project& project, const std::string& path) {
    driver::FollowedClaim::Drops result;
    std::vector<Foreign> foreign;
    for (const ir::ComponentRef& component : driver::code_components(project.system, ""))
        if (ir::qualified_name(component) == path)
            for (const Drop& drop : translate(project, component, foreign).drops)
                result.push_back({drop.event, drop.dropped});
    return result;
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
