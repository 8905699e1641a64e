// SPDX-License-Identifier: Apache-2.0
// Evaluates expressions that construct composed values, access their parts, or iterate over the values of a type:
// constructors, ranges, quantifiers and other binders, and functions of the model and of the toolkits.
#include <algorithm>
#include <utility>

#include "semantics/evaluate/carrier.hpp"
#include "semantics/evaluate/evaluate.hpp"
#include "semantics/evaluate/evaluate_composed.hpp"
#include "semantics/evaluate/evaluator.hpp"
#include "semantics/evaluate/toolkit.hpp"
#include "semantics/ir/function_result.hpp"

namespace robochart::ir {

Value Evaluator::evaluate_access(const Expr& expr) {
    Value base = evaluate_operand(expr, 0);
    if (expr.kind == ExprKind::concat) {
        const Value tail = evaluate_operand(expr, 1);
        base.parts.insert(base.parts.end(), tail.parts.begin(), tail.parts.end());
        return base;
    }
    if (expr.kind == ExprKind::member) {
        const bool record = kind(argument_at(expr, 0).type) == TypeKind::record;
        return part_at(base, expr.number + (record ? 1 : 0), expr.span);
    }
    std::vector<Value> rest = evaluate_operands(expr);
    rest.erase(rest.begin());
    if (expr.kind == ExprKind::apply) return apply_function(base, rest, expr.span);
    for (const Value& index : rest) base = part_at(base, index.number, expr.span);
    return base;
}

std::vector<Value> Evaluator::where_satisfied(const Expr& expr) {
    const std::size_t bindings = bindings_.size();
    std::vector<Value> found;
    each_binding(expr, 0, [&] {
        if (!evaluate_truth(expr, 0)) return;
        Value arguments = bound_tuple(bindings_, bindings);
        if (expr.kind == ExprKind::lambda)
            found.push_back({0, {arguments, evaluate_operand(expr, 1)}});
        else if (expr.kind == ExprKind::the || expr.kind == ExprKind::set_comprehension)
            found.push_back(expr.args.size() > 1 && expr.args[1] ? evaluate_operand(expr, 1) : std::move(arguments));
        else
            found.push_back(evaluate_operand(expr, 1));
    });
    return found;
}

Value Evaluator::only_candidate(const Expr& expr, const std::vector<Value>& candidates) {
    if (candidates.size() != 1) throw_fault(expr, "`the` needs exactly one candidate");
    return candidates.front();
}

std::size_t Evaluator::true_ones(const std::vector<Value>& values) {
    const auto count = std::ranges::count_if(values, [](const Value& v) { return v.number != 0; });
    return static_cast<std::size_t>(count);
}

Value Evaluator::function_call(const Expr& expr) {
    const std::vector<Value> arguments = evaluate_operands(expr);
    if (!expr.function.is_valid()) return default_value(system_, instantiation_, expr.type);
    return function_result(system_.functions.at(expr.function.index), arguments, expr);
}

/// Returns the value of a function call. Without postconditions, it is the default value of the result type: 0, true or
/// the first literal (semantics 3.13). Otherwise it is the first value that satisfies them; the default value comes
/// first. If a postcondition states the value, no search is necessary.
Value Evaluator::function_result(const Function& function, const std::vector<Value>& arguments, const Expr& expr) {
    const Value constant = default_value(system_, instantiation_, function.result);
    if (function.postconditions.empty()) return constant;
    if (++depth_ > deepest_call) throw_fault(expr, "the function " + function.name + " calls itself without end");
    if (++calls_ > most_calls) throw_fault(expr, "the function " + function.name + " calls itself too often");
    instantiation_.poll();
    std::vector<std::pair<std::string, Value>> inside;
    for (std::size_t i = 0; i < std::min(arguments.size(), function.parameter_names.size()); ++i)
        inside.emplace_back(function.parameter_names[i], arguments[i]);
    std::swap(inside, bindings_);
    const auto satisfies = [&](const Value& candidate) {
        bindings_.emplace_back("result", candidate);
        const bool holds = std::ranges::all_of(function.postconditions, [&](const ExprPtr& condition) {
            return is_defined(*condition) && evaluate_value(*condition).number != 0;
        });
        bindings_.pop_back();
        return holds;
    };
    std::optional<Value> found;
    if (const ExprPtr result = result_expression(function)) {
        if (is_defined(*result)) found = evaluate_value(*result);
        if (found && *found != constant && !in_carrier(system_, instantiation_, function.result, *found)) found.reset();
    } else if (satisfies(constant)) {
        found = constant;
    } else {
        for (const Value& candidate : carrier_values(system_, instantiation_, function.result))
            if (satisfies(candidate)) {
                found = candidate;
                break;
            }
    }
    std::swap(inside, bindings_);
    --depth_;
    if (!found) throw_fault(expr, "no value satisfies the postcondition of " + function.name);
    return *found;
}

/// Returns a function as the set of its pairs, for the arguments that satisfy its precondition.
Value Evaluator::function_pairs(const Expr& expr) {
    const Function& function = system_.functions.at(expr.function.index);
    std::vector<Value> pairs;
    for (const Value& argument : carrier_values(system_, instantiation_, system_.type(expr.type).args.at(0))) {
        const bool one = function.parameters.size() == 1;
        const std::vector<Value> arguments = one ? std::vector<Value>{argument} : argument.parts;
        if (may_be_called(function, arguments, expr))
            pairs.push_back({0, {argument, function_result(function, arguments, expr)}});
    }
    return set_of(std::move(pairs));
}

Value Evaluator::toolkit_call(const Expr& expr) {
    std::vector<std::vector<Value>> carriers;
    for (const std::size_t place : toolkit_carriers(expr.text))
        carriers.push_back(carrier_values(system_, instantiation_, expr.bound_types.at(place)));
    return toolkit_result(expr.text, evaluate_operands(expr), carriers, expr.span);
}

/// Returns the whole numbers between the bounds, or the reals of the carrier between them.
Value Evaluator::evaluate_range(const Expr& expr) {
    const std::int64_t low = evaluate_operand(expr, 0).number;
    const std::int64_t high = evaluate_operand(expr, 1).number;
    const bool open_low = expr.number == 1 || expr.number == 3;
    const bool open_high = expr.number >= 2;
    const auto& types = system_.type(expr.type).args;
    const TypeId element = types.empty() ? expr.args.at(0)->type : types[0];
    if (!element.is_valid() || kind(element) != TypeKind::real)
        return range_set(low + (open_low ? 1 : 0), high - (open_high ? 1 : 0), expr.span);
    std::vector<Value> members;
    for (const Value& value : carrier_values(system_, instantiation_, element))
        if ((open_low ? low < value.number : low <= value.number) &&
            (open_high ? value.number < high : value.number <= high))
            members.push_back(value);
    return set_of(std::move(members));
}

Value Evaluator::evaluate_let(const Expr& expr) {
    const std::size_t bindings = bindings_.size();
    for (std::size_t i = 0; i < expr.bound_names.size(); ++i) {
        Value value = evaluate_operand(expr, i);
        bindings_.emplace_back(expr.bound_names[i], std::move(value));
    }
    Value result = evaluate_operand(expr, expr.bound_names.size());
    bindings_.resize(bindings);
    return result;
}

}  // namespace robochart::ir
