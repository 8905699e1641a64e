// SPDX-License-Identifier: Apache-2.0
// Checks the directions of connections (language reference 2: Cn5 to Cn9). Triggers and input statements receive. The
// statements `e`, `e!v` and `e.v` send. An operation that the controller defines counts as part of the machine that
// calls it. Statements in parentheses are included (RoboTool ignores them).
#include <fmt/format.h>

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "frontend/checks/checks.hpp"
#include "frontend/names/scopes.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/expression_visitor.hpp"

namespace robochart::frontend {

namespace {

/// The events that a machine receives and sends, by name. " via the operation …" is added if a called operation uses
/// the event.
struct Traffic {
    std::map<std::string_view, std::string> receives, sends;
};

class TrafficReader {
public:
    explicit TrafficReader(const Component& controller) {
        for (const Machine* defined : defined_operations(controller)) operations_[defined->name].push_back(defined);
    }

    /// Returns the traffic of a machine. The result is cached, because a machine may have many connections.
    const Traffic& read(const Machine& machine) {
        const auto [known, fresh] = read_.try_emplace(&machine);
        if (!fresh) return known->second;
        seen_.clear();
        add(machine, "");
        known->second = std::exchange(traffic_, {});
        return known->second;
    }

private:
    void add(const Machine& machine, const std::string& via) {
        if (!seen_.insert(&machine).second) return;
        walk_tree(machine, [&](const NodeContainer& container) {
            for (const auto& transition : container.transitions)
                if (transition->trigger && transition->trigger->event_target != nullptr)
                    traffic_.receives.emplace(transition->trigger->event_target->name, via);
        });
        for_actions(machine, [&](const Stmt& action) {
            walk_tree(action, [&](const Stmt& statement) { this->read_statement(statement, via); });
        });
    }

    void read_statement(const Stmt& statement, const std::string& via) {
        if (statement.kind == StmtKind::communication && statement.communication->event_target != nullptr) {
            const bool input = statement.communication->kind == CommKind::input;
            (input ? traffic_.receives : traffic_.sends).emplace(statement.communication->event_target->name, via);
        }
        if (statement.kind != StmtKind::call || statement.declaration == nullptr) return;
        const auto defined = operations_.find(statement.declaration->name);
        if (defined == operations_.end()) return;
        for (const Machine* operation : defined->second)
            add(*operation, via.empty() ? fmt::format(" via operation `{}`", operation->name) : via);
    }

    std::map<std::string_view, std::vector<const Machine*>> operations_;
    std::map<const Machine*, Traffic> read_;  // for lookup only; the order of pointers is never used
    std::set<const Machine*> seen_;
    Traffic traffic_;
};

/// Checks Cn8 and Cn9: the direction of a one-way connection is that in which the machine communicates.
void check_machine_end(TrafficReader& reader, const Connection& connection, const Connection::End& end, bool beginning,
                       Diagnostics& out) {
    const auto* machine = follow_to<Machine>(end.node_target);
    if (machine == nullptr || end.event_target == nullptr || connection.multiple) return;
    const Traffic& traffic = reader.read(*machine);
    const auto& wrong = beginning ? traffic.receives : traffic.sends;
    const auto found = wrong.find(end.event_target->name);
    if (found == wrong.end()) return;
    out.report(beginning ? rules::cn9 : rules::cn8, end.event.span,
               {end.event.text(), end.node.text(), machine->name, found->second});
}

/// For one of a controller's own events: whether some connection inside the controller ends at it, begins at it, or is
/// bidirectional.
struct Inside {
    const Connection* from = nullptr;
    const Connection* to = nullptr;
    const Connection* both = nullptr;
};

/// Caches the connections inside the controllers of a module.
class Insides {
public:
    Inside connections_inside(const Component& controller, const std::string& event) {
        const auto [known, fresh] = controllers_.try_emplace(&controller);
        if (fresh)
            for (const auto& connection : controller.connections) {
                add(known->second, controller, *connection, connection->from, &Inside::from);
                add(known->second, controller, *connection, connection->to, &Inside::to);
            }
        const auto found = known->second.find(event);
        return found != known->second.end() ? found->second : Inside{};
    }

private:
    using Events = std::map<std::string, Inside>;

    static void add(Events& events, const Component& controller, const Connection& connection,
                    const Connection::End& end, const Connection* Inside::*way) {
        if (end.node_target != &controller) return;
        events[end.event.text()].*(connection.multiple ? &Inside::both : way) = &connection;
    }

    std::map<const Component*, Events> controllers_;  // for lookup only; the order of pointers is never used
};

/// Checks Cn5 to Cn7: a connection of a module to a controller continues inside the controller in the same direction.
void check_controller_end(Insides& insides, const Connection& connection, const Connection::End& end, bool beginning,
                          Diagnostics& out) {
    const auto* controller = follow_to<Component>(end.node_target);
    if (controller == nullptr || controller->kind != DeclKind::controller || end.event_target == nullptr) return;
    const Inside found = insides.connections_inside(*controller, end.event.text());
    const bool connected = found.from != nullptr || found.to != nullptr || found.both != nullptr;
    const auto report = [&](const Rule& rule, const Connection& other) {
        out.report(rule, end.event.span, {end.event.text(), end.node.text()})
            .notes.push_back({other.span, "the connection inside"});
    };
    if (connection.multiple) {
        if (connected && found.both == nullptr) report(rules::cn5, found.from != nullptr ? *found.from : *found.to);
        return;
    }
    if (found.both != nullptr) report(beginning ? rules::cn7 : rules::cn6, *found.both);
    const Connection* against = beginning ? found.from : found.to;
    if (against != nullptr) report(beginning ? rules::cn7_direction : rules::cn6_direction, *against);
}

}  // namespace

void check_directions(const Component& component, Diagnostics& out) {
    Insides insides;
    TrafficReader reader(component);
    for (const auto& connection : component.connections)
        for (const bool beginning : {true, false}) {
            const Connection::End& end = beginning ? connection->from : connection->to;
            if (component.kind == DeclKind::module) check_controller_end(insides, *connection, end, beginning, out);
            if (component.kind == DeclKind::controller) check_machine_end(reader, *connection, end, beginning, out);
        }
}

}  // namespace robochart::frontend
