// SPDX-License-Identifier: Apache-2.0
// See resolve_facts.hpp.
#include "claims/checks/resolve_facts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/diagnostics/containers.hpp"
#include "base/diagnostics/spelling.hpp"
#include "claims/checks/rules.hpp"

namespace robochart::claims {
namespace {

constexpr std::string_view separator = "::";

/// Returns the state that the condition `in STATE` names. Fixes replace only this name.
Name state_name(const Expr& in_state) {
    Span span = in_state.span;
    span.begin = std::max(span.begin, span.end - static_cast<std::uint32_t>(in_state.text.size()));
    return {in_state.text, span};
}

/// Returns the name without its last part: "patrol" for "patrol::retries"; "" if there is only one part.
std::string prefix_of(const std::string& name) {
    const std::size_t end = name.rfind(separator);
    return end == std::string::npos ? "" : name.substr(0, end);
}

std::string last_of(const std::string& name) {
    const std::size_t end = name.rfind(separator);
    return end == std::string::npos ? name : name.substr(end + separator.size());
}

}  // namespace

bool FactResolver::names_machine(std::size_t part, const std::string& prefix) const {
    if (prefix.empty()) return true;
    const ir::Machine& of = machine(part);
    const std::string& path = parts()[part].path;
    return path == prefix || path.ends_with("::" + prefix) || of.name == prefix || of.path == prefix ||
           of.package + "::" + of.path == prefix;
}

// ---------------------------------------------------------------- states

bool FactResolver::has_state(const std::string& name) const {
    for (std::size_t part = 0; part < parts().size(); ++part)
        for (const ir::Node& node : machine(part).nodes)
            if (node.kind == ir::NodeKind::state && (node.path == name || node.name == name)) return true;
    return false;
}

std::size_t FactResolver::fact_of_state(const Name& name) {
    std::vector<std::size_t> found;
    Fact fact;
    for (std::size_t part = 0; part < parts().size(); ++part) {
        const ir::Machine& of = machine(part);
        for (std::uint32_t i = 0; i < of.nodes.size(); ++i) {
            const ir::Node& node = of.nodes[i];
            if (node.kind != ir::NodeKind::state && node.kind != ir::NodeKind::final) continue;
            const bool whole = name.text == node.path;
            const bool qualified =
                name.text.ends_with("::" + node.path) &&
                names_machine(part, name.text.substr(0, name.text.size() - node.path.size() - separator.size()));
            if (!whole && !qualified) continue;
            found.push_back(part);
            fact = {parts()[part].path, parts()[part].machine, ir::NodeId{i}, {}, "in " + name.text};
        }
    }
    if (found.empty()) report_unknown(name, true);
    if (found.size() > 1) ask_whose(name, found);
    return add(std::move(fact));
}

// ---------------------------------------------------------------- variables

std::vector<FactResolver::Found> FactResolver::find_variables(const std::string& name) const {
    std::vector<Found> result;
    const std::string prefix = prefix_of(name), last = last_of(name);
    for (std::size_t part = 0; part < parts().size(); ++part) {
        if (!names_machine(part, prefix)) continue;
        const ir::Machine& of = machine(part);
        for (std::size_t i = 0; i < of.variables.size(); ++i)
            if (of.variables[i].name == last) result.push_back({part, Operand::variable, i, of.variables[i].type});
        for (std::size_t i = 0; i < of.constants.size(); ++i)
            if (of.constants[i].name == last) result.push_back({part, Operand::of_model, i, of.constants[i].type});
    }
    return result;
}

FactResolver::Found FactResolver::find_variable(const Expr& name) const {
    const std::vector<Found> found = find_variables(name.text);
    if (found.empty()) report_unknown({name.text, name.span}, false);
    if (found.size() == 1) return found.front();
    std::vector<std::size_t> machines;
    for (const Found& one : found) machines.push_back(one.part);
    ask_whose({name.text, name.span}, machines);
}

void FactResolver::collect_machines(const Expr& expr, std::vector<std::size_t>& machines, bool& state) const {
    if (expr.op == Op::in_state) state = true;
    if (expr.op == Op::last)
        conditions_.refuse(expr.span, "conditions on states and variables do not read last values of events");
    if (expr.op == Op::name && !(find_variables(expr.text).empty() && conditions_.find_literal(expr.text)))
        machines.push_back(find_variable(expr).part);
    for (const ExprPtr& part : expr.parts) collect_machines(*part, machines, state);
}

Condition FactResolver::fact_of_variables(const Expr& expr, const std::vector<std::size_t>& machines) {
    if (machines.empty()) conditions_.refuse(expr.span, "the condition reads no state and no variable");
    if (machines.size() > 1) conditions_.refuse(expr.span, "one comparison reads the variables of one machine");
    const MachinePart& of = parts()[machines.front()];
    const auto leaf = [&](const Expr& name) {
        if (find_variables(name.text).empty())
            if (auto literal = conditions_.find_literal(name.text)) return std::move(*literal);
        const Found found = find_variable(name);
        return conditions_.typed_operand(operand_of(found.operand, found.index), found.type, name.span);
    };
    Fact fact{of.path, of.machine, std::nullopt, conditions_.resolve_truth(expr, leaf), written(expr.span)};
    return operand_of(Operand::fact, add(std::move(fact)));
}

Condition FactResolver::resolve(const Expr& expr) {
    if (expr.op == Op::in_state) return operand_of(Operand::fact, fact_of_state(state_name(expr)));
    std::vector<std::size_t> machines;
    bool state = false;
    collect_machines(expr, machines, state);
    diagnostics::sort_unique(machines);
    const bool joins = expr.op == Op::negation || expr.op == Op::conjunction || expr.op == Op::disjunction;
    if (!joins || (!state && machines.size() == 1)) {
        // If a user writes the name of a state as a condition, the intended condition is `in STATE`.
        if (expr.op == Op::name && find_variables(expr.text).empty() && has_state(expr.text))
            conditions_.refuse(expr.span, fmt::format("`{}` is a state: write `in {}`", expr.text, expr.text));
        return fact_of_variables(expr, machines);
    }
    std::vector<Condition> parts;
    for (const ExprPtr& part : expr.parts) parts.push_back(resolve(*part));
    return operation(expr.op, std::move(parts));
}

std::size_t FactResolver::add(Fact fact) {
    const auto known = std::ranges::find(claim_.facts, fact);
    if (known != claim_.facts.end()) return static_cast<std::size_t>(known - claim_.facts.begin());
    claim_.facts.push_back(std::move(fact));
    return claim_.facts.size() - 1;
}

// ---------------------------------------------------------------- findings

void FactResolver::report_unknown(const Name& name, bool state) const {
    if (!state && has_state(name.text))
        conditions_.refuse(name.span, fmt::format("`{}` is a state: write `in {}`", name.text, name.text));
    std::vector<std::string> names;
    std::string meant;
    for (std::size_t part = 0; part < parts().size(); ++part) {
        const ir::Machine& of = machine(part);
        if (state)
            for (const ir::Node& node : of.nodes) {
                if (node.kind != ir::NodeKind::state) continue;
                names.push_back(node.path);
                if (meant.empty() && node.name == last_of(name.text)) meant = node.path;
            }
        else
            for (const ir::Variable& variable : of.variables) names.push_back(variable.name);
    }
    if (meant.empty()) meant = diagnostics::nearest_spelling(name.text, names);
    auto& finding = diagnostics_.report(rules::unknown_fact, name.span,
                                        {state ? "state" : "variable or constant", name.text, claim_.component.path,
                                         meant.empty() ? "" : fmt::format("; did you mean `{}`?", meant)});
    if (!meant.empty()) finding.fixes.push_back({name.span, meant, fmt::format("write `{}`", meant)});
    throw ClaimError{};
}

void FactResolver::ask_whose(const Name& name, const std::vector<std::size_t>& found) const {
    std::vector<std::string> paths;
    for (const std::size_t part : found) paths.push_back(parts()[part].path);
    auto& finding =
        diagnostics_.report(rules::open_machine, name.span, {name.text, fmt::format("{}", fmt::join(paths, " and "))});
    for (const std::string& path : paths) {
        const std::string text = last_of(path) + "::" + name.text;
        finding.fixes.push_back({name.span, text, fmt::format("of {}", path)});
    }
    throw ClaimError{};
}

}  // namespace robochart::claims
