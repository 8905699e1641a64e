#include "cpp_emit/expressions/expression_faults.hpp"

#include <algorithm>
#include <string_view>

namespace robochart::cpp_emit {

namespace {

using ir::Expr;
using ir::ExprKind;

struct Exchange {
    ExprKind from;
    ExprKind to;
};

constexpr Exchange arithmetic[] = {{ExprKind::plus, ExprKind::minus},
                                   {ExprKind::minus, ExprKind::plus},
                                   {ExprKind::times, ExprKind::plus},
                                   {ExprKind::divide, ExprKind::modulus},
                                   {ExprKind::modulus, ExprKind::divide}};
constexpr Exchange comparisons[] = {
    {ExprKind::less, ExprKind::less_equal},       {ExprKind::less_equal, ExprKind::less},
    {ExprKind::greater, ExprKind::greater_equal}, {ExprKind::greater_equal, ExprKind::greater},
    {ExprKind::equal, ExprKind::not_equal},       {ExprKind::not_equal, ExprKind::equal}};
constexpr Exchange logic[] = {{ExprKind::conjunction, ExprKind::disjunction},
                              {ExprKind::disjunction, ExprKind::conjunction},
                              {ExprKind::implies, ExprKind::iff}};
constexpr Exchange quantifiers[] = {{ExprKind::forall, ExprKind::exists}, {ExprKind::exists, ExprKind::forall}};

/// Functions of the same signature, each way.
constexpr std::pair<std::string_view, std::string_view> functions[] = {
    {"set_toolkit_union", "set_toolkit_inter"},         {"set_toolkit_diff", "set_toolkit_union"},
    {"set_toolkit_Union", "set_toolkit_Inter"},         {"set_toolkit_subset", "set_toolkit_subseteq"},
    {"relation_toolkit_dres", "relation_toolkit_dsub"}, {"relation_toolkit_rres", "relation_toolkit_rsub"},
    {"sequence_toolkit_head", "sequence_toolkit_last"}, {"sequence_toolkit_tail", "sequence_toolkit_front"},
    {"sequence_toolkit_min", "sequence_toolkit_max"},   {"sequence_toolkit_prefix", "sequence_toolkit_suffix"}};

std::string other_function(std::string_view name) {
    for (const auto& [one, other] : functions) {
        if (name == one) return std::string(other);
        if (name == other) return std::string(one);
    }
    return {};
}

template <std::size_t count>
const Exchange* exchange(const Exchange (&table)[count], ExprKind kind) {
    const auto* const found =
        std::find_if(std::begin(table), std::end(table), [&](Exchange each) { return each.from == kind; });
    return found == std::end(table) ? nullptr : found;
}

bool commutes(ExprKind kind) {
    return kind != ExprKind::minus && kind != ExprKind::divide && kind != ExprKind::modulus && kind != ExprKind::concat;
}

class Faulty {
public:
    Faulty(const Generation& generation, const Unit& unit, const Expr& expr)
        : generation_(generation), unit_(unit), expr_(expr) {}

    std::optional<Expr> write() const {
        if (const Exchange* const other = exchange(arithmetic, expr_.kind); other != nullptr && numbers())
            if (hits(Fault::arithmetic_wrong)) return with_kind(other->to);
        if (const Exchange* const other = exchange(comparisons, expr_.kind))
            if (hits(Fault::comparison_wrong)) return with_kind(other->to);
        if (const Exchange* const other = exchange(logic, expr_.kind))
            if (hits(Fault::logic_wrong)) return with_kind(other->to);
        if (const Exchange* const other = exchange(quantifiers, expr_.kind))
            if (hits(Fault::quantifier_wrong)) return with_kind(other->to);
        const bool negation = expr_.kind == ExprKind::logical_not || expr_.kind == ExprKind::negate;
        if (negation && hits(Fault::negation_dropped)) return *expr_.args[0];
        if (!commutes(expr_.kind) && alike(0, 1) && hits(Fault::operands_exchanged)) return with_args_exchanged(0, 1);
        if (expr_.kind == ExprKind::if_then_else && hits(Fault::conditional_exchanged))
            return with_args_exchanged(1, 2);
        if (expr_.kind == ExprKind::member) return member();
        if (expr_.kind == ExprKind::toolkit) return function();
        return literal();
    }

private:
    [[nodiscard]] bool hits(Fault fault) const { return generation_.mutation.hits(fault, &unit_, &expr_); }
    [[nodiscard]] ir::TypeKind kind(const Expr& expr) const { return generation_.system.type(expr.type).kind; }

    /// All operands are single numbers, not vectors or matrices.
    [[nodiscard]] bool numbers() const {
        return std::all_of(expr_.args.begin(), expr_.args.end(), [&](const ir::ExprPtr& each) {
            const ir::TypeKind type = kind(*each);
            return type == ir::TypeKind::nat || type == ir::TypeKind::integer || type == ir::TypeKind::real;
        });
    }
    [[nodiscard]] bool alike(std::size_t a, std::size_t b) const {
        return expr_.args.size() > b && expr_.args[a]->type == expr_.args[b]->type;
    }

    [[nodiscard]] Expr with_kind(ExprKind kind) const {
        Expr changed = expr_;
        changed.kind = kind;
        return changed;
    }
    [[nodiscard]] Expr with_args_exchanged(std::size_t a, std::size_t b) const {
        Expr changed = expr_;
        std::swap(changed.args[a], changed.args[b]);
        return changed;
    }
    [[nodiscard]] Expr with_number(std::int64_t number) const {
        Expr changed = expr_;
        changed.number = number;
        return changed;
    }

    [[nodiscard]] std::optional<Expr> member() const {
        const ir::Type& whole = generation_.system.type(expr_.args[0]->type);
        const std::int64_t first = whole.kind == ir::TypeKind::product ? 1 : 0;
        for (std::size_t other = 0; other < whole.args.size(); ++other) {
            const std::int64_t number = static_cast<std::int64_t>(other) + first;
            if (number == expr_.number || whole.args[other] != expr_.type) continue;
            return hits(Fault::member_wrong) ? std::optional(with_number(number)) : std::nullopt;
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<Expr> function() const {
        std::string other = other_function(expr_.text);
        if (other.empty() || !hits(Fault::set_operation_wrong)) return std::nullopt;
        Expr changed = expr_;
        changed.text = std::move(other);
        return changed;
    }

    /// Numbers stay in their carrier: one less, or 1 for 0.
    [[nodiscard]] std::optional<Expr> literal() const {
        const bool number = expr_.kind == ExprKind::integer || expr_.kind == ExprKind::boolean;
        const ir::Type& type = generation_.system.type(expr_.type);
        const bool label = expr_.kind == ExprKind::enum_literal && expr_.args.empty() && type.literal_args.empty() &&
                           type.labels.size() > 1;
        if (!(number || label) || !hits(Fault::literal_wrong)) return std::nullopt;
        return with_number(expr_.number > 0 ? expr_.number - 1 : 1);
    }

    const Generation& generation_;
    const Unit& unit_;
    const Expr& expr_;
};

}  // namespace

std::optional<ir::Expr> faulty(const Generation& generation, const Unit& unit, const ir::Expr& expr) {
    return Faulty(generation, unit, expr).write();
}

}  // namespace robochart::cpp_emit
