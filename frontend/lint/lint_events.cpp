// SPDX-License-Identifier: Apache-2.0
// Reports events that are not connected outside of their component (semantics 3.9). An event without a connection is
// hidden: its triggers fire spontaneously and its outputs never wait. An event that is connected to a component that
// never uses it can never happen.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "frontend/lint/lints.hpp"
#include "frontend/names/scopes.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/expression_visitor.hpp"

namespace robochart::frontend {

namespace {

/// The first use of each event of a machine, by name. Operations that the controller defines count as part of the
/// machine.
class EventUses {
public:
    EventUses(const Machine& machine, const std::map<std::string_view, const Machine*>& defined) : defined_(defined) {
        add(machine);
    }
    [[nodiscard]] std::optional<Span> first_use(std::string_view event) const {
        const auto found = first_.find(event);
        return found != first_.end() ? std::optional(found->second) : std::nullopt;
    }

private:
    void add(const Machine& machine) {
        if (!seen_.insert(&machine).second) return;
        walk_tree(machine, [&](const NodeContainer& container) {
            for (const auto& transition : container.transitions) {
                if (transition->trigger) add(*transition->trigger);
                if (transition->condition) add_reads(*transition->condition);
            }
        });
        for_actions(machine, [&](const Stmt& action) {
            walk_tree(action, [&](const Stmt& statement) {
                if (statement.communication) add(*statement.communication);
                for_expressions(statement, [&](const Expr& expr) { add_reads(expr); });
                if (statement.kind != StmtKind::call || statement.declaration == nullptr) return;
                const auto called = defined_.find(statement.declaration->name);
                if (called != defined_.end()) add(*called->second);
            });
        });
    }

    void add(const Communication& communication) {
        if (communication.event_target != nullptr) first_.emplace(communication.event_target->name, communication.span);
    }

    /// Adds the events that RoboSim reads as `$e`.
    void add_reads(const Expr& expr) {
        walk_tree(expr, [&](const Expr& part) {
            if (part.kind == ExprKind::register_ && part.target != nullptr && part.target->kind == DeclKind::event)
                first_.emplace(part.target->name, part.span);
        });
    }

    const std::map<std::string_view, const Machine*>& defined_;
    std::set<const Machine*> seen_;
    std::map<std::string_view, Span> first_;
};

/// The events that connections join, for each component and for the container itself.
class Connected {
public:
    explicit Connected(const Component& component) {
        for (const auto& connection : component.connections)
            for (const Connection::End* end : {&connection->from, &connection->to})
                if (end->node_target != nullptr) ends_[end->node_target].emplace(end->event.parts.back(), end);
    }
    [[nodiscard]] const Connection::End* end(const Declaration& part, const std::string& event) const {
        const auto of_part = ends_.find(&part);
        if (of_part == ends_.end()) return nullptr;
        const auto found = of_part->second.find(event);
        return found != of_part->second.end() ? found->second : nullptr;
    }

private:
    std::unordered_map<const Declaration*, std::map<std::string, const Connection::End*>> ends_;
};

/// Returns the first trigger of the machine with this event.
std::optional<Span> trigger_of(const Machine& machine, const std::string& event) {
    std::optional<Span> result;
    for_transitions(machine, [&](const Transition& transition) {
        const Declaration* const target = transition.trigger ? transition.trigger->event_target : nullptr;
        if (!result && target != nullptr && target->name == event) result = transition.trigger->span;
    });
    return result;
}

/// A machine of a controller, and the trigger with which it awaits an event.
struct Awaiting {
    const Declaration* part = nullptr;
    Span trigger;
};

/// Returns the first machine that awaits an event with this name and whose event has no connection in the controller.
std::optional<Awaiting> awaiting_alone(const Component& controller, const std::string& event, const Connected& inside) {
    for (const Declaration* part : controller.order) {
        const auto* machine = follow_to<Machine>(part);
        if (machine == nullptr || machine->kind != DeclKind::state_machine || inside.end(*part, event) != nullptr)
            continue;
        if (const auto trigger = trigger_of(*machine, event)) return Awaiting{part, *trigger};
    }
    return std::nullopt;
}

/// Returns the machine that awaits the event that a connection leads to from this event of the controller.
std::optional<Awaiting> awaiting_inside(const Component& controller, const std::string& event) {
    for (const auto& connection : controller.connections) {
        if (connection->from.node_target != &controller || connection->from.event.parts.back() != event) continue;
        const auto* machine = follow_to<Machine>(connection->to.node_target);
        if (machine == nullptr) continue;
        if (const auto trigger = trigger_of(*machine, connection->to.event.parts.back()))
            return Awaiting{connection->to.node_target, *trigger};
    }
    return std::nullopt;
}

/// True if a connection of the container ends at this event.
bool is_target(const Component& container, const Declaration& part, const std::string& event) {
    return std::ranges::any_of(container.connections, [&](const auto& connection) {
        return connection->to.node_target == &part && connection->to.event.parts.back() == event;
    });
}

/// Returns the platform of the module if it declares the event but has no connection for it.
const Declaration* idle_platform(const Component& module, const Connected& outside, const std::string& event) {
    for (const Declaration* part : module.order) {
        const auto* platform = follow_to<Context>(part);
        if (platform == nullptr || platform->kind != DeclKind::platform) continue;
        const std::vector<const Event*> events = visible_events(*platform);
        const bool declares = std::ranges::any_of(events, [&](const Event* known) { return known->name == event; });
        if (declares && outside.end(*part, event) == nullptr) return part;
    }
    return nullptr;
}

std::string describe_part(const Declaration& part, const Declaration& behind, std::string_view kind) {
    if (&part == &behind || part.name == behind.name) return fmt::format("{} `{}`", kind, behind.name);
    return fmt::format("`{}` ({} `{}`)", part.name, kind, behind.name);
}

/// An event without a connection, and the place at which a machine uses the event.
struct Loose {
    const Event* event = nullptr;
    Span use;
    std::string how;
};

void report_loose(const rules::Rule& rule, Span at, const std::vector<Loose>& loose, const std::string& part,
                  const std::string& container, Diagnostics& out) {
    if (loose.empty()) return;
    std::vector<std::string> names;
    for (const Loose& loose_event : loose) names.push_back(loose_event.event->name);
    const bool one = names.size() == 1;
    const std::string events = (one ? "event " : "events ") + list_names(names);
    auto& finding = out.report(rule, at, {events, part, one ? "is" : "are", container, one ? "s" : ""});
    constexpr std::size_t shown = 4;
    for (std::size_t i = 0; i < loose.size() && i < shown; ++i) {
        finding.notes.push_back({loose[i].use, loose[i].how});
        if (loose[i].how.empty()) finding.notes.back().message = fmt::format("`{}` is used here", loose[i].event->name);
    }
}

void check_machine(const Component& controller, const Declaration& part, const Machine& machine,
                   const Connected& connected, const std::map<std::string_view, const Machine*>& defined,
                   Diagnostics& out) {
    const EventUses traffic(machine, defined);
    std::vector<Loose> loose;
    for (const Event* event : visible_events(machine)) {
        const Connection::End* end = connected.end(part, event->name);
        const std::optional<Span> use = traffic.first_use(event->name);
        if (use && end == nullptr) loose.push_back({event, *use, ""});
        if (!use && end != nullptr)
            out.report(rules::w_deaf, end->event.span, {event->name, describe_part(part, machine, "machine")})
                .notes.push_back({event->name_span, "the event is declared here"});
    }
    const bool robosim = controller.dialect == Dialect::robosim;
    report_loose(robosim ? rules::w_loose_robosim : rules::w_loose_machine, part.name_span, loose,
                 describe_part(part, machine, "machine"), controller.name, out);
}

void check_controller_events(const Component& controller, Diagnostics& out) {
    const Connected connected(controller);
    std::map<std::string_view, const Machine*> defined;
    for (const Machine* operation : defined_operations(controller)) defined.emplace(operation->name, operation);
    for (const Declaration* part : controller.order) {
        const auto* machine = follow_to<Machine>(part);
        if (machine != nullptr && machine->kind == DeclKind::state_machine)
            check_machine(controller, *part, *machine, connected, defined, out);
    }
}

/// Reports a missing connection: another component of the module raises the event, and a machine awaits it. Returns
/// false if no connection is missing.
bool report_missing_link(const Component& module, const Declaration& part, const Component& controller,
                         const Event& event, const Connected& outside, const Connected& inside, Diagnostics& out) {
    const std::string& name = event.name;
    if (module.dialect == Dialect::robosim) return false;
    if (inside.end(controller, name) == nullptr && is_target(module, part, name)) {
        const auto awaiting = awaiting_alone(controller, name, inside);
        if (!awaiting) return false;
        auto& finding = out.report(rules::w_link_inside, awaiting->part->name_span,
                                   {name, controller.name, module.name, awaiting->part->name});
        finding.notes.push_back({awaiting->trigger, fmt::format("the trigger with `{}`", name)});
        finding.notes.push_back({{},
                                 fmt::format("write `connection {} on {} to {} on {}` in the controller",
                                             controller.name, name, awaiting->part->name, name)});
        return true;
    }
    if (inside.end(controller, name) == nullptr || outside.end(part, name) != nullptr) return false;
    const Declaration* const platform = idle_platform(module, outside, name);
    const auto awaiting = awaiting_inside(controller, name);
    if (platform == nullptr || !awaiting) return false;
    auto& finding = out.report(rules::w_link_outside, part.name_span,
                               {name, platform->name, part.name, module.name, awaiting->part->name});
    finding.notes.push_back({awaiting->trigger, fmt::format("the trigger with `{}`", name)});
    finding.notes.push_back({{},
                             fmt::format("write `connection {} on {} to {} on {} ( _async )` in the module",
                                         platform->name, name, part.name, name)});
    return true;
}

void check_part(const Component& module, const Declaration& part, const Context& behind, const Connected& outside,
                Diagnostics& out) {
    const auto* controller = dynamic_cast<const Component*>(&behind);
    std::vector<Loose> loose;
    const Connected inside = controller != nullptr ? Connected(*controller) : Connected(module);
    for (const Event* event : visible_events(behind)) {
        const Connection::End* out_end = outside.end(part, event->name);
        const Connection::End* in_end = controller != nullptr ? inside.end(*controller, event->name) : nullptr;
        if (controller != nullptr && report_missing_link(module, part, *controller, *event, outside, inside, out))
            continue;
        if (controller != nullptr && in_end != nullptr && out_end == nullptr)
            loose.push_back({event, in_end->event.span, fmt::format("`{}` is connected here inside", event->name)});
        if (controller == nullptr && out_end == nullptr)
            loose.push_back({event, event->name_span, fmt::format("`{}` is declared here", event->name)});
        if (controller != nullptr && in_end == nullptr && out_end != nullptr)
            out.report(rules::w_deaf, out_end->event.span, {event->name, describe_part(part, behind, "controller")})
                .notes.push_back({event->name_span, "the event is declared here"});
    }
    const std::string_view kind = controller != nullptr ? "controller" : "platform";
    const rules::Rule* rule = controller != nullptr ? &rules::w_loose_controller : &rules::w_loose_platform;
    if (module.dialect == Dialect::robosim) rule = &rules::w_loose_robosim;
    report_loose(*rule, part.name_span, loose, describe_part(part, behind, kind), module.name, out);
}

}  // namespace

void lint_events(const Component& component, Diagnostics& out) {
    if (component.kind == DeclKind::controller) return check_controller_events(component, out);
    const Connected outside(component);
    for (const Declaration* part : component.order) {
        const auto* behind = follow_to<Context>(part);
        if (behind != nullptr && (behind->kind == DeclKind::controller || behind->kind == DeclKind::platform))
            check_part(component, *part, *behind, outside, out);
    }
}

}  // namespace robochart::frontend
