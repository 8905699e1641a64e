// SPDX-License-Identifier: Apache-2.0
// See block_constants.hpp.
#include "csp_emit/block_constants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "checker/cspm/syntax/reader.hpp"
#include "csp_emit/base/rules.hpp"
#include "semantics/ir/arithmetic.hpp"
#include "semantics/ir/own_constants.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::csp_emit {
namespace {

using DefinitionsByName = std::map<std::string, std::vector<BlockDefinition>>;

/// The value in a constant's definition, if it is known without evaluating a script.
struct Value {
    std::string text;
    bool known = false;  ///< it is a number, a truth value, or a name that no block defines
};

class Values {
public:
    explicit Values(const DefinitionsByName& definitions) : definitions_(definitions) {}

    /// Returns the expression in `name = expression`, or null if no block has such a definition.
    [[nodiscard]] cspm::ExprPtr body_of(const std::string& name) const {
        const auto found = definitions_.find(name);
        if (found == definitions_.end() || found->second.front().decl->kind != cspm::DeclKind::value) return nullptr;
        return found->second.front().decl->body;
    }
    [[nodiscard]] Value value_of(const std::string& name) const {
        const cspm::ExprPtr expr = resolve_names(body_of(name));
        if (const auto value = evaluate_number(expr)) return {std::to_string(*value), true};
        const bool literal = expr->kind == cspm::ExprKind::boolean || expr->kind == cspm::ExprKind::name;
        return {cspm::print(expr), literal};
    }

private:
    /// Removes parentheses and replaces names by their definitions in blocks.
    [[nodiscard]] cspm::ExprPtr resolve_names(cspm::ExprPtr expr) const {
        std::set<std::string> followed;
        for (;;) {
            if (expr->kind == cspm::ExprKind::parenthesised) {
                expr = expr->args[0];
            } else if (expr->kind == cspm::ExprKind::name && followed.insert(expr->text).second &&
                       body_of(expr->text) != nullptr) {
                expr = body_of(expr->text);
            } else {
                return expr;
            }
        }
    }
    [[nodiscard]] std::optional<std::int64_t> evaluate_number(const cspm::ExprPtr& unresolved) const {
        const cspm::ExprPtr expr = resolve_names(unresolved);
        if (expr->kind == cspm::ExprKind::integer) return expr->number;
        if (expr->kind == cspm::ExprKind::negate) {
            const auto value = evaluate_number(expr->args[0]);
            return value ? ir::checked_subtract(0, *value) : std::nullopt;
        }
        if (expr->kind != cspm::ExprKind::plus && expr->kind != cspm::ExprKind::minus &&
            expr->kind != cspm::ExprKind::times)
            return std::nullopt;
        const auto left = evaluate_number(expr->args[0]), right = evaluate_number(expr->args[1]);
        if (!left || !right) return std::nullopt;
        if (expr->kind == cspm::ExprKind::plus) return ir::checked_add(*left, *right);
        if (expr->kind == cspm::ExprKind::minus) return ir::checked_subtract(*left, *right);
        return ir::checked_multiply(*left, *right);
    }

    const DefinitionsByName& definitions_;
};

/// True if the script of the other semantics has already reported this finding.
bool is_known(const Project& project, const diagnostics::Rule& rule, diagnostics::Span place) {
    const auto known = project.diagnostics.sorted_findings();
    return std::ranges::any_of(
        known, [&](const diagnostics::Diagnostic& finding) { return finding.rule == &rule && finding.span == place; });
}

}  // namespace

std::set<std::string> check_names_of_constants(const Project& project, const DefinitionsByName& definitions) {
    std::set<std::string> result;
    const Values values(definitions);
    // The constant of the first part, by the name of the machine's own constant.
    std::map<std::string, const ir::NamedConstant*> first_part;
    const std::vector<ir::NamedConstant> constants = ir::named_constants(project.system);
    const auto own = ir::own_constants(project.system);
    for (const ir::NamedConstant& constant : constants) {
        const auto own_constant = own.find(constant.name);
        if (own_constant == own.end() || values.body_of(constant.name) == nullptr) continue;
        const std::string& machines = own_constant->second;
        const Value value = values.value_of(constant.name);
        const diagnostics::Span place = definitions.at(constant.name).front().place;
        const auto report = [&](const diagnostics::Rule& rule, const std::string& other, const Value& others) {
            if (is_known(project, rule, place)) return;
            project.diagnostics.report(rule, place, {constant.name, value.text, other, others.text, machines})
                .notes.push_back(
                    {definitions.at(other).front().place, fmt::format("here {} = {}", other, others.text)});
        };
        if (values.body_of(machines) != nullptr) {
            const Value machines_value = values.value_of(machines);
            if (machines_value.text == value.text) continue;
            report(rules::name_of_machine_decides, machines, machines_value);
            result.insert(constant.name);
            continue;
        }
        const auto [first, added] = first_part.emplace(machines, &constant);
        if (added) continue;
        const Value others = values.value_of(first->second->name);
        const bool differ = value.known && others.known && value.text != others.text;
        if (differ) report(rules::two_values_of_constant, first->second->name, others);
    }
    return result;
}

}  // namespace robochart::csp_emit
