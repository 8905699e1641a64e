// SPDX-License-Identifier: Apache-2.0
// Checks the rules about single connections and about the number of connections of an event (language reference 2: Cn2,
// Cn4, Cn11, types, C6, M3).
#include <fmt/format.h>

#include <map>

#include "frontend/checks/checks.hpp"
#include "frontend/names/scopes.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/types/types.hpp"

namespace robochart::frontend {

namespace {

std::string describe_values(const Event& event) {
    return event.type_expr ? "values of type " + to_string(event.type) : "no value";
}

/// Checks Cn4: a broadcast event connects only to a broadcast event, and not to a component of the same kind.
void check_broadcast(const Connection& connection, const Event& from, const Event& to, Diagnostics& out) {
    const Event& plain = from.broadcast ? to : from;
    if (from.broadcast != to.broadcast) {
        out.report(rules::cn4, connection.span, {from.broadcast ? from.name : to.name, plain.name})
            .notes.push_back({plain.name_span, fmt::format("`{}` is declared here without `_broadcast`", plain.name)});
        return;
    }
    const Declaration* a = follow_reference(connection.from.node_target);
    const Declaration* b = follow_reference(connection.to.node_target);
    const bool parts =
        a != nullptr && b != nullptr && a->kind == b->kind && connection.from.node_target != connection.to.node_target;
    if (from.broadcast && parts) out.report(rules::cn4_levels, connection.span, {std::string(to_text(a->kind))});
}

void check_events(const Connection& connection, const Event& from, const Event& to, Diagnostics& out) {
    check_broadcast(connection, from, to, out);
    const bool both_typed = from.type_expr && to.type_expr;
    const bool none_typed = !from.type_expr && !to.type_expr;
    const bool fit = none_typed || (both_typed && (!from.type || !to.type || is_compatible(from.type, to.type)));
    if (fit) return;
    auto& finding =
        out.report(rules::cn_types, connection.span, {from.name, describe_values(from), to.name, describe_values(to)});
    finding.notes.push_back({from.name_span, fmt::format("`{}` is declared here", from.name)});
    finding.notes.push_back({to.name_span, fmt::format("`{}` is declared here", to.name)});
}

bool is_kind(const Connection::End& end, DeclKind kind) {
    const Declaration* behind = follow_reference(end.node_target);
    return behind != nullptr && behind->kind == kind;
}

void check_asynchrony(const Component& component, const Connection& connection, Diagnostics& out) {
    const bool platform = is_kind(connection.from, DeclKind::platform) || is_kind(connection.to, DeclKind::platform);
    if (component.kind == DeclKind::module && platform && !connection.async) {
        const Span& event = connection.to.event.span;  // `[mult]` may follow
        out.report(rules::cn2, connection.span, {connection.from.node.text(), connection.to.node.text()})
            .fixes.push_back({{event.source, event.end, event.end}, " (_async)", "insert"});
    }
    const bool machines =
        is_kind(connection.from, DeclKind::state_machine) && is_kind(connection.to, DeclKind::state_machine);
    if (machines && connection.async) out.report(rules::cn11, connection.span);
}

/// Checks C6 and M3: an event is the source of at most one connection and the target of at most one connection.
class Uses {
public:
    Uses(const Component& component, Diagnostics& out) : component_(component), out_(out) {}

    void add(const Connection& connection, const Connection::End& end, bool beginning) {
        if (end.node_target == nullptr || end.event_target == nullptr) return;
        const auto key = std::pair(end.node.text(), end.event.text());
        const auto [first, fresh] = seen_[beginning ? 0 : 1].emplace(key, &connection);
        if (fresh) return;
        const Rule& rule = component_.kind == DeclKind::module ? rules::m3 : rules::c6;
        out_.report(rule, end.event.span, {end.event.text(), end.node.text(), beginning ? " from it" : " to it"})
            .notes.push_back({first->second->span, "this one"});
    }

private:
    const Component& component_;
    Diagnostics& out_;
    std::map<std::pair<std::string, std::string>, const Connection*> seen_[2];
};

}  // namespace

void check_connections(const Component& component, Diagnostics& out) {
    Uses uses(component, out);
    // In RoboSim a connection copies registers. Several connections may begin at an event, and none is synchronous.
    const bool synchronises = component.dialect == Dialect::robochart;
    for (const auto& connection : component.connections) {
        if (synchronises) {
            uses.add(*connection, connection->from, true);
            uses.add(*connection, connection->to, false);
            check_asynchrony(component, *connection, out);
        }
        const auto* from = dynamic_cast<const Event*>(connection->from.event_target);
        const auto* to = dynamic_cast<const Event*>(connection->to.event_target);
        if (from != nullptr && to != nullptr) check_events(*connection, *from, *to, out);
    }
}

}  // namespace robochart::frontend
