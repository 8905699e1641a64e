// SPDX-License-Identifier: Apache-2.0
// Finds inputs that may be taken twice: follows the transitions that a machine may take in a cycle after it has taken
// an input.
#include "frontend/cycles/event_reuse.hpp"

#include <algorithm>

#include "frontend/syntax/expression_visitor.hpp"

namespace robochart::frontend {

namespace {

bool is_positive_literal(const Expr& expr) {
    return expr.kind == ExprKind::integer &&
           std::ranges::any_of(expr.text, [](char c) { return c >= '1' && c <= '9'; });
}

const State* initial_of(const NodeContainer& container) {
    const auto found =
        std::ranges::find(container.nodes, DeclKind::initial, [](const auto& node) { return node->kind; });
    return found == container.nodes.end() ? nullptr : found->get();
}

std::vector<const Transition*> leaving(const NodeContainer& container, const State& node) {
    std::vector<const Transition*> result;
    for (const auto& transition : container.transitions)
        if (transition->source == &node) result.push_back(transition.get());
    return result;
}

bool entry_waits(const State& state, const Callers& callers) {
    return std::ranges::any_of(state.actions, [&](const Action& action) {
        return action.kind == ActionKind::entry && action.statement && surely_waits(*action.statement, callers);
    });
}

/// True if the operation certainly ends a cycle on the path from its initial junction to its first branch.
bool operation_waits(const Machine& operation, const Callers& callers) {
    const State* node = initial_of(operation);
    for (std::size_t steps = 0; node != nullptr && steps <= operation.nodes.size(); ++steps) {
        if (node->kind == DeclKind::state && entry_waits(*node, callers)) return true;
        const std::vector<const Transition*> ways = leaving(operation, *node);
        if (ways.size() != 1) return false;
        if (ways[0]->action && surely_waits(*ways[0]->action, callers)) return true;
        node = ways[0]->target;
    }
    return false;
}

}  // namespace

bool surely_waits(const Stmt& action, const Callers& callers) {
    switch (action.kind) {
        case StmtKind::wait:
        case StmtKind::wait_interval:
            return is_positive_literal(*action.value);
        case StmtKind::sequence:
        case StmtKind::parenthesised:
        case StmtKind::deadline:
            return std::ranges::any_of(action.body, [&](const StmtPtr& part) { return surely_waits(*part, callers); });
        case StmtKind::if_then_else:
            return action.body.size() > 1 &&
                   std::ranges::all_of(action.body, [&](const StmtPtr& part) { return surely_waits(*part, callers); });
        case StmtKind::call: {
            const Machine* const definition = callers.definition(action.name.parts.back());
            return definition != nullptr && operation_waits(*definition, callers);
        }
        case StmtKind::skip:
        case StmtKind::assignment:
        case StmtKind::communication:
        case StmtKind::clock_reset:
        case StmtKind::exec:
        case StmtKind::error:
            break;
    }
    return false;
}

namespace {

/// Follows a machine in the cycle in which it takes an input.
class SameCycle {
public:
    SameCycle(const Callers& callers, const std::string& event) : callers_(callers), event_(event) {
        note_containers(callers.root(), nullptr);
    }

    /// True if the machine may be offered the input again after it has taken it.
    bool takes_twice() {
        for_transitions(callers_.root(), [&](const Transition& transition) {
            if (takes(transition)) follow(transition);
        });
        return again_;
    }

private:
    struct NodePlace {
        const NodeContainer* container = nullptr;
        const State* around = nullptr;  ///< null: the machine
    };

    void note_containers(const NodeContainer& container, const State* around) {
        for (const auto& node : container.nodes) {
            node_places_[node.get()] = {&container, around};
            if (!node->nodes.empty()) note_containers(*node, node.get());
        }
    }

    bool takes(const Transition& transition) const {
        return transition.trigger && transition.trigger->event_target != nullptr &&
               transition.trigger->event_target->name == event_;
    }

    void follow(const Transition& transition) {
        if (transition.action && surely_waits(*transition.action, callers_)) return;
        if (transition.target != nullptr) enter(*transition.target);
    }

    void enter(const State& node) {
        if (!seen_.insert(&node).second) return;
        if (node.kind == DeclKind::state) {
            if (entry_waits(node, callers_)) return;
            const State* const inner = initial_of(node);
            if (inner != nullptr) return enter(*inner);
        }
        const bool rests = node.kind == DeclKind::state || node.kind == DeclKind::final;
        for (const State* level = &node; level != nullptr;) {
            const NodePlace place = node_places_.at(level);
            for (const Transition* transition : leaving(*place.container, *level)) {
                again_ = again_ || takes(*transition);
                follow(*transition);
            }
            level = rests ? place.around : nullptr;
        }
    }

    const Callers& callers_;
    const std::string& event_;
    std::map<const State*, NodePlace> node_places_;
    std::set<const State*> seen_;
    bool again_ = false;
};

/// Returns the inputs that statements of the machine, or the operations that it calls, take.
std::set<std::string> taken_in_actions(const Callers& callers, const Usage& usage) {
    std::set<std::string> result;
    const auto add_statements = [&](const NodeContainer& top) {
        for_actions(top, [&](const Stmt& action) {
            walk_tree(action, [&](const Stmt& statement) {
                if (statement.kind == StmtKind::communication && is_input(*statement.communication, false) &&
                    statement.communication->event_target != nullptr)
                    result.insert(statement.communication->event_target->name);
            });
        });
    };
    add_statements(callers.root());
    for (const auto& [name, signature] : usage.software) {
        const Machine& definition = *callers.definition(name);
        for (const auto& [input, event] : usage_of(definition, callers).inputs) result.insert(input);
    }
    return result;
}

}  // namespace

std::set<std::string> reusable_inputs(const Callers& callers) {
    const Usage usage = usage_of(callers.root(), callers);
    std::set<std::string> result = taken_in_actions(callers, usage);
    for (const auto& [input, event] : usage.inputs)
        if (!result.contains(input) && SameCycle(callers, input).takes_twice()) result.insert(input);
    return result;
}

}  // namespace robochart::frontend
