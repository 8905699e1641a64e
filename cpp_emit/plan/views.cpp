// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/plan/views.hpp"

#include <algorithm>
#include <string_view>

#include "cpp_emit/plan/types.hpp"
#include "semantics/evaluate/preconditions.hpp"
#include "semantics/evaluate/toolkit.hpp"

namespace robochart::cpp_emit {

using ir::Expr;
using ir::ExprKind;
using ir::System;
using ir::TypeId;
using ir::TypeKind;

namespace {

bool is_toolkit(const Expr& expr, std::string_view function) {
    return expr.kind == ExprKind::toolkit && expr.text == function;
}

bool is_concatenation(const Expr& expr) {
    return expr.kind == ExprKind::concat || is_toolkit(expr, "sequence_toolkit_concat");
}

bool is_collection(const System& system, const Expr& expr) {
    const TypeKind kind = system.type(expr.type).kind;
    return kind == TypeKind::sequence || kind == TypeKind::set;
}

TypeId element_type(const System& system, const Expr& collection) {
    return system.type(collection.type).args.at(0);
}

bool is_whole_number(const System& system, TypeId type) {
    return is_numeric(system.type(type).kind) && system.type(type).kind != TypeKind::real;
}

bool is_interval(const System& system, const Expr& expr) {
    return (expr.kind == ExprKind::range || expr.kind == ExprKind::set_range) &&
           is_whole_number(system, element_type(system, expr));
}

bool is_empty_literal(const Expr& expr) {
    if (expr.kind == ExprKind::cast) return is_empty_literal(*expr.args.at(0));
    return (expr.kind == ExprKind::set || expr.kind == ExprKind::sequence) && expr.args.empty();
}

bool visits_parts(const System& system, const Expr& expr) {
    const TypeId element = element_type(system, expr);
    const auto part = [&](std::size_t i) { return can_be_visited(system, *expr.args.at(i), element); };
    if (is_toolkit(expr, "set_toolkit_union") || is_toolkit(expr, "set_toolkit_inter") ||
        is_toolkit(expr, "set_toolkit_diff") || is_toolkit(expr, "sequence_toolkit_filter") || is_concatenation(expr))
        return part(0) && part(1);
    if (is_toolkit(expr, "sequence_toolkit_extract")) {
        const Expr& places = *expr.args.at(0);
        return is_collection(system, places) && is_whole_number(system, element_type(system, places)) && part(1) &&
               !is_view(system, *expr.args[1]);
    }
    if (is_toolkit(expr, "relation_toolkit_ran")) {
        const Expr* const sequence = sequence_of_pairs(system, *expr.args.at(0));
        return sequence != nullptr && can_be_visited(system, *sequence, element);
    }
    return false;
}

}  // namespace

const Expr* sequence_of_pairs(const System& system, const Expr& expr) {
    if (expr.kind != ExprKind::cast) return nullptr;
    const ir::Type& whole = system.type(expr.type);
    const Expr& from = *expr.args.at(0);
    const bool pairs = has_pairs(whole) || whole.kind == TypeKind::set;
    return pairs && system.type(from.type).kind == TypeKind::sequence ? &from : nullptr;
}

bool is_view(const System& system, const Expr& expr) {
    if (!expr.type.is_valid() || !is_collection(system, expr)) return false;
    if (expr.kind == ExprKind::set) return !expr.args.empty();
    if (expr.kind == ExprKind::set_comprehension)
        return expr.bound_names.size() == 1 && generators(system, expr).front().collection != nullptr;
    if (expr.kind == ExprKind::concat || expr.kind == ExprKind::toolkit) return visits_parts(system, expr);
    return is_interval(system, expr);
}

bool can_be_visited(const System& system, const Expr& expr, TypeId element) {
    return is_collection(system, expr) && element_type(system, expr) == element;
}

bool folds(const System& system, const Expr& expr, std::size_t operand) {
    const auto argument = [&](std::size_t i) -> const Expr& { return *expr.args.at(i); };
    const auto has_elements_of = [&](std::size_t i, TypeId type) { return element_type(system, argument(i)) == type; };
    if (expr.kind == ExprKind::is_in)
        return operand == 1 && !is_interval(system, argument(1)) && is_view(system, argument(1));
    if (expr.kind == ExprKind::equal || expr.kind == ExprKind::not_equal)
        return is_empty_literal(argument(1 - operand)) && is_view(system, argument(operand));
    if (expr.kind != ExprKind::toolkit) return false;
    if (is_toolkit(expr, "sequence_toolkit_size")) {
        if (operand != 0) return false;
        const Expr* const sequence = sequence_of_pairs(system, argument(0));
        return sequence != nullptr || is_view(system, argument(0));
    }
    if (is_toolkit(expr, "sequence_toolkit_min") || is_toolkit(expr, "sequence_toolkit_max") ||
        is_toolkit(expr, "sequence_toolkit_hasMin") || is_toolkit(expr, "sequence_toolkit_hasMax") ||
        is_toolkit(expr, "sequence_toolkit_isNonEmpty"))
        return is_view(system, argument(0));
    if (is_toolkit(expr, "set_toolkit_notin")) return operand == 1 && is_view(system, argument(1));
    if (is_toolkit(expr, "set_toolkit_subseteq"))
        return is_collection(system, argument(0)) && is_collection(system, argument(1)) &&
               has_elements_of(1 - operand, element_type(system, argument(operand))) &&
               (is_view(system, argument(0)) || is_view(system, argument(1)));
    return false;
}

namespace {

void append_conjuncts(const Expr& condition, std::vector<const Expr*>& list) {
    if (condition.kind != ExprKind::conjunction) return list.push_back(&condition);
    for (const ir::ExprPtr& part : condition.args) append_conjuncts(*part, list);
}

std::vector<const Expr*> conjuncts_of_predicate(const Expr& binder) {
    std::vector<const Expr*> result;
    if (!binder.args.empty() && binder.args[0]) append_conjuncts(*binder.args[0], result);
    return result;
}

/// Returns whether a function in the expression may have no value for some arguments.
bool calls_partial_function(const System& system, const Expr& expr) {
    const bool partial = expr.kind == ExprKind::toolkit
                             ? ir::toolkit_precondition(expr.text)
                             : expr.kind == ExprKind::call && expr.function.is_valid() &&
                                   !system.functions.at(expr.function.index).preconditions.empty();
    return partial || std::ranges::any_of(expr.args, [&](const ir::ExprPtr& part) {
               return part && calls_partial_function(system, *part);
           });
}

/// Returns whether the elements of the collection are elements of collections that the model stores. Such elements are
/// values of their type in every instantiation. An interval may contain numbers outside the carrier.
bool holds_stored_values(const System& system, const Expr& expr) {
    if (expr.kind == ExprKind::variable || expr.kind == ExprKind::trigger_value || expr.kind == ExprKind::constant ||
        expr.kind == ExprKind::member || expr.kind == ExprKind::bound || expr.kind == ExprKind::sequence ||
        expr.kind == ExprKind::set)
        return true;
    if (expr.kind != ExprKind::toolkit || !is_view(system, expr)) return false;
    if (is_toolkit(expr, "relation_toolkit_ran"))
        return holds_stored_values(system, *sequence_of_pairs(system, *expr.args.at(0)));
    if (is_toolkit(expr, "sequence_toolkit_extract")) return holds_stored_values(system, *expr.args.at(1));
    const bool both = is_toolkit(expr, "set_toolkit_union") || is_concatenation(expr);
    return holds_stored_values(system, *expr.args.at(0)) && (!both || holds_stored_values(system, *expr.args.at(1)));
}

bool uses_bound_name(const Expr& expr, const std::vector<std::string>& names) {
    const bool used = expr.kind == ExprKind::bound && std::ranges::find(names, expr.text) != names.end();
    return used || std::ranges::any_of(expr.args,
                                       [&](const ir::ExprPtr& part) { return part && uses_bound_name(*part, names); });
}

bool may_have_generators(const System& system, const Expr& expr) {
    return ir::binds_names(expr.kind) && expr.kind != ExprKind::exists_unique && !expr.args.empty() && expr.args[0] &&
           !calls_partial_function(system, *expr.args[0]);
}

/// Returns whether the condition is `name in collection`, and the collection generates all values of the variable.
bool generates(const System& system, const Expr& binder, std::size_t variable, const Expr& condition) {
    if (condition.kind != ExprKind::is_in) return false;
    const Expr& element = *condition.args.at(0);
    const Expr& collection = *condition.args.at(1);
    return element.kind == ExprKind::bound && element.text == binder.bound_names[variable] &&
           can_be_visited(system, collection, binder.bound_types.at(variable)) &&
           !uses_bound_name(collection, binder.bound_names) && holds_stored_values(system, collection);
}

/// Returns the condition that generates the variable's values, or null if there is none.
const Expr* generating_condition(const System& system, const Expr& binder, std::size_t variable) {
    if (!may_have_generators(system, binder)) return nullptr;
    for (const Expr* condition : conjuncts_of_predicate(binder))
        if (generates(system, binder, variable, *condition)) return condition;
    return nullptr;
}

}  // namespace

std::vector<Generator> generators(const System& system, const Expr& expr) {
    std::vector<Generator> result(expr.bound_names.size());
    for (std::size_t i = 0; i < result.size(); ++i)
        if (const Expr* const condition = generating_condition(system, expr, i))
            result[i].collection = condition->args.at(1).get();
    return result;
}

bool has_generator(const System& system, const Expr& expr) {
    const std::vector<Generator> all = generators(system, expr);
    return std::ranges::any_of(all, [](const Generator& generator) { return generator.collection != nullptr; });
}

bool visits_in_place(const System& system, const Expr& expr) {
    if (has_generator(system, expr)) return true;
    const bool partial = expr.kind == ExprKind::toolkit && ir::toolkit_precondition(expr.text);
    if (partial && is_view(system, *expr.args.at(0))) return true;  // the precondition visits it
    for (std::size_t i = 0; i < expr.args.size(); ++i) {
        if (!expr.args[i] || !folds(system, expr, i)) continue;
        const Expr* const sequence = sequence_of_pairs(system, *expr.args[i]);
        if (is_view(system, sequence == nullptr ? *expr.args[i] : *sequence)) return true;
    }
    return false;
}

std::vector<const Expr*> conditions_besides_generators(const System& system, const Expr& expr) {
    std::vector<const Expr*> result = conjuncts_of_predicate(expr);
    for (std::size_t i = 0; i < expr.bound_names.size(); ++i) std::erase(result, generating_condition(system, expr, i));
    return result;
}

namespace {

/// Returns whether the operand of a view is a collection that the view visits.
bool is_visited(const System& system, const Expr& view, std::size_t operand) {
    const Expr& part = *view.args.at(operand);
    return (view.kind == ExprKind::toolkit || view.kind == ExprKind::concat) &&
           (is_view(system, part) || sequence_of_pairs(system, part) != nullptr);
}

class ValueVisitor {
public:
    ValueVisitor(const System& system, const ExprVisitor& visitor) : system_(system), visitor_(visitor) {}

    void visit_value(const Expr& expr) {
        visitor_(expr);
        for (std::size_t i = 0; i < expr.args.size(); ++i) {
            if (!expr.args[i]) continue;
            if (folds(system_, expr, i)) {
                visit_in_place(*expr.args[i]);
            } else if (i == 0 && has_generator(system_, expr)) {
                visit_predicate(expr);
            } else {
                visit_value(*expr.args[i]);
            }
        }
    }

private:
    void visit_predicate(const Expr& binder) {
        for (const Generator& generator : generators(system_, binder))
            if (generator.collection != nullptr) visit_in_place(*generator.collection);
        for (const Expr* condition : conditions_besides_generators(system_, binder)) visit_value(*condition);
    }

    /// Visits a collection that the code visits in place. A collection that is not a view has to be built, so it is
    /// visited as a value.
    void visit_in_place(const Expr& expr) {
        if (const Expr* const sequence = sequence_of_pairs(system_, expr)) return visit_in_place(*sequence);
        if (!is_view(system_, expr)) return visit_value(expr);
        if (has_generator(system_, expr)) visit_predicate(expr);
        for (std::size_t i = has_generator(system_, expr) ? 1 : 0; i < expr.args.size(); ++i) {
            if (!expr.args[i]) continue;
            if (is_visited(system_, expr, i))
                visit_in_place(*expr.args[i]);
            else
                visit_value(*expr.args[i]);
        }
    }

    const System& system_;
    const ExprVisitor& visitor_;
};

}  // namespace

void visit_values(const System& system, const Expr& expr, const ExprVisitor& visitor) {
    ValueVisitor(system, visitor).visit_value(expr);
}

}  // namespace robochart::cpp_emit
