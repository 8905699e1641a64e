// SPDX-License-Identifier: Apache-2.0
// Evaluates names, logic and comparisons, and dispatches to the other families of expressions. evaluate.hpp states the
// rules.
#include "semantics/evaluate/evaluate.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "semantics/evaluate/evaluate_composed.hpp"
#include "semantics/evaluate/evaluator.hpp"
#include "semantics/ir/arithmetic.hpp"

namespace robochart::ir {

const Expr& Evaluator::argument_at(const Expr& expr, std::size_t index) {
    if (index >= expr.args.size() || !expr.args[index]) throw_fault(expr, "an operand is missing");
    return *expr.args[index];
}

std::vector<Value> Evaluator::evaluate_operands(const Expr& expr) {
    std::vector<Value> values;
    for (std::size_t i = 0; i < expr.args.size(); ++i) values.push_back(evaluate_operand(expr, i));
    return values;
}

Value Evaluator::evaluate_literal(const Expr& expr) {
    if (expr.kind == ExprKind::enum_literal) return {expr.number, evaluate_operands(expr)};
    if (expr.kind != ExprKind::real) return {expr.number, {}};
    const auto units = scale_decimal(expr.decimal, instantiation_.scale);
    if (!units) throw_fault(expr, "the number does not fit into 64 bits at this scale");
    return {*units, {}};
}

namespace {

template <class T>
const T* element_at_index(const std::vector<T>& values, std::uint32_t index) {
    return index < values.size() ? &values[index] : nullptr;
}

ClockId entry_clock(const Machine& machine, NodeId node) {
    for (std::uint32_t i = 0; i < machine.clocks.size(); ++i)
        if (machine.clocks[i].entry_of == node) return ClockId{i};
    return {};
}

}  // namespace

Value Evaluator::name(const Expr& expr) {
    if (expr.kind == ExprKind::variable)
        if (const auto* found = element_at_index(environment_.variables, expr.variable.index)) return *found;
    if (expr.kind == ExprKind::constant)
        if (const auto* found = element_at_index(environment_.constants, expr.constant.index)) return *found;
    if (expr.kind == ExprKind::trigger_value && environment_.trigger) return *environment_.trigger;
    ClockId clock = expr.clock;
    if (expr.kind == ExprKind::since_entry && machine_ != nullptr) clock = entry_clock(*machine_, expr.node);
    if (expr.kind == ExprKind::since || expr.kind == ExprKind::since_entry)
        if (const auto* found = element_at_index(environment_.clocks, clock.index)) return {*found, {}};
    throw_fault(expr, "a name has no value here");
}

Value Evaluator::bound_value(const Expr& expr) {
    for (auto it = bindings_.rbegin(); it != bindings_.rend(); ++it)
        if (it->first == expr.text) return it->second;
    throw_fault(expr, "'" + expr.text + "' is not bound here");
}

template <class Holds>
Value Evaluator::compare_operands(const Expr& expr, const Holds& holds) {
    const Value left = evaluate_operand(expr, 0);
    const Value right = evaluate_operand(expr, 1);
    return truth_value(holds(left, right));
}

template <class Holds>
Value Evaluator::compare_numbers(const Expr& expr, const Holds& holds) {
    return compare_operands(expr,
                            [&](const Value& left, const Value& right) { return holds(left.number, right.number); });
}

Value Evaluator::evaluate_value(const Expr& expr) {
    instantiation_.poll();
    switch (expr.kind) {
        case ExprKind::boolean:
        case ExprKind::integer:
        case ExprKind::real:
        case ExprKind::enum_literal:
            return evaluate_literal(expr);
        case ExprKind::variable:
        case ExprKind::constant:
        case ExprKind::trigger_value:
        case ExprKind::since:
        case ExprKind::since_entry:
            return name(expr);
        case ExprKind::bound:
            return bound_value(expr);
        case ExprKind::logical_not:
            return truth_value(!evaluate_truth(expr, 0));
        case ExprKind::iff:
            return truth_value(evaluate_truth(expr, 0) == evaluate_truth(expr, 1));
        case ExprKind::implies:
            return truth_value(!evaluate_truth(expr, 0) || evaluate_truth(expr, 1));
        case ExprKind::disjunction:
            return truth_value(evaluate_truth(expr, 0) || evaluate_truth(expr, 1));
        case ExprKind::conjunction:
            return truth_value(evaluate_truth(expr, 0) && evaluate_truth(expr, 1));
        case ExprKind::equal:
            return compare_operands(expr, std::equal_to<>());
        case ExprKind::not_equal:
            return compare_operands(expr, std::not_equal_to<>());
        case ExprKind::greater:
            return compare_numbers(expr, std::greater<>());
        case ExprKind::greater_equal:
            return compare_numbers(expr, std::greater_equal<>());
        case ExprKind::less:
            return compare_numbers(expr, std::less<>());
        case ExprKind::less_equal:
            return compare_numbers(expr, std::less_equal<>());
        case ExprKind::plus:
        case ExprKind::minus:
        case ExprKind::times:
        case ExprKind::divide:
        case ExprKind::modulus:
            return evaluate_arithmetic(expr);
        case ExprKind::negate:
            return evaluate_negation(expr);
        case ExprKind::if_then_else:
            return evaluate_truth(expr, 0) ? evaluate_operand(expr, 1) : evaluate_operand(expr, 2);
        case ExprKind::cast:
            return evaluate_cast(expr);
        case ExprKind::tuple:
        case ExprKind::record:
        case ExprKind::sequence:
            return {0, evaluate_operands(expr)};
        case ExprKind::matrix:
            return kind(expr.type) == TypeKind::vector ? Value{0, evaluate_operands(expr)}
                                                       : matrix_of(evaluate_operands(expr), expr.number);
        case ExprKind::set:
            return set_of(evaluate_operands(expr));
        case ExprKind::set_range:
            return range_set(evaluate_operand(expr, 0).number, evaluate_operand(expr, 1).number, expr.span);
        case ExprKind::member:
        case ExprKind::index:
        case ExprKind::apply:
        case ExprKind::concat:
            return evaluate_access(expr);
        case ExprKind::is_in:
            return truth_value(is_part(evaluate_operand(expr, 1), evaluate_operand(expr, 0)));
        case ExprKind::forall: {
            const std::vector<Value> bodies = where_satisfied(expr);
            return truth_value(true_ones(bodies) == bodies.size());
        }
        case ExprKind::exists:
            return truth_value(true_ones(where_satisfied(expr)) > 0);
        case ExprKind::exists_unique:
            return truth_value(true_ones(where_satisfied(expr)) == 1);
        case ExprKind::the:
            return only_candidate(expr, where_satisfied(expr));
        case ExprKind::lambda:
        case ExprKind::set_comprehension:
            return set_of(where_satisfied(expr));
        case ExprKind::let:
            return evaluate_let(expr);
        case ExprKind::string:
            return string_value(expr.characters);
        case ExprKind::call:
            return function_call(expr);
        case ExprKind::function_value:
            return function_pairs(expr);
        case ExprKind::toolkit:
            return toolkit_call(expr);
        case ExprKind::is_type:
            return truth_value(has_type(evaluate_operand(expr, 0), argument_at(expr, 0).type, expr.bound_types.at(0)));
        case ExprKind::range:
            return evaluate_range(expr);
        case ExprKind::transpose:
            return evaluate_transpose(expr);
    }
    throw_fault(expr, "the expression has no value");
}

Value evaluate_expression(const System& system, const Instantiation& instantiation, const Machine* machine,
                          const Environment& environment, const Expr& expr) {
    return Evaluator(system, instantiation, machine, environment).evaluate_value(expr);
}

std::optional<std::int64_t> scale_decimal(const Decimal& decimal, std::int64_t scale) {
    const auto divisor = power_of_ten(decimal.decimals);
    if (!divisor) return std::nullopt;
    return multiply_divide(decimal.unscaled, scale, *divisor);
}

}  // namespace robochart::ir
