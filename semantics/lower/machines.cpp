// SPDX-License-Identifier: Apache-2.0
// Lowers state machines and operations: nodes, transitions, guards (semantics 3.3, 3.4, 3.11).
#include "semantics/lower/machines.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "semantics/ir/visit.hpp"
#include "semantics/lower/programs.hpp"
#include "semantics/lower/registers.hpp"
#include "semantics/rules.hpp"

namespace robochart::ir {
namespace {

namespace ast = frontend;

constexpr std::size_t deepest_nesting = 64;

class MachineLowering {
public:
    MachineLowering(Lowering& lowering, const ast::Machine& source, Machine& machine)
        : lowering_(lowering), source_(source), machine_(machine) {}

    void run();

private:
    struct Pending {
        const ast::Transition* source;
        std::string path;   ///< the path of the container; "" at the top
        ExprPtr condition;  ///< the lowered condition alone; the guard may contain more
    };

    void declare_members();
    void lower_contracts();
    void check_required_variables();
    void add_nodes(const ast::NodeContainer& container, NodeId parent, std::size_t depth);
    NodeId add_node(const ast::State& source, NodeId parent);
    void collect_transitions(const ast::NodeContainer& container, const std::string& path);
    void check_level(const std::vector<NodeId>& level, const std::string& kind, const std::string& name,
                     diagnostics::Span span);
    void lower_actions(const ast::State& source, Node& node);
    void lower_transition(Pending& pending);
    void communication_and_guard(Pending& pending, Transition& transition);
    ExprPtr otherwise_condition(const Pending& pending, const Transition& transition);
    void finish_guards();
    void event_use(const Communication& communication, bool trigger);
    void event_uses();
    [[nodiscard]] std::string element_path(const std::string& path) const { return machine_.path + "::" + path; }

    Lowering& lowering_;
    const ast::Machine& source_;
    Machine& machine_;
    Names names_;
    std::vector<Pending> pending_;
    std::vector<std::pair<const ast::State*, NodeId>> states_;
};

NodeKind kind_of(ast::DeclKind kind) {
    if (kind == ast::DeclKind::initial) return NodeKind::initial;
    if (kind == ast::DeclKind::junction) return NodeKind::junction;
    if (kind == ast::DeclKind::probabilistic) return NodeKind::probabilistic;
    if (kind == ast::DeclKind::final) return NodeKind::final;
    return NodeKind::state;
}

/// Returns the action of the node for this kind of action.
StmtPtr& action_of(Node& node, ast::ActionKind kind) {
    if (kind == ast::ActionKind::entry) return node.entry;
    return kind == ast::ActionKind::during ? node.during : node.exit;
}

void MachineLowering::declare_members() {
    const bool operation = machine_.kind == MachineKind::operation;
    Declarations declared =
        lower_declarations(lowering_, source_, machine_.path, operation ? &source_.parameters : nullptr);
    if (machine_.robosim) {
        add_registers(lowering_, source_, machine_.path, declared, machine_.inputs);
        // an operation has no `cycleDef`, because it runs in the cycle of its caller
        declared.constants.push_back(cycle_constant(lowering_, declared.names, source_, true));
    }
    machine_.variables = std::move(declared.variables);
    machine_.constants = std::move(declared.constants);
    machine_.events = std::move(declared.events);
    machine_.clocks = std::move(declared.clocks);
    machine_.operations = std::move(declared.operations);
    machine_.interfaces = std::move(declared.interfaces);
    names_ = std::move(declared.names);
    names_.machine = &machine_;
}

/// Rejects a RoboSim machine that uses a variable which it requires outside of its contexts. No component provides such
/// a variable.
void MachineLowering::check_required_variables() {
    std::set<VariableId> used;
    visit_reads(machine_, [&](VariableId id) { used.insert(id); });
    visit_statements(machine_, [&](const Stmt& stmt) {
        if (stmt.kind == StmtKind::assign) used.insert(stmt.variable);
    });
    for (std::uint32_t i = 0; i < machine_.variables.size(); ++i) {
        Variable& variable = machine_.variables[i];
        if (variable.scope != VariableScope::required) continue;
        variable.scope = VariableScope::local;
        if (used.contains({i}))
            lowering_.diagnostics.report(
                rules::robosim_unsupported, source_.name_span,
                {"variable " + variable.name + ", which " + machine_.name + " requires outside of its contexts,",
                 "require its interface in the input or output context"});
    }
}

void MachineLowering::lower_contracts() {
    for (const auto& condition : source_.preconditions)
        machine_.preconditions.push_back(lower_expression(lowering_, names_, *condition, boolean_type));
    for (const auto& condition : source_.postconditions)
        machine_.postconditions.push_back(lower_expression(lowering_, names_, *condition, boolean_type));
}

NodeId MachineLowering::add_node(const ast::State& source, NodeId parent) {
    Node node;
    node.kind = kind_of(source.kind);
    node.name = source.name;
    node.parent = parent;
    node.path = parent.is_valid() ? machine_.nodes[parent.index].path + "::" + source.name : source.name;
    node.origin = origin_of(element_path(node.path), source.span);
    const NodeId id{static_cast<std::uint32_t>(machine_.nodes.size())};
    machine_.nodes.push_back(std::move(node));
    names_.nodes[&source] = id;
    states_.emplace_back(&source, id);
    NodeId& initial = parent.is_valid() ? machine_.nodes[parent.index].initial : machine_.initial;
    if (source.kind == ast::DeclKind::initial) initial = id;
    (parent.is_valid() ? machine_.nodes[parent.index].children : machine_.top).push_back(id);
    return id;
}

/// Adds the nodes in textual order. A composite state comes before the nodes inside it.
void MachineLowering::add_nodes(const ast::NodeContainer& container, NodeId parent, std::size_t depth) {
    if (depth > deepest_nesting) {
        lowering_.diagnostics.report(rules::too_deep, source_.span, {"states", std::to_string(deepest_nesting)});
        return;
    }
    for (const auto& state : container.nodes) {
        const NodeId id = add_node(*state, parent);
        add_nodes(*state, id, depth + 1);
    }
}

/// Collects the transitions of this level, then those of inner levels.
void MachineLowering::collect_transitions(const ast::NodeContainer& container, const std::string& path) {
    for (const auto& transition : container.transitions) pending_.push_back({transition.get(), path, nullptr});
    for (const auto& state : container.nodes) {
        const auto known = names_.nodes.find(state.get());
        if (known != names_.nodes.end()) collect_transitions(*state, machine_.nodes[known->second.index].path + "::");
    }
}

void MachineLowering::lower_actions(const ast::State& source, Node& node) {
    for (const auto& action : source.actions) {
        if (action.statement)
            action_of(node, action.kind) = lower_action(lowering_, names_, *action.statement, node.origin.element);
    }
}

/// Lowers the trigger and the guard. A predicate on the communication becomes part of the guard.
void MachineLowering::communication_and_guard(Pending& pending, Transition& transition) {
    const ast::Transition& source = *pending.source;
    if (source.trigger) {
        transition.trigger = lower_trigger(lowering_, names_, *source.trigger);
        names_.trigger_variable = source.trigger->variable_target;
        if (source.trigger->predicate)
            transition.guard = lower_expression(lowering_, names_, *source.trigger->predicate, boolean_type);
    }
    if (machine_.robosim) names_.stores = &transition.stores;
    if (source.condition) pending.condition = lower_expression(lowering_, names_, *source.condition, boolean_type);
    names_.stores = nullptr;
    names_.trigger_variable = nullptr;
    if (pending.condition) transition.guard = make_conjunction(transition.guard, pending.condition);
}

void MachineLowering::lower_transition(Pending& pending) {
    const ast::Transition& source = *pending.source;
    Transition transition;
    transition.name = source.name;
    transition.exec = source.exec;
    transition.origin = origin_of(element_path(pending.path + source.name), source.span);
    const auto from = names_.nodes.find(source.source);
    const auto to = names_.nodes.find(source.target);
    if (from == names_.nodes.end() || to == names_.nodes.end())
        return lowering_.report_unresolved("an end of transition '" + source.name + "'", source.span);
    transition.source = from->second;
    transition.target = to->second;
    communication_and_guard(pending, transition);
    for (const auto& reset : source.resets) {
        const auto clock = names_.clocks.find(reset.clock);
        if (clock != names_.clocks.end())
            transition.resets.push_back(clock->second);
        else
            lowering_.report_unresolved("clock '" + reset.name.text() + "'", reset.name.span);
    }
    if (source.deadline) transition.deadline = lower_duration(lowering_, names_, *source.deadline);
    if (source.probability)
        transition.probability = lower_expression(lowering_, names_, *source.probability, real_type);
    if (source.action) transition.action = lower_action(lowering_, names_, *source.action, transition.origin.element);
    const TransitionId id{static_cast<std::uint32_t>(machine_.transitions.size())};
    machine_.nodes[transition.source.index].outgoing.push_back(id);
    machine_.transitions.push_back(std::move(transition));
}

/// Returns the condition for `condition else`: no condition of the other transitions of the source is true. The
/// triggers of these transitions are ignored, and a missing condition counts as `true`.
ExprPtr MachineLowering::otherwise_condition(const Pending& pending, const Transition& transition) {
    ExprPtr none;
    for (const auto& sibling : pending_) {
        if (sibling.source->source != pending.source->source || sibling.source->otherwise) continue;
        const ExprPtr condition = sibling.condition ? sibling.condition : make_boolean(true, sibling.source->span);
        if (mentions_trigger_value(condition) &&
            (!transition.trigger || pending.source->trigger->event_target != sibling.source->trigger->event_target))
            lowering_.report_unsupported("`condition else` beside a condition on another trigger's value",
                                         pending.source->span);
        none = make_conjunction(none, make_negation(condition));
    }
    return none;
}

void MachineLowering::finish_guards() {
    for (std::size_t i = 0; i < machine_.transitions.size(); ++i) {
        Transition& transition = machine_.transitions[i];
        if (pending_[i].source->otherwise)
            transition.guard = make_conjunction(transition.guard, otherwise_condition(pending_[i], transition));
        transition.guard_timed = mentions_time(transition.guard);
    }
}

void MachineLowering::event_use(const Communication& communication, bool trigger) {
    if (!communication.event.is_valid()) return;
    Event& event = machine_.events[communication.event.index];
    const bool receives = trigger || communication.kind == CommKind::input;
    (receives ? event.input : event.output) = true;
}

void MachineLowering::event_uses() {
    for (const auto& transition : machine_.transitions)
        if (transition.trigger) event_use(*transition.trigger, true);
    visit_statements(machine_, [&](const Stmt& stmt) {
        if (stmt.kind == StmtKind::communicate) event_use(stmt.communication, false);
    });
}

/// Checks the nodes of a composite state or operation: there is exactly one initial junction, and the names are unique.
void MachineLowering::check_level(const std::vector<NodeId>& level, const std::string& kind, const std::string& name,
                                  diagnostics::Span span) {
    std::size_t initials = 0;
    std::map<std::string, diagnostics::Span> named;
    for (const NodeId id : level) {
        const Node& node = machine_.nodes[id.index];
        if (node.kind == NodeKind::initial) ++initials;
        if (node.kind != NodeKind::state && node.kind != NodeKind::final) continue;
        const auto [first, added] = named.try_emplace(node.name, node.origin.span);
        if (!added)
            lowering_.diagnostics.report(rules::declared_twice, node.origin.span, {name, "state", node.name})
                .notes.push_back({first->second, "the first one"});
    }
    if (level.empty() || initials == 1) return;
    lowering_.diagnostics.report(rules::no_beginning, span,
                                 {kind, name, initials == 0 ? "no" : std::to_string(initials)});
}

void MachineLowering::run() {
    declare_members();
    lower_contracts();
    add_nodes(source_, {}, 0);
    const bool operation = machine_.kind == MachineKind::operation;
    check_level(machine_.top, operation ? "operation" : "state machine", machine_.name, source_.name_span);
    for (const auto& [state, id] : states_)
        if (machine_.nodes[id.index].kind == NodeKind::state)
            check_level(machine_.nodes[id.index].children, "composite state", machine_.nodes[id.index].path,
                        state->name_span);
    collect_transitions(source_, "");
    for (const auto& [state, id] : states_) {
        Node node = machine_.nodes[id.index];
        lower_actions(*state, node);
        machine_.nodes[id.index] = std::move(node);
    }
    for (auto& pending : pending_) lower_transition(pending);
    if (machine_.robosim && !operation) check_required_variables();
    // If a transition was left out after an error, transitions and sources no longer correspond.
    if (machine_.transitions.size() == pending_.size()) finish_guards();
    event_uses();
}

}  // namespace

void lower_machine(Lowering& lowering, const ast::Machine& source, MachineId id) {
    Machine machine = std::move(lowering.system.machines[id.index]);
    machine.terminates = source.terminates;
    machine.robosim = source.dialect == ast::Dialect::robosim;
    machine.origin = origin_of(machine.path, source.span);
    MachineLowering(lowering, source, machine).run();
    lowering.system.machines[id.index] = std::move(machine);
}

}  // namespace robochart::ir
