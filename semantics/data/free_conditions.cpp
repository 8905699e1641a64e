// SPDX-License-Identifier: Apache-2.0
#include "semantics/data/free_conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "semantics/data/classes.hpp"
#include "semantics/data/inlining.hpp"
#include "semantics/data/statements.hpp"
#include "semantics/evaluate/preconditions.hpp"
#include "semantics/evaluate/toolkit.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::ir {
namespace {

/// Assigns numbers to expressions. Two expressions have the same number if and only if they are equal.
class ExpressionKeys {
public:
    /// Returns a text that is different for different expressions. The recursion is as deep as the expression.
    [[nodiscard]] std::string key_of(const Expr& expr) {
        std::string key = fmt::format("({} {} {} {}e{} {} {} {} {} {} s{} {}:{}", static_cast<int>(expr.kind),
                                      expr.type.index, expr.number, expr.decimal.unscaled, expr.decimal.decimals,
                                      expr.variable.index, expr.constant.index, expr.clock.index, expr.node.index,
                                      expr.function.index, number_of(expr.characters), expr.text.size(), expr.text);
        for (const std::string& name : expr.bound_names) key += fmt::format(" {}:{}", name.size(), name);
        for (const TypeId type : expr.bound_types) key += fmt::format(" t{}", type.index);
        for (const ExprPtr& part : expr.args) key += key_of(*part);
        return key + ")";
    }

private:
    [[nodiscard]] std::size_t number_of(const diagnostics::ForeignText& characters) {
        const auto found = std::ranges::find(strings_, characters);
        const auto number = static_cast<std::size_t>(found - strings_.begin());
        if (found == strings_.end()) strings_.push_back(characters);
        return number;
    }
    std::vector<diagnostics::ForeignText> strings_;
};

/// A comparison `a < b` or `a == b`, or the negation of one.
struct Comparison {
    ExprPtr expr;
    bool negated = false;
};

ExprPtr with_operands(const Expr& expr, ExprKind kind, ExprPtr left, ExprPtr right) {
    Expr result = expr;
    result.kind = kind;
    result.args = {std::move(left), std::move(right)};
    return std::make_shared<const Expr>(std::move(result));
}

/// Converts a comparison to a normal form, so that a condition and its negation share one answer. This is correct for
/// numbers because their order is total.
Comparison in_normal_form(ExpressionKeys& keys, const ExprPtr& expr) {
    if (!is_comparison(expr->kind)) return {expr, false};
    const ExprPtr &a = expr->args.at(0), &b = expr->args.at(1);
    if (expr->kind == ExprKind::less) return {expr, false};
    if (expr->kind == ExprKind::greater) return {with_operands(*expr, ExprKind::less, b, a), false};
    if (expr->kind == ExprKind::less_equal) return {with_operands(*expr, ExprKind::less, b, a), true};
    if (expr->kind == ExprKind::greater_equal) return {with_operands(*expr, ExprKind::less, a, b), true};
    const bool in_order = keys.key_of(*a) <= keys.key_of(*b);
    return {with_operands(*expr, ExprKind::equal, in_order ? a : b, in_order ? b : a),
            expr->kind == ExprKind::not_equal};
}

/// A variable that holds the answer of a condition.
struct FreeAnswer {
    VariableId variable;
    ExprPtr condition;
    std::set<VariableId> reads;
};

/// Replaces conditions of one machine by variables with free answers.
class MachineConditions {
public:
    MachineConditions(const System& system, const Sampling& sampling, MachineId id,
                      const std::set<const Expr*>& unanswered, const std::set<std::string>& written_by_operations)
        : system_(system),
          sampling_(sampling),
          id_(id),
          unanswered_(unanswered),
          written_by_operations_(written_by_operations),
          machine_(system.machine(id)) {
        for (const Transition& transition : machine_.transitions)
            if (transition.trigger && transition.trigger->variable.is_valid())
                received_.insert(transition.trigger->variable);
    }

    [[nodiscard]] Machine rewrite();
    [[nodiscard]] std::size_t count() const { return answers_.size(); }

private:
    [[nodiscard]] bool is_data(const Expr& expr) const;
    [[nodiscard]] bool reads_data(const Expr& root) const;
    [[nodiscard]] bool may_fail(const ExprPtr& expr) const {
        return expr && reads_data(*expr) && sampling_.may_be_undefined(id_, expr);
    }
    [[nodiscard]] bool is_answered(const ExprPtr& root) const;
    [[nodiscard]] bool can_be_freed(const Expr& root) const;

    [[nodiscard]] ExprPtr guard(const ExprPtr& expr);
    [[nodiscard]] ExprPtr condition(const ExprPtr& expr, bool unanswered = false);
    [[nodiscard]] ExprPtr answer_of(const ExprPtr& expr);
    [[nodiscard]] ExprPtr all_of(const std::vector<ExprPtr>& conditions);
    [[nodiscard]] bool add_preconditions(const ExprPtr& expr, std::vector<ExprPtr>& out) const;
    [[nodiscard]] bool add_preconditions(const Expr& expr, std::vector<ExprPtr>& out) const;
    [[nodiscard]] ExprPtr is_not_empty(const ExprPtr& collection) const;
    [[nodiscard]] Expr zero_of(TypeId type) const;
    [[nodiscard]] ExprPtr comparison(ExprKind kind, const ExprPtr& left, Expr right) const;
    [[nodiscard]] ExprPtr value(const ExprPtr& expr);

    [[nodiscard]] StmtPtr possible_end(const Origin& origin);
    [[nodiscard]] StmtPtr guarded(const Stmt& stmt, StmtPtr done);
    [[nodiscard]] std::vector<ExprPtr> literals(TypeId type, const Expr& origin) const;

    [[nodiscard]] StmtPtr with_conditions(const StmtPtr& stmt);
    [[nodiscard]] StmtPtr with_literals(const Stmt& stmt);
    [[nodiscard]] bool may_block(const Stmt& stmt) const;
    [[nodiscard]] bool selects_element(const Stmt& stmt) const;
    [[nodiscard]] StmtPtr answer_after(const FreeAnswer& answer, VariableId variable, const ExprPtr& value,
                                       const Origin& origin);
    void add_answers_after(VariableId variable, const ExprPtr& value, const Origin& origin, std::vector<StmtPtr>& out);
    [[nodiscard]] StmtPtr with_answers(const StmtPtr& stmt);
    void add_answers(Transition& transition);

    const System& system_;
    const Sampling& sampling_;
    MachineId id_;
    const std::set<const Expr*>& unanswered_;
    const std::set<std::string>& written_by_operations_;
    Machine machine_;
    StatementMaker maker_{machine_};
    std::set<VariableId> received_;  ///< variables in which triggers store values
    /// The action is an exit or during action. It may run between an event and the action of its transition.
    bool may_follow_event_ = false;
    std::vector<FreeAnswer> answers_;
    ExpressionKeys keys_;
    std::map<std::string, std::size_t> known_;  ///< the index of the answer, by the key of the condition
};

bool MachineConditions::is_data(const Expr& expr) const {
    if (expr.kind == ExprKind::variable)
        return is_replaceable(system_, machine_.variables.at(expr.variable.index).type);
    return expr.kind == ExprKind::trigger_value && is_replaceable(system_, expr.type);
}

bool MachineConditions::reads_data(const Expr& root) const {
    bool result = false;
    visit_operands(root, [&](const Expr& expr) { result = result || is_data(expr); });
    return result;
}

/// Returns true if the classes of one place's values may determine the answer of the condition.
bool MachineConditions::is_answered(const ExprPtr& root) const {
    std::set<std::pair<ExprKind, VariableId>> places;
    bool clock = false;
    TypeId type;
    visit_operands(*root, [&](const Expr& expr) {
        clock = clock || is_clock(expr.kind);
        if (expr.kind != ExprKind::variable && expr.kind != ExprKind::trigger_value) return;
        places.emplace(expr.kind, expr.variable);
        type = expr.kind == ExprKind::variable ? machine_.variables.at(expr.variable.index).type : expr.type;
    });
    return places.size() == 1 && !clock && can_divide(system_, sampling_, id_, type, *inline_calls(system_, root));
}

/// Returns true if a variable can replace the condition. A received value is stored before the transition's action, and
/// so before the choice of the answer. Exit and during actions may run in between.
bool MachineConditions::can_be_freed(const Expr& root) const {
    bool result = true;
    visit_operands(root, [&](const Expr& expr) {
        if (is_clock(expr.kind) || expr.kind == ExprKind::trigger_value) result = false;
        if (expr.kind != ExprKind::variable) return;
        const Variable& variable = machine_.variables.at(expr.variable.index);
        if (variable.scope == VariableScope::required || written_by_operations_.contains(variable.name)) result = false;
        if (may_follow_event_ && received_.contains(expr.variable)) result = false;
    });
    return result;
}

ExprPtr MachineConditions::comparison(ExprKind kind, const ExprPtr& left, Expr right) const {
    Expr result;
    result.kind = kind;
    result.type = boolean_type;
    result.span = right.span = left->span;
    right.type = left->type;
    result.args = {left, std::make_shared<const Expr>(std::move(right))};
    return std::make_shared<const Expr>(std::move(result));
}

bool MachineConditions::add_preconditions(const ExprPtr& expr, std::vector<ExprPtr>& out) const {
    return !expr || !may_fail(expr) || add_preconditions(*inline_calls(system_, expr), out);
}

/// Adds the conditions that make the expression defined, inner ones first. Returns false if they may not be enough.
/// Recursion depth: the depth of the expression.
bool MachineConditions::add_preconditions(const Expr& expr, std::vector<ExprPtr>& out) const {
    for (const ExprPtr& part : expr.args)
        if (!add_preconditions(*part, out)) return false;
    if (expr.kind == ExprKind::toolkit) {
        if (toolkit_precondition(expr.text)) out.push_back(is_not_empty(expr.args.at(0)));
        return true;
    }
    if (expr.kind == ExprKind::divide || expr.kind == ExprKind::modulus) {
        const auto divisor = sampling_.closed_value(id_, *expr.args.at(1));
        if (!divisor || divisor->number == 0)
            out.push_back(comparison(ExprKind::not_equal, expr.args.at(1), zero_of(expr.args.at(1)->type)));
        return true;
    }
    if (expr.kind == ExprKind::cast) {
        const TypeId from = expr.args.at(0)->type;
        if (system_.type(expr.type).kind == TypeKind::nat && system_.type(from).kind != TypeKind::nat)
            out.push_back(comparison(ExprKind::greater_equal, expr.args.at(0), zero_of(from)));
        return true;
    }
    if (expr.kind == ExprKind::call)
        return expr.function.is_valid() && !may_have_no_value(system_.functions.at(expr.function.index));
    const bool other = expr.kind == ExprKind::apply || expr.kind == ExprKind::index || expr.kind == ExprKind::let;
    return !other && !binds_names(expr.kind);
}

ExprPtr MachineConditions::is_not_empty(const ExprPtr& collection) const {
    Expr none;
    none.kind = system_.type(collection->type).kind == TypeKind::sequence ? ExprKind::sequence : ExprKind::set;
    return comparison(ExprKind::not_equal, collection, std::move(none));
}

Expr MachineConditions::zero_of(TypeId type) const {
    Expr zero;
    zero.kind = system_.type(type).kind == TypeKind::real ? ExprKind::real : ExprKind::integer;
    return zero;
}

ExprPtr MachineConditions::all_of(const std::vector<ExprPtr>& conditions) {
    ExprPtr result = conditions.front();
    for (std::size_t i = 1; i < conditions.size(); ++i) {
        Expr both;
        both.kind = ExprKind::conjunction;
        both.type = boolean_type;
        both.span = result->span;
        both.args = {result, conditions[i]};
        result = std::make_shared<const Expr>(std::move(both));
    }
    return result;
}

/// Returns the guard with variables in place of the freed conditions. If a guard is undefined, then neither the guard
/// nor its negation is true.
ExprPtr MachineConditions::guard(const ExprPtr& expr) {
    if (!expr || !may_fail(expr)) return condition(expr);
    if (!unanswered_.contains(expr.get()) && is_answered(expr)) return expr;
    std::vector<ExprPtr> parts;
    if (!add_preconditions(expr, parts)) return can_be_freed(*expr) ? answer_of(expr) : expr;
    for (ExprPtr& part : parts) part = condition(part);
    parts.push_back(condition(expr));
    return all_of(parts);
}

/// Returns the condition with variables for the answers of its parts. They are correct if the condition is defined.
ExprPtr MachineConditions::condition(const ExprPtr& expr, bool unanswered) {
    if (!expr || !reads_data(*expr)) return expr;
    unanswered = unanswered || unanswered_.contains(expr.get());
    if (is_connective(expr->kind)) {
        Expr result = *expr;
        for (ExprPtr& part : result.args) part = condition(part, unanswered);
        return result.args == expr->args ? expr : std::make_shared<const Expr>(std::move(result));
    }
    const bool answered = !unanswered && !sampling_.may_be_undefined(id_, expr) && is_answered(expr);
    if (answered || !can_be_freed(*expr)) return expr;
    const Comparison normal = in_normal_form(keys_, expr);
    const ExprPtr answer = answer_of(normal.expr);
    if (!normal.negated) return answer;
    Expr result;
    result.kind = ExprKind::logical_not;
    result.type = expr->type;
    result.span = expr->span;
    result.args = {answer};
    return std::make_shared<const Expr>(std::move(result));
}

ExprPtr MachineConditions::answer_of(const ExprPtr& expr) {
    const auto [found, added] = known_.emplace(keys_.key_of(*expr), answers_.size());
    if (added) {
        const std::string name = fmt::format("answer{}", answers_.size() + 1);
        FreeAnswer answer{maker_.add_variable(name, expr->type, {"", expr->span}), expr, {}};
        visit_operands(*expr, [&](const Expr& part) {
            if (part.kind == ExprKind::variable) answer.reads.insert(part.variable);
        });
        answers_.push_back(std::move(answer));
    }
    return maker_.read(answers_[found->second].variable, expr->span);
}

/// Rewrites a value that is stored or sent, including the conditions inside it. Names that an expression binds do not
/// exist outside it.
ExprPtr MachineConditions::value(const ExprPtr& expr) {
    if (!expr || is_replaceable(system_, expr->type)) return expr;
    if (system_.type(expr->type).kind == TypeKind::boolean) return condition(expr);
    if (binds_names(expr->kind)) return expr;
    Expr result = *expr;
    for (ExprPtr& part : result.args) part = value(part);
    return result.args == expr->args ? expr : std::make_shared<const Expr>(std::move(result));
}

/// Returns an internal choice: the thread continues, or it blocks because an expression is undefined.
StmtPtr MachineConditions::possible_end(const Origin& origin) {
    return maker_.choice_of({maker_.skip(origin), maker_.choice_of({}, origin)}, origin);
}

/// Returns the literals of a Boolean or of an enumeration without arguments, or an empty result for other types.
std::vector<ExprPtr> MachineConditions::literals(TypeId id, const Expr& origin) const {
    const Type& type = system_.type(id);
    const bool plain = std::ranges::all_of(type.literal_args, [](const auto& types) { return types.empty(); });
    std::size_t count = 0;
    if (type.kind == TypeKind::boolean) count = 2;
    if (type.kind == TypeKind::enumeration && plain) count = type.labels.size();
    std::vector<ExprPtr> result;
    for (std::size_t number = 0; number < count; ++number) {
        Expr literal;
        literal.kind = type.kind == TypeKind::boolean ? ExprKind::boolean : ExprKind::enum_literal;
        literal.type = id;
        literal.number = static_cast<std::int64_t>(number);
        if (type.kind == TypeKind::enumeration) literal.text = type.labels[number];
        literal.span = origin.span;
        result.push_back(std::make_shared<const Expr>(std::move(literal)));
    }
    return result;
}

/// Returns true if an assignment changes an element of a sequence or another collection. That element may not exist.
bool MachineConditions::selects_element(const Stmt& stmt) const {
    if (stmt.path.empty()) return false;
    const TypeKind kind = system_.type(machine_.variables.at(stmt.variable.index).type).kind;
    return stmt.path.size() > 1 || (kind != TypeKind::record && kind != TypeKind::product);
}

bool MachineConditions::may_block(const Stmt& stmt) const {
    const bool timing =
        stmt.kind == StmtKind::wait || stmt.kind == StmtKind::wait_interval || stmt.kind == StmtKind::deadline;
    return may_fail(stmt.condition) || (!timing && may_fail(stmt.value)) || may_fail(stmt.communication.value) ||
           selects_element(stmt) ||
           std::ranges::any_of(stmt.path, [&](const ExprPtr& step) { return may_fail(step); }) ||
           std::ranges::any_of(stmt.args, [&](const ExprPtr& argument) { return may_fail(argument); });
}

/// Replaces an assignment of a literal that is computed from data: the machine chooses the literal instead.
StmtPtr MachineConditions::with_literals(const Stmt& stmt) {
    if (stmt.kind != StmtKind::assign || !stmt.path.empty() || !reads_data(*stmt.value)) return nullptr;
    const TypeId type = machine_.variables.at(stmt.variable.index).type;
    if (is_replaceable(system_, type)) return nullptr;
    const std::vector<ExprPtr> values = literals(type, *stmt.value);
    if (values.empty() || system_.type(type).kind == TypeKind::boolean) return nullptr;
    return maker_.choice_of_value(stmt.variable, values, stmt.origin);
}

StmtPtr MachineConditions::with_conditions(const StmtPtr& stmt) {
    if (!stmt) return stmt;
    Stmt result = *stmt;
    for (StmtPtr& part : result.body) part = with_conditions(part);
    result.condition = condition(stmt->condition);
    if (stmt->kind == StmtKind::assign) result.value = value(stmt->value);
    result.communication.value = value(stmt->communication.value);
    for (ExprPtr& argument : result.args) argument = value(argument);
    StmtPtr done = with_literals(result);
    if (!done) done = std::make_shared<const Stmt>(std::move(result));
    return may_block(*stmt) ? guarded(*stmt, std::move(done)) : done;
}

/// Returns a statement that blocks the thread if an expression of `stmt` is undefined, and otherwise performs `done`.
/// If it is not known when the expressions are defined, the thread chooses whether to block.
StmtPtr MachineConditions::guarded(const Stmt& stmt, StmtPtr done) {
    std::vector<ExprPtr> conditions;
    bool known = !selects_element(stmt);
    for (const ExprPtr& expr : {stmt.condition, stmt.value, stmt.communication.value})
        known = known && add_preconditions(expr, conditions);
    for (const ExprPtr& argument : stmt.args) known = known && add_preconditions(argument, conditions);
    if (!known || conditions.empty()) return maker_.sequence_of({possible_end(stmt.origin), done}, stmt.origin);
    for (ExprPtr& part : conditions) part = condition(part);
    return maker_.if_then_else(all_of(conditions), std::move(done), maker_.choice_of({}, stmt.origin), stmt.origin);
}

/// Returns the statement that sets the answer when `variable` has received `value` (null if the value is unknown).
StmtPtr MachineConditions::answer_after(const FreeAnswer& answer, VariableId variable, const ExprPtr& value,
                                        const Origin& origin) {
    const std::vector<ExprPtr> truth = literals(answer.condition->type, *answer.condition);
    if (value && answer.reads == std::set{variable}) {
        const auto known = sampling_.closed_value(id_, *value);
        const auto result =
            known ? sampling_.truth(id_, *inline_calls(system_, answer.condition), *known) : std::optional<int>{};
        if (result) return maker_.assignment(answer.variable, truth.at(*result == 1 ? 1 : 0), origin);
    }
    return maker_.choice_of_value(answer.variable, truth, origin);
}

void MachineConditions::add_answers_after(VariableId variable, const ExprPtr& value, const Origin& origin,
                                          std::vector<StmtPtr>& out) {
    for (const FreeAnswer& answer : answers_)
        if (answer.reads.contains(variable)) out.push_back(answer_after(answer, variable, value, origin));
}

/// Adds the choices of answers directly after a write. So after the choices, every step is possible that the model can
/// perform after the write.
StmtPtr MachineConditions::with_answers(const StmtPtr& stmt) {
    if (!stmt) return stmt;
    Stmt result = *stmt;
    for (StmtPtr& part : result.body) part = with_answers(part);
    std::vector<StmtPtr> parts{std::make_shared<const Stmt>(std::move(result))};
    if (stmt->kind == StmtKind::assign)
        add_answers_after(stmt->variable, stmt->path.empty() ? stmt->value : nullptr, stmt->origin, parts);
    if (stmt->communication.variable.is_valid())
        add_answers_after(stmt->communication.variable, nullptr, stmt->origin, parts);
    return maker_.sequence_of(std::move(parts), stmt->origin);
}

/// Adds choices of answers to a transition: at the start of the machine, and after a trigger has stored a value.
void MachineConditions::add_answers(Transition& transition) {
    std::vector<StmtPtr> parts;
    if (transition.source == machine_.initial) {
        for (const FreeAnswer& answer : answers_) {
            const VariableId first = *answer.reads.begin();
            const Variable& variable = machine_.variables.at(first.index);
            const bool own = variable.scope == VariableScope::local;
            parts.push_back(answer_after(answer, first, own ? variable.initial : nullptr, transition.origin));
        }
    }
    if (transition.trigger && transition.trigger->variable.is_valid())
        add_answers_after(transition.trigger->variable, nullptr, transition.origin, parts);
    if (transition.action) parts.push_back(with_answers(transition.action));
    if (!parts.empty()) transition.action = maker_.sequence_of(std::move(parts), transition.origin);
}

Machine MachineConditions::rewrite() {
    for (Transition& transition : machine_.transitions) {
        transition.guard = guard(transition.guard);
        transition.action = with_conditions(transition.action);
    }
    for (Node& node : machine_.nodes) {
        node.entry = with_conditions(node.entry);
        may_follow_event_ = true;
        node.during = with_conditions(node.during);
        node.exit = with_conditions(node.exit);
        may_follow_event_ = false;
    }
    for (Transition& transition : machine_.transitions) add_answers(transition);
    for (Node& node : machine_.nodes)
        for (StmtPtr* action : {&node.entry, &node.during, &node.exit}) *action = with_answers(*action);
    return std::move(machine_);
}

}  // namespace

FreedSystem free_conditions(const System& system, const Sampling& sampling, const std::set<const Expr*>& unanswered) {
    std::set<std::string> written_by_operations;
    for (const Machine& machine : system.machines)
        if (machine.kind == MachineKind::operation)
            for (const Variable& variable : machine.variables)
                if (variable.scope == VariableScope::required) written_by_operations.insert(variable.name);
    FreedSystem result{system, 0};
    for (std::uint32_t m = 0; m < system.machines.size(); ++m) {
        sampling.instantiation().poll();
        MachineConditions conditions(system, sampling, MachineId{m}, unanswered, written_by_operations);
        result.system.machines[m] = conditions.rewrite();
        result.conditions += conditions.count();
    }
    return result;
}

}  // namespace robochart::ir
