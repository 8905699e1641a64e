// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/faults/expression_faults.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "semantics/evaluate/carrier.hpp"

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

/// Pairs of functions with the same signature. A fault exchanges one for the other.
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
const Exchange* find_exchange(const Exchange (&table)[count], ExprKind kind) {
    const auto* const found =
        std::find_if(std::begin(table), std::end(table), [&](Exchange exchange) { return exchange.from == kind; });
    return found == std::end(table) ? nullptr : found;
}

bool is_commutative(ExprKind kind) {
    return kind != ExprKind::minus && kind != ExprKind::divide && kind != ExprKind::modulus && kind != ExprKind::concat;
}

/// The possible faults of one expression, without those of its operands.
class OneExpression {
public:
    OneExpression(const ir::System& system, Mutation& mutation, const Expr& expr)
        : system_(system), mutation_(mutation), expr_(expr) {}

    std::optional<Expr> apply_fault() const {
        if (const Exchange* const other = find_exchange(arithmetic, expr_.kind);
            other != nullptr && has_number_operands())
            if (hits(Fault::arithmetic_wrong)) return with_kind(other->to);
        if (const Exchange* const other = find_exchange(comparisons, expr_.kind))
            if (hits(Fault::comparison_wrong)) return with_kind(other->to);
        if (const Exchange* const other = find_exchange(logic, expr_.kind))
            if (hits(Fault::logic_wrong)) return with_kind(other->to);
        if (const Exchange* const other = find_exchange(quantifiers, expr_.kind))
            if (hits(Fault::quantifier_wrong)) return with_kind(other->to);
        const bool negation = expr_.kind == ExprKind::logical_not || expr_.kind == ExprKind::negate;
        if (negation && hits(Fault::negation_dropped)) return *expr_.args[0];
        if (!is_commutative(expr_.kind) && have_same_type(0, 1) && hits(Fault::operands_exchanged))
            return with_args_exchanged(0, 1);
        if (expr_.kind == ExprKind::if_then_else && hits(Fault::conditional_exchanged))
            return with_args_exchanged(1, 2);
        if (expr_.kind == ExprKind::is_in && hits(Fault::set_operation_wrong))
            return *negate_condition(std::make_shared<Expr>(expr_));
        if (expr_.kind == ExprKind::member) return wrong_member();
        if (expr_.kind == ExprKind::toolkit) return wrong_function();
        return wrong_literal();
    }

private:
    [[nodiscard]] bool hits(Fault fault) const { return mutation_.hits(fault); }
    [[nodiscard]] ir::TypeKind kind_of(const Expr& expr) const { return system_.type(expr.type).kind; }

    /// Returns whether all operands are single numbers, not vectors or matrices.
    [[nodiscard]] bool has_number_operands() const {
        return std::ranges::all_of(expr_.args, [&](const ir::ExprPtr& operand) {
            const ir::TypeKind type = kind_of(*operand);
            return type == ir::TypeKind::nat || type == ir::TypeKind::integer || type == ir::TypeKind::real;
        });
    }
    [[nodiscard]] bool have_same_type(std::size_t a, std::size_t b) const {
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

    [[nodiscard]] std::optional<Expr> wrong_member() const {
        const ir::Type& whole = system_.type(expr_.args[0]->type);
        const std::int64_t first = whole.kind == ir::TypeKind::product ? 1 : 0;
        for (std::size_t other = 0; other < whole.args.size(); ++other) {
            const std::int64_t number = static_cast<std::int64_t>(other) + first;
            if (number == expr_.number || whole.args[other] != expr_.type) continue;
            return hits(Fault::member_wrong) ? std::optional(with_number(number)) : std::nullopt;
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<Expr> wrong_function() const {
        std::string other = other_function(expr_.text);
        if (other.empty() || !hits(Fault::set_operation_wrong)) return std::nullopt;
        Expr changed = expr_;
        changed.text = std::move(other);
        return changed;
    }

    /// Changes a literal within its carrier: to one less, or from 0 to 1.
    [[nodiscard]] std::optional<Expr> wrong_literal() const {
        const bool number = expr_.kind == ExprKind::integer || expr_.kind == ExprKind::boolean;
        const ir::Type& type = system_.type(expr_.type);
        const bool label = expr_.kind == ExprKind::enum_literal && expr_.args.empty() && type.literal_args.empty() &&
                           type.labels.size() > 1;
        if (!(number || label) || !hits(Fault::literal_wrong)) return std::nullopt;
        return with_number(expr_.number > 0 ? expr_.number - 1 : 1);
    }

    const ir::System& system_;
    Mutation& mutation_;
    const Expr& expr_;
};

Expr literal_of(ir::TypeId type, ExprKind kind, std::int64_t number) {
    Expr result;
    result.kind = kind;
    result.type = type;
    result.number = number;
    result.decimal.unscaled = number;
    return result;
}

Expr make_operation(ExprKind kind, ir::TypeId type, std::vector<ir::ExprPtr> args) {
    Expr result;
    result.kind = kind;
    result.type = type;
    result.args = std::move(args);
    return result;
}

ir::ExprPtr number_literal(const ir::System& system, ir::TypeId type, std::int64_t value) {
    const bool real = system.type(type).kind == ir::TypeKind::real;
    return std::make_shared<Expr>(literal_of(type, real ? ExprKind::real : ExprKind::integer, value));
}

/// Returns whether the operands are the parts of a value. Their types are given by `Type::args`, or by one type for all
/// parts.
bool builds_value(ExprKind kind) {
    return kind == ExprKind::tuple || kind == ExprKind::record || kind == ExprKind::sequence || kind == ExprKind::set ||
           kind == ExprKind::matrix || kind == ExprKind::enum_literal;
}

/// Returns the type of one part of the value that `whole` builds; invalid if the part has no type.
ir::TypeId part_type(const ir::System& system, const Expr& whole, std::size_t place) {
    const ir::Type& type = system.type(whole.type);
    if (whole.kind == ExprKind::enum_literal) {
        const auto label = static_cast<std::size_t>(whole.number);
        return label < type.literal_args.size() ? type.literal_args[label].at(place) : ir::TypeId{};
    }
    const bool pairs = type.kind == ir::TypeKind::relation || type.kind == ir::TypeKind::function;
    if (pairs || type.args.empty()) return {};
    return type.args.at(type.args.size() > 1 ? place : 0);
}

ir::ExprPtr default_parts(const ir::System& system, const ir::Instantiation& inst, ir::TypeId id, ExprKind kind) {
    std::vector<ir::ExprPtr> parts;
    for (const ir::TypeId part : system.type(id).args) parts.push_back(default_literal(system, inst, part));
    const bool known = std::ranges::none_of(parts, [](const ir::ExprPtr& part) { return !part; });
    return known ? std::make_shared<Expr>(make_operation(kind, id, std::move(parts))) : nullptr;
}

}  // namespace

ir::ExprPtr default_literal(const ir::System& system, const ir::Instantiation& inst, ir::TypeId id) {
    const ir::Type& type = system.type(id);
    switch (type.kind) {
        case ir::TypeKind::boolean:
            return std::make_shared<Expr>(
                literal_of(id, ExprKind::boolean, ir::default_value(system, inst, id).number));
        case ir::TypeKind::nat:
        case ir::TypeKind::integer:
        case ir::TypeKind::real:
            return number_literal(system, id, 0);
        case ir::TypeKind::enumeration:
            if (!type.literal_args.empty()) return nullptr;
            return std::make_shared<Expr>(literal_of(id, ExprKind::enum_literal, 0));
        case ir::TypeKind::product:
            return default_parts(system, inst, id, ExprKind::tuple);
        case ir::TypeKind::record:
            return default_parts(system, inst, id, ExprKind::record);
        case ir::TypeKind::sequence:
            return std::make_shared<Expr>(make_operation(ExprKind::sequence, id, {}));
        case ir::TypeKind::set:
            return std::make_shared<Expr>(make_operation(ExprKind::set, id, {}));
        case ir::TypeKind::string:
        case ir::TypeKind::given:
        case ir::TypeKind::function:
        case ir::TypeKind::relation:
        case ir::TypeKind::vector:
        case ir::TypeKind::matrix:
        case ir::TypeKind::unit:
            return nullptr;
    }
    return nullptr;
}

ir::ExprPtr one_literal(const ir::System& system, ir::TypeId type) {
    return number_literal(system, type, 1);
}

ir::ExprPtr one_more(const ir::System& system, const ir::ExprPtr& expr) {
    if (expr->kind == ExprKind::integer) return number_literal(system, expr->type, expr->number + 1);
    return std::make_shared<Expr>(make_operation(ExprKind::plus, expr->type, {expr, one_literal(system, expr->type)}));
}

ir::ExprPtr one_less(const ir::System& system, const ir::ExprPtr& expr) {
    const ir::ExprPtr none = number_literal(system, expr->type, 0);
    if (expr->kind == ExprKind::integer)
        return expr->number > 0 ? number_literal(system, expr->type, expr->number - 1) : nullptr;
    const auto more = std::make_shared<Expr>(
        make_operation(ExprKind::greater, ir::boolean_type, {expr, one_literal(system, expr->type)}));
    const auto less =
        std::make_shared<Expr>(make_operation(ExprKind::minus, expr->type, {expr, one_literal(system, expr->type)}));
    return std::make_shared<Expr>(make_operation(ExprKind::if_then_else, expr->type, {more, less, none}));
}

ir::ExprPtr negate_condition(const ir::ExprPtr& expr) {
    return std::make_shared<Expr>(make_operation(ExprKind::logical_not, expr->type, {expr}));
}

ir::ExprPtr ExpressionFaults::rewrite_field(const Expr& whole, std::size_t place, const ir::ExprPtr& part) {
    const ir::TypeId type = part_type(system_, whole, place);
    const ir::ExprPtr literal = type.is_valid() ? default_literal(system_, inst_, type) : nullptr;
    return literal && mutation_.hits(Fault::field_dropped) ? literal : part;
}

std::vector<ir::ExprPtr> ExpressionFaults::rewrite_operands(const Expr& expr) {
    std::vector<ir::ExprPtr> result;
    for (std::size_t i = 0; i < expr.args.size(); ++i) {
        const bool place = expr.kind == ExprKind::index && i > 0;
        ir::ExprPtr part = place ? rewrite_place(expr.args[i]) : rewrite(expr.args[i]);
        result.push_back(builds_value(expr.kind) ? rewrite_field(expr, i, part) : std::move(part));
    }
    return result;
}

ir::ExprPtr ExpressionFaults::rewrite_place(const ir::ExprPtr& expr) {
    const ir::ExprPtr place = rewrite(expr);
    return mutation_.hits(Fault::index_off_by_one) ? one_more(system_, place) : place;
}

ir::ExprPtr ExpressionFaults::rewrite(const ir::ExprPtr& expr) {
    if (!expr) return expr;
    const auto found = known_.find(expr.get());
    if (found != known_.end()) return found->second;
    Expr changed = *expr;
    changed.args = rewrite_operands(*expr);
    const std::optional<Expr> wrong = OneExpression(system_, mutation_, changed).apply_fault();
    ir::ExprPtr result = expr;
    if (wrong || changed.args != expr->args) result = std::make_shared<Expr>(wrong ? *wrong : std::move(changed));
    known_.emplace(expr.get(), result);
    return result;
}

}  // namespace robochart::cpp_emit
