// SPDX-License-Identifier: Apache-2.0
// Finds variables that only grow (RC-W21). Every assignment adds to the variable (or subtracts from it, or multiplies
// it). At least one of these assignments can happen repeatedly, and no condition reads the variable, so its growth has
// no bound. Such a variable stops at the last value of its carrier in the finite instantiation, and at the last value
// of its type in generated code (semantics 3.13). Model and robot differ beyond the carrier.
#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "frontend/lint/lints.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/expression_visitor.hpp"
#include "frontend/types/typer.hpp"
#include "frontend/types/types.hpp"

namespace robochart::frontend {

namespace {

bool is_number(const Variable& variable) {
    if (variable.kind != DeclKind::variable || variable.type == nullptr) return false;
    const TypeForm form = variable.type->form;
    return form == TypeForm::nat || form == TypeForm::integer || form == TypeForm::real;
}

/// The direction in which an assignment changes x: `x + 1` is up, `x - 1` is down, `x * 2` is away from 0.
enum class Direction { up, down, away };

bool reads_variable(const Expr& expr, const Declaration& variable) {
    return strip_parentheses(expr).kind == ExprKind::name && strip_parentheses(expr).target == &variable;
}

/// Returns the direction of `x = value`, or no value if it is not a step or can go both ways.
std::optional<Direction> direction_of(const Expr& value, const Declaration& variable) {
    const Expr& sum = strip_parentheses(value);
    if (sum.kind != ExprKind::binary) return std::nullopt;
    const bool first = reads_variable(*sum.args[0], variable);
    const bool second = reads_variable(*sum.args[1], variable);
    if (first == second) return std::nullopt;
    const std::optional<double> step = number_of(strip_parentheses(*sum.args[first ? 1 : 0]));
    if (!step) return std::nullopt;
    if (sum.binary == BinaryOp::plus && *step > 0) return Direction::up;
    if (sum.binary == BinaryOp::minus && first && *step > 0) return Direction::down;
    if (sum.binary == BinaryOp::times && *step > 1) return Direction::away;
    return std::nullopt;
}

/// The analysis of one variable of the machine.
struct Growth {
    bool bounded = false;                ///< a condition reads the variable, or an assignment in another form writes it
    bool read = false;                   ///< something other than its own steps reads the variable
    std::optional<Direction> direction;  ///< the common direction of its steps
    const Stmt* again = nullptr;         ///< the first step that can happen repeatedly
};

/// The strongly connected components of the transitions of one container. Transitions on cycles are in the same
/// component.
class Cycles {
public:
    explicit Cycles(const NodeContainer& container) {
        for (const auto& node : container.nodes) numbers_.emplace(node.get(), numbers_.size());
        boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS> graph(numbers_.size());
        for (const auto& transition : container.transitions) {
            const auto source = numbers_.find(transition->source), target = numbers_.find(transition->target);
            if (source != numbers_.end() && target != numbers_.end())
                boost::add_edge(source->second, target->second, graph);
        }
        component_.resize(numbers_.size());
        boost::strong_components(graph,
                                 boost::make_iterator_property_map(component_.begin(), boost::identity_property_map()));
        for (const auto& transition : container.transitions)
            if (contain(*transition)) on_cycle_.insert(transition->source);
    }

    [[nodiscard]] bool contain(const Transition& transition) const {
        const auto source = numbers_.find(transition.source), target = numbers_.find(transition.target);
        return source != numbers_.end() && target != numbers_.end() &&
               component_[source->second] == component_[target->second];
    }
    [[nodiscard]] bool contain(const State& node) const { return on_cycle_.contains(&node); }

private:
    std::unordered_map<const State*, std::size_t> numbers_;
    std::vector<std::size_t> component_;
    std::unordered_set<const State*> on_cycle_;
};

class Growing {
public:
    /// Ignores variables that a called operation writes, because the operation may reset them.
    Growing(const Machine& machine, const WrittenBy& written_by) {
        const auto written = [&](const std::string& name) {
            return std::ranges::any_of(written_by, [&](const auto& entry) { return entry.second.contains(name); });
        };
        for (const auto& variable : machine.variables)
            if (is_number(*variable) && !written(variable->name)) variables_[variable.get()];
    }

    void read_container(const NodeContainer& container, bool repeated) {
        const Cycles cycles(container);
        for (const auto& transition : container.transitions) {
            if (transition->condition) read_condition(*transition->condition);
            if (transition->trigger) read_communication(*transition->trigger);
            if (transition->action) read_action(*transition->action, repeated || cycles.contain(*transition));
        }
        for (const auto& node : container.nodes) {
            const bool again = repeated || cycles.contain(*node);
            for (const Action& action : node->actions)
                if (action.statement) read_action(*action.statement, again);
            this->read_container(*node, again);
        }
    }

    void report(const Machine& machine, Diagnostics& out) const {
        for (const auto& variable : machine.variables) {
            const auto found = variables_.find(variable.get());
            if (found == variables_.end() || found->second.bounded || !found->second.read) continue;
            if (found->second.again == nullptr) continue;
            out.report(rules::w_grows, found->second.again->span, {variable->name});
        }
    }

private:
    void read_condition(const Expr& expr) {
        walk_tree(expr, [&](const Expr& part) {
            const auto found = part.kind == ExprKind::name ? variables_.find(part.target) : variables_.end();
            if (found != variables_.end()) found->second.bounded = true;
        });
    }

    /// Records the variables that an expression reads. A read in an assignment to the same variable is ignored.
    void note_reads(const Expr& expr, const Stmt& statement) {
        const Declaration* const own = statement.target ? assigned_root(*statement.target) : nullptr;
        walk_tree(expr, [&](const Expr& part) {
            const auto found = part.kind == ExprKind::name ? variables_.find(part.target) : variables_.end();
            if (found != variables_.end() && part.target != own) found->second.read = true;
        });
    }

    void read_communication(const Communication& communication) {
        const auto found = variables_.find(communication.variable_target);
        if (found != variables_.end()) found->second.bounded = true;
    }

    void read_action(const Stmt& action, bool repeated) {
        walk_tree(action, [&](const Stmt& statement) {
            if (statement.condition) read_condition(*statement.condition);
            for_expressions(statement, [&](const Expr& expr) { note_reads(expr, statement); });
            if (statement.communication) read_communication(*statement.communication);
            if (statement.kind == StmtKind::assignment && statement.target) read_assignment(statement, repeated);
        });
    }

    void read_assignment(const Stmt& statement, bool repeated) {
        const auto found = variables_.find(assigned_root(*statement.target));
        if (found == variables_.end()) return;
        Growth& growth = found->second;
        const auto direction =
            statement.value ? direction_of(*statement.value, *found->first) : std::optional<Direction>();
        growth.bounded = growth.bounded || !direction || (growth.direction && growth.direction != direction);
        growth.direction = direction;
        if (repeated && growth.again == nullptr) growth.again = &statement;
    }

    std::unordered_map<const Declaration*, Growth> variables_;
};

}  // namespace

void lint_growth(const Machine& machine, const WrittenBy& written_by, Diagnostics& out) {
    if (machine.kind == DeclKind::operation) return;  // each call resets the variables of an operation
    Growing growing(machine, written_by);
    growing.read_container(machine, false);
    growing.report(machine, out);
}

}  // namespace robochart::frontend
