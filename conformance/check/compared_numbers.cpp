// SPDX-License-Identifier: Apache-2.0
#include "conformance/check/compared_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "cpp_emit/runtime/runtime.hpp"
#include "semantics/ir/comparison.hpp"
#include "semantics/ir/numbers.hpp"

namespace robochart::conformance {

namespace {

using Real = Deployment::Real;
using Whole = Deployment::Int;

/// Computes the operands of a comparison with the numbers and operators that generated code uses.
class Computer {
public:
    Computer(const ir::System& system, const ir::ModelComparison& comparison, const NumberSpace& space,
             const TriedValue& value)
        : system_(system), comparison_(comparison), space_(space), value_(value) {}

    [[nodiscard]] bool is_real(const ir::Expr& expr) const {
        return system_.type(expr.type).kind == ir::TypeKind::real;
    }

    /// Computes a real. Recursion depth: the depth of the expression.
    [[nodiscard]] std::optional<Real> real(const ir::Expr& expr) const {
        if (expr.kind == ir::ExprKind::real) return nearest_double(ir::to_string(expr.decimal));
        if (expr.kind == ir::ExprKind::cast || !is_real(expr)) {
            const auto number = whole(expr.kind == ir::ExprKind::cast ? *expr.args.at(0) : expr);
            return number ? std::optional(static_cast<Real>(*number)) : std::nullopt;
        }
        if (const auto bits = part(expr)) return std::bit_cast<Real>(*bits);
        return computed(expr, [&](const ir::Expr& operand) { return real(operand); });
    }
    [[nodiscard]] std::optional<Whole> whole(const ir::Expr& expr) const {
        if (expr.kind == ir::ExprKind::integer) return expr.number;
        if (is_real(expr) || expr.kind == ir::ExprKind::cast) return std::nullopt;
        if (const auto bits = part(expr)) return bits;
        return computed(expr, [&](const ir::Expr& operand) { return whole(operand); });
    }

private:
    template <class Compute>
    [[nodiscard]] static auto computed(const ir::Expr& expr, const Compute& compute) -> decltype(compute(expr)) {
        if (expr.args.empty()) return std::nullopt;
        const auto a = compute(*expr.args.front());
        if (a && expr.kind == ir::ExprKind::negate) return negative(*a);
        const auto b = expr.args.size() == 2 ? compute(*expr.args.back()) : std::nullopt;
        if (!a || !b) return std::nullopt;
        if (expr.kind == ir::ExprKind::plus) return plus(*a, *b);
        if (expr.kind == ir::ExprKind::minus) return minus(*a, *b);
        if (expr.kind == ir::ExprKind::times) return times(*a, *b);
        return std::nullopt;
    }

    /// Returns a constant, or a number of the value.
    [[nodiscard]] std::optional<std::int64_t> part(const ir::Expr& expr) const {
        ir::NumberPart part{{}, system_.type(expr.type).kind};
        if (const auto found = comparison_.constants.find(&expr); found != comparison_.constants.end())
            return nearest_number(space_, part, found->second).bits;
        const ir::Expr* at = &expr;
        for (; at->kind == ir::ExprKind::member; at = at->args.at(0).get()) {
            const bool record = system_.type(at->args.at(0)->type).kind == ir::TypeKind::record;
            part.path.insert(part.path.begin(), static_cast<std::size_t>(at->number) - (record ? 0 : 1));
        }
        if (at->kind != ir::ExprKind::variable && at->kind != ir::ExprKind::trigger_value) return std::nullopt;
        const auto found = std::ranges::find(space_.parts, part);
        if (found == space_.parts.end()) return std::nullopt;
        return value_[static_cast<std::size_t>(found - space_.parts.begin())].bits;
    }

    const ir::System& system_;
    const ir::ModelComparison& comparison_;
    const NumberSpace& space_;
    const TriedValue& value_;
};

template <class Number>
std::optional<ComparedNumbers> compared(ir::ExprKind kind, const std::optional<Number>& left,
                                        const std::optional<Number>& right) {
    if (!left || !right) return std::nullopt;
    return ComparedNumbers{fmt::format("{}", *left), fmt::format("{}", *right),
                           ir::comparison_answer(kind, *left <=> *right)};
}

}  // namespace

std::optional<ComparedNumbers> compare_on_robot(const ir::System& system, const ir::ModelComparison& comparison,
                                                const NumberSpace& space, const TriedValue& value) {
    const Computer computer(system, comparison, space, value);
    const ir::Expr& left = *comparison.expr->args.at(0);
    const ir::Expr& right = *comparison.expr->args.at(1);
    if (space.sequences) {
        if (!comparison.cut) return std::nullopt;
        const ir::SequenceWindow& window = *comparison.cut->window;
        const auto number = ir::extremum_in(window, window.greatest, value.size(),
                                            [&](std::size_t i) { return std::bit_cast<Real>(value[i].bits); });
        const auto other = computer.real(comparison.window == 0 ? right : left);
        return comparison.window == 0 ? compared(comparison.expr->kind, number, other)
                                      : compared(comparison.expr->kind, other, number);
    }
    if (computer.is_real(left) || computer.is_real(right))
        return compared(comparison.expr->kind, computer.real(left), computer.real(right));
    return compared(comparison.expr->kind, computer.whole(left), computer.whole(right));
}

bool answer_in_model(const ir::ModelComparison& comparison, const NumberSpace& space, const TriedValue& value,
                     std::size_t place) {
    if (!comparison.cut) return comparison.answers.at(place);
    const int sign = sign_of(space, *comparison.cut, value);
    return ir::comparison_answer(comparison.expr->kind, (comparison.window == 0 ? sign : -sign) <=> 0);
}

}  // namespace robochart::conformance
