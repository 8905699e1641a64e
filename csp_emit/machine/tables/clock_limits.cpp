// SPDX-License-Identifier: Apache-2.0
// Combines the values that guards compare with a clock to one limit.
#include "csp_emit/machine/tables/clock_limits.hpp"

#include <algorithm>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/base/types.hpp"
#include "csp_emit/expressions/expressions.hpp"
#include "semantics/ir/arithmetic.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;
using Op = cspm::ExprKind;

namespace {

bool is_comparison(ir::ExprKind kind) {
    return kind == ir::ExprKind::equal || kind == ir::ExprKind::greater || kind == ir::ExprKind::greater_equal ||
           kind == ir::ExprKind::less || kind == ir::ExprKind::less_equal || kind == ir::ExprKind::not_equal;
}

const ir::Expr& without_casts(const ir::Expr& expr) {
    const ir::Expr* inner = &expr;
    while (inner->kind == ir::ExprKind::cast) inner = inner->args.at(0).get();
    return *inner;
}

/// Collects the values with which the machine's guards compare the named clock (or the clock of a state).
class ClockBounds {
public:
    ClockBounds(const ir::Machine& machine, std::string clock, ir::NodeId entry_of)
        : machine_(machine), clock_(std::move(clock)), entry_of_(entry_of) {}

    /// Collects the bounds. Returns false if a guard uses the clock in a way that rule TE4 forbids, that is, not as a
    /// side of a comparison.
    bool collect_bounds(std::vector<const ir::Expr*>& bounds) const {
        bool direct = true;
        for (const ir::Transition& transition : machine_.transitions)
            if (transition.guard) direct = visit_comparisons(*transition.guard, bounds) && direct;
        return direct;
    }

private:
    bool is_clock(const ir::Expr& expr) const {
        if (expr.kind == ir::ExprKind::since_entry) return entry_of_.is_valid() && expr.node == entry_of_;
        return expr.kind == ir::ExprKind::since && machine_.clocks.at(expr.clock.index).name == clock_;
    }
    bool visit_comparisons(const ir::Expr& expr, std::vector<const ir::Expr*>& bounds) const {
        if (is_clock(expr)) return false;
        bool direct = true;
        for (std::size_t i = 0; i < expr.args.size(); ++i) {
            const bool side = is_comparison(expr.kind) && is_clock(without_casts(*expr.args[i]));
            if (side)
                bounds.push_back(expr.args[1 - i].get());
            else
                direct = visit_comparisons(*expr.args[i], bounds) && direct;
        }
        return direct;
    }
    const ir::Machine& machine_;
    std::string clock_;
    ir::NodeId entry_of_;
};

/// Returns value + 1. The largest number is not increased, because no run is long enough for a clock to exceed it.
ExprPtr plus_one(const ExprPtr& value) {
    if (value->kind == Op::integer) return b::number(ir::number_after(value->number));
    return b::binary(Op::plus, value, b::number(1));
}

}  // namespace

ExprPtr ClockLimits::limit_of(const ir::Machine& opened, const std::string& clock, ir::NodeId entry_of) {
    std::int64_t literal = 0;
    b::Exprs sets;
    auto machines = calls_.callable_operations();
    std::erase(machines, &opened);
    machines.insert(machines.begin(), &opened);
    for (const ir::Machine* checked : machines) {
        if (checked != &opened && entry_of.is_valid()) continue;
        std::vector<const ir::Expr*> bounds;
        if (!ClockBounds(*checked, clock, entry_of).collect_bounds(bounds))
            project_.report_unsupported("since(" + clock + ") outside a comparison", checked->origin.span);
        for (const ir::Expr* bound : bounds) {
            std::vector<cspm::Clause> variables;
            const ExprPtr value = bound_in_units(*checked, *bound, variables);
            if (value->kind == Op::integer)
                literal = std::max(literal, value->number);
            else
                sets.push_back(variables.empty() ? b::set({value}) : b::set_comprehension({value}, variables));
        }
    }
    if (sets.empty()) return plus_one(b::number(literal));
    sets.push_back(b::set({b::number(literal)}));
    const std::string name = names_.unique_name("CLID_" + flatten_name(clock) + "_max");
    const ExprPtr largest = b::call("clock_type_max", {b::call("Union", {b::set(sets)})});
    declarations_.push_back(b::function_decl(name, b::variables(calls_.constants_inside()), plus_one(largest),
                                             "where clock " + clock + " saturates"));
    return call_of(name, calls_.constants_inside());
}

/// Returns a bound in whole time units, rounded up. Variables range over all values of their types.
ExprPtr ClockLimits::bound_in_units(const ir::Machine& checked, const ir::Expr& bound,
                                    std::vector<cspm::Clause>& variables) const {
    Scope names;
    names.variable = [&](ir::VariableId id) {
        const std::string name = "b" + std::to_string(id.index) + "__";
        variables.push_back(b::generator(name, type_set(project_, checked.variables.at(id.index).type)));
        return b::name(name);
    };
    names.constant = [&](ir::ConstantId id) {
        const auto same = [&](const ConstantParameter& c) { return c.owner == &checked && c.id == id; };
        const auto& constants = calls_.constants();
        return b::name(std::ranges::find_if(constants, same)->inside);
    };
    names.placed = false;  // evaluated for all values of a type, not in a state
    names.clock = [](ir::ClockId) { return b::number(0); };
    names.entry_clock = [](ir::NodeId) { return b::number(0); };
    const std::int64_t scale = project_.instantiation.scale;
    const ExprPtr value = translate_expression(project_, names, bound);
    const bool real = bound.type.is_valid() && project_.system.type(bound.type).kind == ir::TypeKind::real;
    if (!real || scale == 1) return value;
    if (value->kind == Op::integer) return b::number(value->number / scale + 1);
    return plus_one(b::binary(Op::divide, value, b::number(scale)));
}

}  // namespace robochart::csp_emit
