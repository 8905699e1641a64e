// SPDX-License-Identifier: Apache-2.0
#include "semantics/data/inlining.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "semantics/ir/function_result.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::ir {
namespace {

constexpr int deepest_nesting = 16;  ///< nesting of calls in bodies
constexpr std::size_t most_operands = 4'096;

bool has_number_or_truth(const System& system, TypeId type) {
    const TypeKind kind = system.type(type).kind;
    return kind == TypeKind::real || kind == TypeKind::integer || kind == TypeKind::boolean;
}

bool is_name(ExprKind kind) {
    return kind == ExprKind::variable || kind == ExprKind::constant || kind == ExprKind::trigger_value ||
           kind == ExprKind::bound || kind == ExprKind::member;
}

bool is_operator(ExprKind kind) {
    return is_connective(kind) || is_comparison(kind) || kind == ExprKind::boolean || kind == ExprKind::integer ||
           kind == ExprKind::real || kind == ExprKind::negate || kind == ExprKind::plus || kind == ExprKind::minus ||
           kind == ExprKind::times || kind == ExprKind::divide || kind == ExprKind::modulus ||
           kind == ExprKind::if_then_else || kind == ExprKind::cast;
}

/// Returns true if the argument always has a value. Then it does not matter whether the body evaluates it.
bool is_total(const Expr& argument) {
    bool result = true;
    visit_operands(argument, [&](const Expr& expr) {
        result = result && (is_name(expr.kind) || is_operator(expr.kind));
        if (expr.kind != ExprKind::divide && expr.kind != ExprKind::modulus) return;
        const Expr& divisor = *expr.args.at(1);
        result = result && ((divisor.kind == ExprKind::integer && divisor.number != 0) ||
                            (divisor.kind == ExprKind::real && divisor.decimal.unscaled != 0));
    });
    return result;
}

/// Replaces calls by the bodies of functions. In a body, the arguments replace the parameters.
class Inliner {
public:
    explicit Inliner(const System& system) : system_(system) {}

    /// Rewrites an expression. Returns null if the result is too large.
    ExprPtr rewrite(const ExprPtr& expr) {
        if (!expr || ++operands_ > most_operands) return nullptr;
        if (expr->kind == ExprKind::call)
            if (ExprPtr result = result_of(*expr)) return result;
        Expr changed = *expr;
        bool is_changed = false;
        for (std::size_t i = 0; i < expr->args.size(); ++i) {
            if (!expr->args[i]) continue;
            changed.args[i] = rewrite(expr->args[i]);
            if (!changed.args[i]) return nullptr;
            is_changed = is_changed || changed.args[i] != expr->args[i];
        }
        if (!is_changed) return expr;
        return std::make_shared<const Expr>(std::move(changed));
    }

private:
    [[nodiscard]] ExprPtr result_of(const Expr& call) {
        if (!call.function.is_valid() || nesting_ == deepest_nesting) return nullptr;
        const Function& function = system_.functions.at(call.function.index);
        const ExprPtr body = body_of(function);
        if (!body || call.args.size() != function.parameters.size()) return nullptr;
        std::vector<ExprPtr> arguments;
        for (std::size_t i = 0; i < call.args.size(); ++i) {
            if (!call.args[i] || call.args[i]->type != function.parameters[i]) return nullptr;
            arguments.push_back(rewrite(call.args[i]));
            if (!arguments.back() || !is_total(*arguments.back())) return nullptr;
        }
        ++nesting_;
        ExprPtr result = substitute(function, *body, arguments);
        --nesting_;
        return result;
    }

    /// The result's expression; null if the function has another contract.
    [[nodiscard]] ExprPtr body_of(const Function& function) const {
        if (!function.preconditions.empty() || !has_number_or_truth(system_, function.result)) return nullptr;
        return result_expression(function);
    }

    /// Returns the body with these arguments. Returns null if some expression in it cannot be rewritten.
    [[nodiscard]] ExprPtr substitute(const Function& function, const Expr& body,
                                     const std::vector<ExprPtr>& arguments) {
        if (++operands_ > most_operands) return nullptr;
        if (body.kind == ExprKind::bound) {
            const auto found = std::ranges::find(function.parameter_names, body.text);
            if (found == function.parameter_names.end()) return nullptr;
            const auto position = static_cast<std::size_t>(found - function.parameter_names.begin());
            return body.type == function.parameters[position] ? arguments[position] : nullptr;
        }
        if (body.kind != ExprKind::call && !is_operator(body.kind)) return nullptr;
        Expr changed = body;
        for (ExprPtr& part : changed.args) {
            part = part ? substitute(function, *part, arguments) : nullptr;
            if (!part) return nullptr;
        }
        if (body.kind == ExprKind::call) return result_of(changed);
        return std::make_shared<const Expr>(std::move(changed));
    }

    const System& system_;
    int nesting_ = 0;
    std::size_t operands_ = 0;
};

}  // namespace

ExprPtr inline_calls(const System& system, const ExprPtr& expr) {
    if (!expr) return expr;
    if (ExprPtr result = Inliner(system).rewrite(expr)) return result;
    return expr;
}

}  // namespace robochart::ir
