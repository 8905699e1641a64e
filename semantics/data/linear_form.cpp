// SPDX-License-Identifier: Apache-2.0
#include "semantics/data/linear_form.hpp"

#include "semantics/ir/arithmetic.hpp"

namespace robochart::ir {
namespace {

constexpr std::size_t most_pieces = 64;

/// Returns sum + number * factor, or no value if it is not between -limit and limit.
std::optional<std::int64_t> add_product(std::int64_t sum, std::int64_t number, std::int64_t factor,
                                        std::int64_t limit) {
    const auto product = checked_multiply(number, factor);
    const auto total = product ? checked_add(sum, *product) : std::nullopt;
    const bool fits = total && *total > -limit && *total < limit;
    return fits ? total : std::nullopt;
}

/// Returns a + factor * b for all pairs of forms.
LinearReader::Forms add_multiples(const LinearReader::Forms& a, const LinearReader::Forms& b, std::int64_t factor) {
    if (!a || !b) return std::nullopt;
    std::set<LinearForm> result;
    for (const LinearForm& left : *a)
        for (const LinearForm& right : *b) {
            const auto sum = add_multiple(left, right, factor);
            if (!sum) return std::nullopt;
            result.insert(*sum);
        }
    if (result.size() > most_pieces) return std::nullopt;
    return result;
}

bool is_number(TypeKind kind) {
    return kind == TypeKind::real || kind == TypeKind::integer || kind == TypeKind::nat;
}

}  // namespace

std::optional<LinearForm> add_multiple(const LinearForm& a, const LinearForm& b, std::int64_t factor) {
    LinearForm result = a;
    const auto constant = add_product(a.constant, b.constant, factor, greatest_coordinate);
    if (!constant) return std::nullopt;
    result.constant = *constant;
    for (const auto& [component, coefficient] : b.coefficients) {
        const auto sum = add_product(result.coefficients[component], coefficient, factor, greatest_coefficient);
        if (!sum) return std::nullopt;
        result.coefficients[component] = *sum;
        if (*sum == 0) result.coefficients.erase(component);
    }
    return result;
}

std::optional<LinearForm> LinearReader::read_closed(const Expr& expr) const {
    const TypeKind kind = system_.type(expr.type).kind;
    const auto value = is_number(kind) ? closed_(expr) : std::nullopt;
    if (!value) return std::nullopt;
    const auto units = kind == TypeKind::real ? std::optional(value->number) : checked_multiply(value->number, scale_);
    if (!units || *units >= greatest_coordinate || *units <= -greatest_coordinate) return std::nullopt;
    return LinearForm{{}, *units};
}

LinearReader::Forms LinearReader::read_sum(const Expr& expr, std::int64_t factor) const {
    return add_multiples(read(*expr.args.at(0)), read(*expr.args.at(1)), factor);
}

LinearReader::Forms LinearReader::read_multiple(const Expr& expr) const {
    for (const std::size_t side : {0U, 1U}) {
        const auto factor = read_closed(*expr.args.at(side));
        if (factor && factor->constant % scale_ == 0)
            return add_multiples(std::set{LinearForm{}}, read(*expr.args.at(1 - side)), factor->constant / scale_);
    }
    return std::nullopt;
}

/// See linear_form.hpp. The recursion is as deep as the expression.
LinearReader::Forms LinearReader::read(const Expr& expr) const {
    if (const auto closed = read_closed(expr)) return std::set{*closed};
    const bool natural = system_.type(expr.type).kind == TypeKind::nat;
    if (natural && expr.kind == ExprKind::minus) return std::nullopt;  // a negative difference is another number
    if (expr.kind == ExprKind::plus) return read_sum(expr, 1);
    if (expr.kind == ExprKind::minus) return read_sum(expr, -1);
    if (expr.kind == ExprKind::times) return read_multiple(expr);
    if (expr.kind == ExprKind::negate) return add_multiples(std::set{LinearForm{}}, read(*expr.args.at(0)), -1);
    if (expr.kind == ExprKind::cast && system_.type(expr.type).kind == TypeKind::real) return read(*expr.args.at(0));
    return read_part_(expr);
}

}  // namespace robochart::ir
