// SPDX-License-Identifier: Apache-2.0
// Events that are not connected beyond their component (semantics 3.9). An event without a connection is hidden: its
// triggers fire spontaneously and its outputs never wait. An event connected to a component that never takes part in it
// can never happen.
#include <fmt/format.h>

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
class Traffic {
public:
    Traffic(const Machine& machine, const std::map<std::string_view, const Machine*>& defined) : defined_(defined) {
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

/// The connected events of each component and of the container itself.
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

std::string describe_part(const Declaration& part, const Declaration& behind, std::string_view kind) {
    if (&part == &behind || part.name == behind.name) return fmt::format("{} `{}`", kind, behind.name);
    return fmt::format("`{}` ({} `{}`)", part.name, kind, behind.name);
}

/// An event without a connection, and the place where the machine uses it.
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
    const Traffic traffic(machine, defined);
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

void check_controller(const Component& controller, Diagnostics& out) {
    const Connected connected(controller);
    std::map<std::string_view, const Machine*> defined;
    for (const Machine* operation : defined_operations(controller)) defined.emplace(operation->name, operation);
    for (const Declaration* part : controller.order) {
        const auto* machine = follow_to<Machine>(part);
        if (machine != nullptr && machine->kind == DeclKind::state_machine)
            check_machine(controller, *part, *machine, connected, defined, out);
    }
}

void check_part(const Component& module, const Declaration& part, const Context& behind, const Connected& outside,
                Diagnostics& out) {
    const auto* controller = dynamic_cast<const Component*>(&behind);
    std::vector<Loose> loose;
    const Connected inside = controller != nullptr ? Connected(*controller) : Connected(module);
    for (const Event* event : visible_events(behind)) {
        const Connection::End* out_end = outside.end(part, event->name);
        const Connection::End* in_end = controller != nullptr ? inside.end(*controller, event->name) : nullptr;
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
    if (component.kind == DeclKind::controller) return check_controller(component, out);
    const Connected outside(component);
    for (const Declaration* part : component.order) {
        const auto* behind = follow_to<Context>(part);
        if (behind != nullptr && (behind->kind == DeclKind::controller || behind->kind == DeclKind::platform))
            check_part(component, *part, *behind, outside, out);
    }
}

}  // namespace robochart::frontend
