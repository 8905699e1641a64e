// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/plan/list_growth.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "cpp_emit/plan/types.hpp"
#include "cpp_emit/plan/walk.hpp"

namespace robochart::cpp_emit {

using ir::ExprKind;

namespace {

using Variables = std::set<ir::VariableId>;

/// Returns whether the result of the operator may contain the items of several operands.
bool joins_lists(const ir::Expr& expr) {
    if (expr.kind == ExprKind::concat) return true;
    if (expr.kind != ExprKind::toolkit) return false;
    for (const char* const function : {"sequence_toolkit_concat", "sequence_toolkit_dconcat", "set_toolkit_union",
                                       "set_toolkit_Union", "set_toolkit_symetric_diff", "relation_toolkit_override"})
        if (expr.text == function) return true;
    return false;
}

void add_variables(const ir::Expr& expr, Variables& result) {
    ir::visit_operands(expr, [&](const ir::Expr& part) {
        if (part.kind == ExprKind::variable) result.insert(part.variable);
    });
}

/// Returns the variables in the operands of those operators that join lists.
Variables joined_variables(const ir::Expr& value) {
    Variables result;
    ir::visit_operands(value, [&](const ir::Expr& part) {
        if (joins_lists(part)) add_variables(part, result);
    });
    return result;
}

bool returns_lists(const ir::System& system, const ir::Expr& value) {
    bool found = false;
    ir::visit_operands(value, [&](const ir::Expr& part) {
        found = found || (part.kind == ExprKind::call && part.type.is_valid() && has_lists(system, part.type));
    });
    return found;
}

void visit_assignments(const ir::Machine& machine, const std::function<void(const ir::Stmt&)>& visitor) {
    ir::visit_statements(machine, [&](const ir::Stmt& stmt) {
        if (stmt.kind == ir::StmtKind::assign && stmt.value) visitor(stmt);
    });
}

/// Computes the variables from which the value of a variable may come.
class Flows {
public:
    explicit Flows(const ir::Machine& machine) {
        for (std::uint32_t i = 0; i < machine.variables.size(); ++i) sources_[ir::VariableId{i}] = {ir::VariableId{i}};
        for (bool changed = true; changed;) {
            changed = false;
            visit_assignments(machine, [&](const ir::Stmt& stmt) {
                Variables read;
                add_variables(*stmt.value, read);
                Variables& sources = sources_[stmt.variable];
                const std::size_t before = sources.size();
                for (const ir::VariableId variable : read)
                    sources.insert(sources_[variable].begin(), sources_[variable].end());
                changed = changed || sources.size() != before;
            });
        }
    }
    [[nodiscard]] bool may_come_from(ir::VariableId variable, ir::VariableId source) const {
        return sources_.at(variable).contains(source);
    }

private:
    std::map<ir::VariableId, Variables> sources_;
};

}  // namespace

std::vector<ListGrowth> growing_lists(const ir::System& system, const ir::Machine& machine) {
    std::vector<ListGrowth> result;
    const Flows flows(machine);
    visit_assignments(machine, [&](const ir::Stmt& stmt) {
        if (!has_lists(system, machine.variables[stmt.variable.index].type)) return;
        const auto from_itself = [&](ir::VariableId part) { return flows.may_come_from(part, stmt.variable); };
        if (std::ranges::any_of(joined_variables(*stmt.value), from_itself))
            result.push_back({stmt.variable, stmt.value->span, "this assignment may make the list longer each time"});
        else if (returns_lists(system, *stmt.value))
            result.push_back(
                {stmt.variable, stmt.value->span, "the model does not bound what a function returns here"});
    });
    return result;
}

}  // namespace robochart::cpp_emit
