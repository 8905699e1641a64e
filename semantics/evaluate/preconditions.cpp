// SPDX-License-Identifier: Apache-2.0
#include "semantics/evaluate/preconditions.hpp"

#include <algorithm>
#include <stdexcept>

#include "semantics/evaluate/evaluator.hpp"
#include "semantics/evaluate/toolkit.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::ir {

bool binds_names(ExprKind kind) {
    return kind == ExprKind::forall || kind == ExprKind::exists || kind == ExprKind::exists_unique ||
           kind == ExprKind::lambda || kind == ExprKind::the || kind == ExprKind::set_comprehension;
}

bool depends_on_state(const Expr& expr) {
    bool result = false;
    visit_operands(expr, [&](const Expr& part) {
        result =
            result || part.kind == ExprKind::variable || part.kind == ExprKind::trigger_value || is_clock(part.kind);
    });
    return result;
}

namespace {

bool depends_on_state(const std::vector<ExprPtr>& exprs) {
    return std::ranges::any_of(exprs, [](const ExprPtr& expr) { return expr && depends_on_state(*expr); });
}

/// True for a set or sequence literal with at least one element. Its value does not matter.
bool lists_something(const Expr& expr) {
    return (expr.kind == ExprKind::set || expr.kind == ExprKind::sequence) && !expr.args.empty();
}

/// True if the answer can be computed and is true.
template <class Answer>
bool true_without_fault(const Answer& answer) {
    try {
        return answer();
    } catch (const EvaluationFault&) {
        return false;
    } catch (const std::length_error&) {
        return false;
    }
}

}  // namespace

/// See evaluator.hpp. Inner calls are checked first, because the precondition of an outer call may need their values.
bool Evaluator::is_defined(const Expr& expr) {
    if (!has_preconditions(expr)) return true;
    if (binds_names(expr.kind)) return defined_for_all(expr);
    const std::size_t bindings = bindings_.size();
    bool result = true;
    for (std::size_t i = 0; result && i < expr.args.size(); ++i) {
        result = !expr.args[i] || is_defined(*expr.args[i]);
        if (result && expr.kind == ExprKind::let && i < expr.bound_names.size()) {
            Value bound = evaluate_operand(expr, i);
            bindings_.emplace_back(expr.bound_names[i], std::move(bound));
        }
    }
    bindings_.resize(bindings);
    if (!result) return false;
    if (expr.kind == ExprKind::toolkit && toolkit_precondition(expr.text))
        return !evaluate_operand(expr, 0).parts.empty();
    return expr.kind != ExprKind::call || !expr.function.is_valid() ||
           may_be_called(system_.functions.at(expr.function.index), evaluate_operands(expr), expr);
}

/// True if the predicate is defined for all bound values, and the body is defined for those that satisfy the predicate.
bool Evaluator::defined_for_all(const Expr& expr) {
    bool result = true;
    each_binding(expr, 0, [&] { result = result && (!expr.args.at(0) || is_defined(*expr.args[0])); });
    if (!result || expr.args.size() < 2 || !expr.args[1]) return result;
    each_binding(expr, 0,
                 [&] { result = result && ((expr.args[0] && !evaluate_truth(expr, 0)) || is_defined(*expr.args[1])); });
    return result;
}

bool Evaluator::has_preconditions(const Expr& expr) const {
    const bool own = expr.kind == ExprKind::toolkit
                         ? toolkit_precondition(expr.text)
                         : expr.kind == ExprKind::call && expr.function.is_valid() &&
                               !system_.functions.at(expr.function.index).preconditions.empty();
    return own || std::ranges::any_of(expr.args, [&](const ExprPtr& part) { return part && has_preconditions(*part); });
}

bool Evaluator::may_be_called(const Function& function, const std::vector<Value>& arguments, const Expr& expr) {
    if (function.preconditions.empty()) return true;
    if (++depth_ > deepest_call)
        throw_fault(expr, "the precondition of " + function.name + " asks for itself without end");
    std::vector<std::pair<std::string, Value>> inside;
    for (std::size_t i = 0; i < std::min(arguments.size(), function.parameter_names.size()); ++i)
        inside.emplace_back(function.parameter_names[i], arguments[i]);
    std::swap(inside, bindings_);
    const bool result = std::ranges::all_of(function.preconditions, [&](const ExprPtr& condition) {
        return is_defined(*condition) && evaluate_value(*condition).number != 0;
    });
    std::swap(inside, bindings_);
    --depth_;
    return result;
}

bool precondition_holds(const System& system, const Instantiation& inst, const Function& function,
                        const std::vector<Value>& arguments) {
    const Environment nothing;
    return Evaluator(system, inst, nullptr, nothing).may_be_called(function, arguments, Expr{});
}

bool precondition_can_fail(const System& system, const Instantiation& inst, const std::vector<Value>& constants,
                           const Expr& call) {
    Environment environment;
    environment.constants = constants;
    const auto value = [&](const Expr& expr) { return evaluate_expression(system, inst, nullptr, environment, expr); };
    if (call.kind == ExprKind::toolkit) {
        if (!toolkit_precondition(call.text) || lists_something(*call.args.at(0))) return false;
        return depends_on_state(*call.args[0]) ||
               !true_without_fault([&] { return !value(*call.args[0]).parts.empty(); });
    }
    if ((call.kind != ExprKind::call && call.kind != ExprKind::function_value) || !call.function.is_valid())
        return false;
    const Function& function = system.functions.at(call.function.index);
    if (function.preconditions.empty()) return false;
    // If the precondition is true when it is evaluated without arguments, it is true for all arguments.
    if (true_without_fault([&] { return precondition_holds(system, inst, function, {}); })) return false;
    return call.kind == ExprKind::function_value || depends_on_state(call.args) || !true_without_fault([&] {
               std::vector<Value> arguments;
               for (std::size_t i = 0; i < call.args.size(); ++i) {
                   if (call.args[i]->type != function.parameters.at(i)) return false;  // it will be converted
                   arguments.push_back(value(*call.args[i]));
               }
               return precondition_holds(system, inst, function, arguments);
           });
}

bool preconditions_can_fail(const System& system, const Instantiation& inst, const std::vector<Value>& constants,
                            const Expr& expr) {
    bool result = false;
    visit_operands(expr, [&](const Expr& part) {
        result =
            result || (part.kind != ExprKind::function_value && precondition_can_fail(system, inst, constants, part));
    });
    return result;
}

}  // namespace robochart::ir
