// SPDX-License-Identifier: Apache-2.0
// Resolves bodies: initial values, contracts, nodes, transitions, connections and parameters of assertions.
#include <fmt/format.h>

#include <algorithm>

#include "frontend/resolve/resolver.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/expression_visitor.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::frontend {

void Resolver::function_body(File& file, Function& function) {
    Surroundings around{{&file, &function}, nullptr, &function, nullptr, {}};
    for (const VariablePtr& parameter : function.parameters) around.bound.push_back(parameter.get());
    // RoboTool ignores contracts. A wrong contract is therefore dropped as a whole, and the function counts as
    // undefined.
    diagnostics::Diagnostics found;
    diagnostics::Diagnostics& out = finder_.redirect_reports(found);
    for (const ExprPtr& condition : function.preconditions) typer_.check_boolean(condition, around, "a precondition");
    for (const ExprPtr& condition : function.postconditions) typer_.check_boolean(condition, around, "a postcondition");
    finder_.redirect_reports(out);
    for (const diagnostics::Diagnostic& finding : found.sorted_findings()) {
        if (finding.rule->severity == diagnostics::Severity::error) {
            out.report(rules::wrong_contract, finding.span, {function.name, finding.message()}).notes = finding.notes;
        } else {
            diagnostics::Diagnostic& again = out.report(*finding.rule, finding.span, finding.arguments);
            again.notes = finding.notes;
            again.fixes = finding.fixes;
        }
    }
    if (found.ok()) return;
    for (const auto* conditions : {&function.preconditions, &function.postconditions})
        for (const ExprPtr& condition : *conditions) condition->type = nullptr;
}

void Resolver::context_body(File& file, Context& context) {
    const Scope scope = scope_of(context);
    auto* machine = dynamic_cast<Machine*>(&context);
    const Registers registers = registers_of(context);
    Surroundings around{{&file, &context}, &scope, nullptr, machine, {}};
    const bool robosim = context.dialect == Dialect::robosim;
    if (robosim && machine != nullptr) around.registers = &registers;
    if (robosim && context.cycle) typer_.assign_type(context.cycle, around);
    for (auto& variable : context.variables) {
        if (!variable->initial) continue;
        const TypePtr value = typer_.assign_type(variable->initial, around);
        if (value && variable->type && !is_compatible(value, variable->type))
            finder_.out().report(rules::initial_type, variable->initial->span,
                                 {variable->name, to_string(variable->type), to_string(value)});
    }
    if (machine != nullptr) machine_body(*machine, around);
}

void Resolver::machine_body(Machine& machine, Surroundings& around) {
    for (const ExprPtr& condition : machine.preconditions) typer_.check_boolean(condition, around, "a precondition");
    for (const ExprPtr& condition : machine.postconditions) typer_.check_boolean(condition, around, "a postcondition");
    resolve_container(machine, machine, around);
}

void Resolver::resolve_container(NodeContainer& container, const Machine& machine, Surroundings& around) {
    for (auto& state : container.nodes) {
        for (Action& action : state->actions)
            if (action.statement) typer_.check_statement(*action.statement, around);
        this->resolve_container(*state, machine, around);
    }
    NodeNames names;
    for (const auto& node : container.nodes) names.emplace(node->name, node.get());
    for (auto& transition : container.transitions) this->resolve_transition(*transition, names, machine, around);
}

void Resolver::resolve_transition(Transition& transition, const NodeNames& names, const Machine& machine,
                                  Surroundings& around) {
    transition.source = find_node(transition.from, transition, "source", names, machine);
    transition.target = find_node(transition.to, transition, "target", names, machine);
    if (transition.trigger) typer_.check_communication(*transition.trigger, around, true);
    if (transition.probability) typer_.assign_type(transition.probability, around);
    for (Transition::Reset& reset : transition.resets) reset.clock = typer_.find_clock(reset.name, around, rules::ts1);
    if (transition.deadline) {
        const TypePtr bound = simplify_type(typer_.assign_type(transition.deadline, around));
        if (bound && !is_compatible(bound, make_type(TypeForm::real)))
            finder_.out().report(rules::deadline_type, transition.deadline->span, {to_string(bound)});
    }
    if (transition.condition) {
        const TypePtr condition = typer_.assign_type(transition.condition, around);
        if (condition && !is_compatible(condition, make_type(TypeForm::boolean)))
            finder_.out().report(rules::condition_type, transition.condition->span, {to_string(condition)});
    }
    if (transition.action) typer_.check_statement(*transition.action, around);
}

/// Returns the node with this name in the transition's own container (T1). If the node is elsewhere, the message says
/// where.
const State* Resolver::find_node(const QualifiedName& name, const Transition& transition, std::string_view role,
                                 const NodeNames& names, const Machine& machine) {
    if (name.empty()) return nullptr;
    if (const auto found = names.find(name.parts.front()); found != names.end()) return found->second;
    const State* elsewhere = nullptr;
    walk_tree(machine, [&](const NodeContainer& other) {
        const auto found =
            std::ranges::find_if(other.nodes, [&](const auto& n) { return n->name == name.parts.front(); });
        if (elsewhere == nullptr && found != other.nodes.end()) elsewhere = found->get();
    });
    if (machine.broken && elsewhere != nullptr) return nullptr;  // a misplaced brace may have moved the node
    if (elsewhere != nullptr) {
        finder_.out()
            .report(rules::t1, name.span, {std::string(role), name.text(), transition.name})
            .notes.push_back({elsewhere->name_span,
                              fmt::format("`{}` is declared here, in `{}`", elsewhere->name, elsewhere->parent->name)});
        return nullptr;
    }
    finder_.report_unknown(name, "node", fmt::format("beside transition `{}`", transition.name),
                           finder_.keys_of(names));
    return nullptr;
}

// ---------------------------------------------------------------- connections

void Resolver::resolve_connections(Component& component) {
    Ends ends{component, {}, {}};
    for (const Declaration* part : component.order) ends.parts.emplace(part->name, part);
    for (auto& connection : component.connections) {
        connection_end(connection->from, ends);
        connection_end(connection->to, ends);
    }
}

void Resolver::connection_end(Connection::End& end, Ends& ends) {
    const Component& component = ends.component;
    const bool is_module = component.kind == DeclKind::module;
    const auto part = ends.parts.find(end.node.text());
    if (part != ends.parts.end()) end.node_target = part->second;
    if (!is_module && end.node_target == nullptr && end.node.text() == component.name) end.node_target = &component;
    const Declaration* behind = follow_reference(end.node_target);
    // True for an unresolved reference, which is reported.
    const bool known = end.node_target != nullptr && behind == nullptr;
    // where it is declared
    const bool fits =
        behind != nullptr && (is_module ? behind->kind == DeclKind::platform || behind->kind == DeclKind::controller
                                        : behind->kind == DeclKind::state_machine || behind == &component);
    if (fits) return connection_event(end, ends);
    if (!known) wrong_node(end, ends);
}

/// Reports Cn1 or Cn3: the connected node is not a component of this controller or module.
void Resolver::wrong_node(Connection::End& end, const Ends& ends) {
    const Component& component = ends.component;
    const bool is_module = component.kind == DeclKind::module;
    const bool exists = end.node_target != nullptr || end.node.text() == component.name ||
                        finder_.names().find_anywhere(
                            end.node.parts.back(), {DeclKind::state_machine, DeclKind::controller, DeclKind::platform,
                                                    DeclKind::reference, DeclKind::module}) != nullptr;
    end.node_target = nullptr;
    if (exists) {
        finder_.out().report(is_module ? rules::cn1 : rules::cn3, end.node.span, {end.node.text(), component.name});
        return;
    }
    finder_.report_unknown(end.node, "component", fmt::format("in {} `{}`", to_text(component.kind), component.name),
                           finder_.keys_of(ends.parts));
}

/// Finds the event of a connection end in the component at that end. `check_ends` reports an unknown event.
void Resolver::connection_event(Connection::End& end, Ends& ends) {
    const auto* behind = follow_to<Context>(end.node_target);
    if (behind == nullptr) return;
    auto known = ends.scopes.find(behind);
    if (known == ends.scopes.end()) known = ends.scopes.emplace(behind, scope_of(*behind)).first;
    const auto found = known->second.events.find(end.event.text());
    if (found != known->second.events.end()) end.event_target = found->second;
}

}  // namespace robochart::frontend
