// SPDX-License-Identifier: Apache-2.0
// Reports variables that are read before they are set (semantics 3.6: until then they have a default value, `true` for
// a boolean). A forward analysis computes the variables that are certainly set. It follows the order of semantics 3.4:
// trigger value, guard, exit actions from inside out, action, entry actions from outside in. A during action may be
// interrupted at any point, so it does not certainly set a variable. A transition of a composite state may be taken in
// any settled node inside the state.
#include <cstdint>
#include <deque>

#include "frontend/lint/lints.hpp"
#include "frontend/names/scopes.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/expression_visitor.hpp"
#include "frontend/types/types.hpp"

namespace robochart::frontend {

namespace {

/// A set of variables of the machine. Initially it contains all variables, because no path to the node is known yet.
class Bits {
public:
    explicit Bits(std::size_t size = 0, bool full = false) : words_((size + 63) / 64, full ? ~std::uint64_t{0} : 0) {}
    void insert(std::size_t i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }
    [[nodiscard]] bool contains(std::size_t i) const { return (words_[i / 64] >> (i % 64) & 1U) != 0; }
    void unite(const Bits& other) {
        for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
    }
    /// Removes the elements that are not in `other`. Returns true if an element was removed.
    bool intersect(const Bits& other) {
        bool changed = false;
        for (std::size_t i = 0; i < words_.size(); ++i) {
            changed = changed || (words_[i] & ~other.words_[i]) != 0;
            words_[i] &= other.words_[i];
        }
        return changed;
    }

private:
    std::vector<std::uint64_t> words_;
};

std::string default_of(const TypePtr& type) {
    constexpr const char* other = "the default of its type";
    if (type == nullptr) return other;
    switch (type->form) {
        case TypeForm::boolean:
            return "true";
        case TypeForm::nat:
        case TypeForm::integer:
        case TypeForm::real:
            return "0";
        case TypeForm::sequence:
            return "the empty sequence";
        case TypeForm::set:
            return "the empty set";
        case TypeForm::enumeration:
            if (type->declaration != nullptr && !type->declaration->literals.empty())
                return type->declaration->literals.front()->name;
            return "the first literal";
        case TypeForm::any:
        case TypeForm::string:
        case TypeForm::given:
        case TypeForm::record:
        case TypeForm::variable:
        case TypeForm::product:
        case TypeForm::function:
        case TypeForm::relation:
        case TypeForm::vector:
        case TypeForm::matrix:
            break;
    }
    return other;
}

class Flow {
public:
    Flow(const Machine& machine, const WrittenBy& written_by, Diagnostics& out)
        : machine_(machine), written_by_(written_by), out_(out) {
        const std::vector<const Variable*> required = required_variables(machine);
        const std::unordered_set<const Variable*> shared(required.begin(), required.end());
        for (const Variable* variable : visible_variables(machine))
            if (!shared.contains(variable)) track_variable(*variable);
        reported_ = Bits(variables_.size());
    }

    void run() {
        if (variables_.empty()) return;
        add_points(machine_, nullptr);
        for (const auto& node : machine_.nodes)
            if (node->kind == DeclKind::initial) reach_node(*node, Bits(variables_.size()));
        while (!open_.empty()) {
            const State* node = open_.front();
            open_.pop_front();
            points_.at(node).queued = false;
            pass_node(*node);
        }
        read(machine_);
    }

private:
    struct Point {
        const State* parent = nullptr;
        std::vector<const Transition*> out;
        Bits in, settled, leave, inner_leave;
        Bits entry, exit;  ///< the variables that its actions certainly set
        bool queued = false, reached = false, passed = false;
    };

    /// Returns the variables that are certainly set before the actions of this kind.
    static const Bits& set_before(const Point& point, ActionKind kind) {
        switch (kind) {
            case ActionKind::entry:
                return point.in;
            case ActionKind::during:
                return point.settled;
            case ActionKind::exit:
                break;
        }
        return point.inner_leave;
    }

    void track_variable(const Variable& variable) {
        if (variable.kind != DeclKind::variable || variable.initial) return;
        if (index_.emplace(&variable, variables_.size()).second) variables_.push_back(&variable);
    }

    void add_points(const NodeContainer& container, const State* parent) {
        const Bits all(variables_.size(), true);
        for (const auto& node : container.nodes) {
            Point point{parent, {}, all, all, all, all, Bits(variables_.size()), Bits(variables_.size())};
            for (const Action& action : node->actions)
                if (action.statement && action.kind != ActionKind::during)
                    add_set_variables(*action.statement, action.kind == ActionKind::entry ? point.entry : point.exit,
                                      false);
            points_.emplace(node.get(), std::move(point));
            add_points(*node, node.get());
        }
        for (const auto& transition : container.transitions)
            if (transition->source != nullptr) points_.at(transition->source).out.push_back(transition.get());
    }

    // ------------------------------------------------------------ variables that are certainly set

    void reach_node(const State& node, const Bits& with) {
        Point& point = points_.at(&node);
        const bool changed = point.in.intersect(with);
        if ((!changed && point.reached) || point.queued) {
            point.reached = true;
            return;
        }
        point.reached = point.queued = true;
        open_.push_back(&node);
    }

    void pass_node(const State& node) {
        Point& point = points_.at(&node);
        Bits entered = point.in;
        entered.unite(point.entry);
        bool composite = false;
        for (const auto& inner : node.nodes)
            if (inner->kind == DeclKind::initial) {
                composite = true;
                reach_node(*inner, entered);
            }
        if (!composite) propagate_settled(node, entered, entered);
    }

    /// Records that the node can be settled with the variables in `settled` set, and can be left with those in
    /// `inner_leave` set. The enclosing states are updated too.
    void propagate_settled(const State& node, const Bits& settled, const Bits& inner_leave) {
        const State* at = &node;
        Bits now = settled;
        Bits leaving = inner_leave;
        while (at != nullptr) {
            Point& point = points_.at(at);
            const bool less_settled = point.settled.intersect(now);
            const bool less_leaving = point.inner_leave.intersect(leaving);
            if (point.passed && !less_settled && !less_leaving) return;
            point.passed = true;
            Bits after = point.inner_leave;
            after.unite(point.exit);
            point.leave = after;
            for (const Transition* way : point.out) take_transition(*way, point);
            const bool rests = at->kind == DeclKind::state || at->kind == DeclKind::final;
            now = point.settled;
            leaving = point.leave;
            at = rests ? point.parent : nullptr;
        }
    }

    void take_transition(const Transition& way, const Point& from) {
        if (way.target == nullptr) return;
        Bits now = from.leave;
        set_trigger(way, now);
        if (way.action) add_set_variables(*way.action, now, false);
        reach_node(*way.target, now);
    }

    void set_trigger(const Transition& way, Bits& now) const {
        if (way.trigger) mark_set(way.trigger->variable_target, now);
        if (way.trigger && !way.trigger->from_variable.empty())
            for (const Variable* variable : variables_)
                if (variable->name == way.trigger->from_variable.text()) mark_set(variable, now);
    }

    void mark_set(const Declaration* variable, Bits& now) const {
        const auto found = index_.find(variable);
        if (found != index_.end()) now.insert(found->second);
    }

    void set_by_call(const Stmt& call, Bits& now) const {
        const auto found = written_by_.find(call.name.parts.back());
        if (found == written_by_.end()) return;
        for (const Variable* variable : variables_)
            if (found->second.contains(variable->name)) mark_set(variable, now);
    }

    /// Adds to `now` the variables that the statement certainly sets. If `reading` is true, also reports the variables
    /// that it reads before they are set.
    void add_set_variables(const Stmt& statement, Bits& now, bool reading) {
        if (reading)
            for_expressions(statement, [&](const Expr& expr) {
                if (&expr != statement.target.get()) return this->read(expr, now);
                for_children(expr, [&](const Expr& part) { read_index(part, now); });
            });
        if (statement.kind == StmtKind::if_then_else) return set_in_branches(statement, now, reading);
        for (const StmtPtr& inner : statement.body) add_set_variables(*inner, now, reading);
        if (statement.kind == StmtKind::assignment && statement.target) mark_set(assigned_root(*statement.target), now);
        if (statement.kind == StmtKind::communication) mark_set(statement.communication->variable_target, now);
        if (statement.kind == StmtKind::call) set_by_call(statement, now);
    }

    void set_in_branches(const Stmt& statement, Bits& now, bool reading) {
        Bits other = now;
        if (!statement.body.empty()) add_set_variables(*statement.body[0], now, reading);
        if (statement.body.size() > 1) add_set_variables(*statement.body[1], other, reading);
        now.intersect(other);
    }

    // ------------------------------------------------------------ reads

    /// Reports early reads in the target of an assignment: `v[i] = e` reads `i`, not `v`.
    void read_index(const Expr& part, const Bits& now) {
        if (part.kind == ExprKind::name && index_.contains(part.target)) return;
        read(part, now);
    }

    void read(const Expr& expr, const Bits& now) {
        walk_tree(expr, [&](const Expr& part) {
            const auto found = part.kind == ExprKind::name ? index_.find(part.target) : index_.end();
            if (found == index_.end() || now.contains(found->second) || reported_.contains(found->second)) return;
            reported_.insert(found->second);
            const Variable& variable = *variables_[found->second];
            out_.report(rules::w_unset, part.span, {variable.name, default_of(variable.type)})
                .notes.push_back({variable.name_span, "declared here without an initial value"});
        });
    }

    void read(const NodeContainer& container) {
        for (const auto& node : container.nodes) {
            const Point& point = points_.at(node.get());
            if (!point.reached) continue;
            for (const Action& action : node->actions) {
                if (!action.statement) continue;
                Bits now = set_before(point, action.kind);
                add_set_variables(*action.statement, now, true);
            }
            read(*node);
        }
        for (const auto& transition : container.transitions)
            if (transition->source != nullptr && points_.at(transition->source).reached) read(*transition);
    }

    void read(const Transition& way) {
        const Point& point = points_.at(way.source);
        if (way.deadline) read(*way.deadline, point.settled);
        Bits guarded = point.settled;
        set_trigger(way, guarded);
        if (way.trigger && way.trigger->predicate) read(*way.trigger->predicate, guarded);
        if (way.condition) read(*way.condition, guarded);
        Bits now = point.leave;
        set_trigger(way, now);
        if (way.action) add_set_variables(*way.action, now, true);
    }

    const Machine& machine_;
    const WrittenBy& written_by_;
    Diagnostics& out_;
    std::vector<const Variable*> variables_;
    std::unordered_map<const Declaration*, std::size_t> index_;
    std::unordered_map<const State*, Point> points_;
    std::deque<const State*> open_;
    Bits reported_;
};

}  // namespace

void lint_flow(const Machine& machine, const WrittenBy& written_by, Diagnostics& out) {
    Flow(machine, written_by, out).run();
}

}  // namespace robochart::frontend
