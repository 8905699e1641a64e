// SPDX-License-Identifier: Apache-2.0
// Writes folds over collections that are visited in place (plan/views.hpp, runtime/views.hpp).
#include <fmt/format.h>

#include <cassert>
#include <string_view>

#include "cpp_emit/expressions/expression.hpp"
#include "cpp_emit/plan/types.hpp"
#include "cpp_emit/plan/views.hpp"

namespace robochart::cpp_emit {

using ir::ExprKind;

namespace {

std::string toolkit_function(const ir::Expr& expr) {
    return expr.text.substr(expr.text.find("toolkit_") + std::string_view("toolkit_").size());
}

}  // namespace

/// Returns `robochart::view::Interval<Nat>(low, high)`. Open bounds are excluded.
std::string ExpressionWriter::view_of_interval(const ir::Expr& expr) const {
    const ir::TypeId member = generation_.system.type(expr.type).args.at(0);
    const bool written = expr.kind == ExprKind::range;
    const bool open_low = written && (expr.number == 1 || expr.number == 3);
    const bool open_high = written && expr.number >= 2;
    const std::string less = open_low || open_high ? fmt::format(", {:d}, {:d}", open_low, open_high) : "";
    return fmt::format("robochart::view::Interval<{}>({}, {}{})", type_text(member), write_as(*expr.args[0], member),
                       write_as(*expr.args[1], member), less);
}

/// Returns the elements of the generator that satisfy the rest of the predicate, and the results of the body for them.
std::string ExpressionWriter::view_of_comprehension(const ir::Expr& expr) const {
    const std::string parameter = fmt::format("[[maybe_unused]] const {}& {}", type_text(expr.bound_types.at(0)),
                                              bound_identifier(expr.bound_names.at(0)));
    std::string text = write_view(*generators(generation_.system, expr).front().collection);
    if (!conditions_besides_generators(generation_.system, expr).empty())
        text = fmt::format("robochart::view::select({}, [&]({}) {{ return {}; }})", text, parameter,
                           predicate_of(expr).whole_text());
    if (expr.args.size() < 2 || !expr.args[1]) return text;
    const ir::TypeId member = generation_.system.type(expr.type).args.at(0);
    return fmt::format("robochart::view::image<{}>({}, [&]({}) {{ return {}; }})", type_text(member), text, parameter,
                       write_as(*expr.args[1], member));
}

/// Returns the collection as a view. A collection that cannot be visited in place is built first.
std::string ExpressionWriter::write_view(const ir::Expr& expr) const {
    if (const ir::Expr* const sequence = sequence_of_pairs(generation_.system, expr)) return write_view(*sequence);
    if (!is_view(generation_.system, expr)) return fmt::format("robochart::view::items({})", write(expr));
    const ir::TypeId member = generation_.system.type(expr.type).args.at(0);
    if (expr.kind == ExprKind::range || expr.kind == ExprKind::set_range) return view_of_interval(expr);
    if (expr.kind == ExprKind::set)
        return fmt::format("robochart::view::literal<{}>({})", type_text(member), argument_list(expr, {member}));
    if (expr.kind == ExprKind::set_comprehension) return view_of_comprehension(expr);
    const std::string function = expr.kind == ExprKind::concat ? "concat" : toolkit_function(expr);
    if (function == "ran") return write_view(*expr.args.at(0));
    return fmt::format("robochart::view::{}({}, {})", function == "union" ? "union_" : function,
                       write_view(*expr.args.at(0)), write_view(*expr.args.at(1)));
}

/// Returns the condition that the view has an element.
CppExpr ExpressionWriter::view_has_elements(const ir::Expr& view) const {
    return negation(CppExpr(fmt::format("robochart::view::empty({})", write_view(view))));
}

/// Writes `min`, `size` and similar functions of a view.
CppExpr ExpressionWriter::fold_of_toolkit(const ir::Expr& expr) const {
    const std::string function = toolkit_function(expr);
    const ir::Expr& first = *expr.args.at(0);
    const auto call = [&](const char* name) {
        return CppExpr(fmt::format("robochart::view::{}<{}>({})", name, type_text(expr.type), write_view(first)));
    };
    if (function == "min") return call("min");
    if (function == "max") return call("max");
    if (function == "hasMin" || function == "hasMax" || function == "isNonEmpty") return view_has_elements(first);
    if (function == "notin") return negation(membership_in_view(expr));
    if (function == "subseteq")
        return CppExpr(
            fmt::format("robochart::view::subseteq({}, {})", write_view(first), write_view(*expr.args.at(1))));
    assert(function == "size");
    const ir::Expr* const sequence = sequence_of_pairs(generation_.system, first);
    if (sequence == nullptr) return call("size");
    if (is_view(generation_.system, *sequence)) return call("length");
    return CppExpr(fmt::format("robochart::toolkit::size<{}>({})", type_text(expr.type), write(*sequence)));
}

CppExpr ExpressionWriter::membership_in_view(const ir::Expr& expr) const {
    const ir::Expr& set = *expr.args.at(1);
    return CppExpr(fmt::format("robochart::view::contains({}, {})", write_view(set),
                               write_as(*expr.args.at(0), generation_.system.type(set.type).args.at(0))));
}

/// Writes a fold. The result is empty unless the operator is a fold of a view.
CppExpr ExpressionWriter::write_fold(const ir::Expr& expr) const {
    for (std::size_t i = 0; i < expr.args.size(); ++i) {
        if (!expr.args[i] || !folds(generation_.system, expr, i)) continue;
        if (expr.kind == ExprKind::is_in) return membership_in_view(expr);
        if (expr.kind == ExprKind::not_equal) return view_has_elements(*expr.args[i]);
        if (expr.kind == ExprKind::equal)
            return CppExpr(fmt::format("robochart::view::empty({})", write_view(*expr.args[i])));
        return fold_of_toolkit(expr);
    }
    return {};
}

/// Returns the predicate without the conditions over whose collections the bound variables range; empty if nothing
/// remains.
CppExpr ExpressionWriter::predicate_of(const ir::Expr& binder) const {
    if (!has_generator(generation_.system, binder)) return cpp_expression(*binder.args.at(0));
    CppExpr result;
    for (const ir::Expr* condition : conditions_besides_generators(generation_.system, binder))
        result = conjunction(result, cpp_expression(*condition), Binding::primary);
    return result;
}

}  // namespace robochart::cpp_emit
