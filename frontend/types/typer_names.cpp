// SPDX-License-Identifier: Apache-2.0
// Resolves names in expressions: bound variables, members of the component, literals, functions.
#include <fmt/format.h>

#include <deque>

#include "base/diagnostics/spelling.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/types/typer.hpp"

namespace robochart::frontend {

namespace {

TypePtr function_value(const Function& function) {
    std::vector<TypePtr> parameters;
    for (const VariablePtr& parameter : function.parameters) {
        if (!parameter->type) return nullptr;
        parameters.push_back(parameter->type);
    }
    if (!function.result) return nullptr;
    return make_type(TypeForm::function, {make_type(TypeForm::product, std::move(parameters)), function.result});
}

std::string describe_component(const Declaration* component) {
    return component != nullptr ? fmt::format("{} `{}`", to_text(component->kind), component->name) : "this file";
}

/// Returns the state or final state with this name below a container, searched breadth-first from the outside.
const State* breadth_first(const NodeContainer& top, const QualifiedName& name, DeclKind kind) {
    std::deque<const NodeContainer*> level{&top};
    while (!level.empty()) {
        const NodeContainer* container = level.front();
        level.pop_front();
        for (const auto& node : container->nodes) {
            if (node->name != name.parts.front()) continue;
            const State* state = node.get();
            for (std::size_t i = 1; i < name.parts.size() && state != nullptr; ++i) {
                const State* inner = nullptr;
                for (const auto& child : state->nodes)
                    if (child->name == name.parts[i]) inner = child.get();
                state = inner;
            }
            if (state != nullptr && state->kind == kind) return state;
        }
        for (const auto& node : container->nodes) level.push_back(node.get());
    }
    return nullptr;
}

}  // namespace

const Declaration* Typer::value_named(const QualifiedName& name, Surroundings& around) {
    if (name.parts.size() == 1) {
        for (auto bound = around.bound.rbegin(); bound != around.bound.rend(); ++bound)
            if ((*bound)->name == name.parts.front()) return *bound;
        if (around.scope != nullptr) {
            const auto found = around.scope->variables.find(name.parts.front());
            if (found != around.scope->variables.end()) return found->second;
        }
    }
    return finder_.names().find(around.place, name, {DeclKind::enum_literal, DeclKind::function});
}

void Typer::unknown_value(const QualifiedName& name, Surroundings& around) {
    const bool is_clock =
        around.scope != nullptr && name.parts.size() == 1 && around.scope->clocks.contains(name.parts.front());
    const Missing missing = is_clock ? Missing() : this->find_missing(name.parts.back(), DeclKind::variable, around);
    if (missing.reported) return;
    std::vector<std::string> candidates = finder_.candidate_names({DeclKind::enum_literal, DeclKind::function});
    if (around.scope != nullptr)
        for (std::string& key : finder_.keys_of(around.scope->variables)) candidates.push_back(std::move(key));
    for (const Variable* bound : around.bound) candidates.push_back(bound->name);
    const Declaration* component = component_around(around.place.inside);
    auto& finding = finder_.report_unknown(name, "variable, constant, literal or function",
                                           "in " + describe_component(component), candidates);
    if (is_clock) {
        const std::string own = fmt::format("since({})", name.parts.front());
        finding.notes.push_back({around.scope->clocks.at(name.parts.front())->name_span,
                                 fmt::format("it is a clock: `{}` is the time since its last reset", own)});
        finding.fixes = {{name.span, own, "write"}};
        return;
    }
    if (missing.interface != nullptr) return note_missing(missing, "requires", name.parts.back(), finding);
    const Declaration* outer = component != nullptr ? component->parent : nullptr;
    if (const auto* around_it = dynamic_cast<const Context*>(outer)) {
        const Scope scope = scope_of(*around_it);
        const auto hidden = scope.variables.find(name.parts.front());
        if (hidden != scope.variables.end())
            finding.notes.push_back({hidden->second->name_span,
                                     fmt::format("{} has one; `{}` sees it by requiring an interface that declares it",
                                                 describe_component(outer), component->name)});
    }
}

/// Returns the type of a function that is used as a value. The name of a function without parameters denotes its
/// result, because no value has the type of a function without parameters.
TypePtr Typer::bare_function(const Expr& expr, const Function& function) {
    if (!function.parameters.empty()) return function_value(function);
    auto& finding = finder_.out().report(rules::function_bare, expr.span, {function.name});
    finding.fixes.push_back({{expr.span.source, expr.span.end, expr.span.end}, "()", "insert"});
    finding.notes.push_back({function.name_span, "the function is declared here"});
    return function.result;
}

TypePtr Typer::name(Expr& expr, Surroundings& around) {
    expr.target = value_named(expr.name, around);
    if (expr.target == nullptr) {
        unknown_value(expr.name, around);
        return nullptr;
    }
    if (const auto* variable = dynamic_cast<const Variable*>(expr.target)) return variable->type;
    if (const auto* function = dynamic_cast<const Function*>(expr.target)) return bare_function(expr, *function);
    const auto& literal = static_cast<const EnumLiteral&>(*expr.target);
    if (!literal.arguments.empty())
        finder_.out().report(
            rules::literal_count, expr.span,
            {literal.name, std::to_string(literal.arguments.size()), plural(literal.arguments.size()), "none"});
    return declared_type(static_cast<const TypeDeclaration&>(*literal.parent));
}

const Clock* Typer::find_clock(const QualifiedName& name, Surroundings& around, const diagnostics::Rule& rule) {
    if (around.scope != nullptr) {
        const auto found = around.scope->clocks.find(name.parts.front());
        if (found != around.scope->clocks.end()) return found->second;
    }
    if (finder_.names().is_lost(name)) return nullptr;
    const Missing missing = this->find_missing(name.parts.back(), DeclKind::clock, around);
    if (missing.reported) return nullptr;
    const Declaration* component = component_around(around.place.inside);
    const std::string kind(component != nullptr ? to_text(component->kind) : "package");
    auto& finding =
        finder_.out().report(rule, name.span, {name.text(), kind, component != nullptr ? component->name : ""});
    if (around.scope != nullptr) {
        const std::vector<std::string> clocks = finder_.keys_of(around.scope->clocks);
        const std::string meant = diagnostics::nearest_spelling(name.parts.front(), clocks);
        if (!meant.empty())
            finding.fixes.push_back(
                {name.span, meant,
                 diagnostics::suggestion_verb(diagnostics::is_certain(name.parts.front(), meant, clocks))});
    }
    if (missing.interface != nullptr) note_missing(missing, "uses", name.parts.back(), finding);
    if (&rule == &rules::te2 && around.machine != nullptr)
        if (const Declaration* state = breadth_first(*around.machine, name, DeclKind::state))
            finding.notes.push_back(
                {state->name_span,
                 fmt::format("it is a state: `sinceEntry({})` is the time since it was entered", name.text())});
    return nullptr;
}

TypePtr Typer::type_since(Expr& expr, Surroundings& around) {
    expr.target = find_clock(expr.name, around, rules::te2);
    return make_type(TypeForm::integer);
}

TypePtr Typer::since_entry(Expr& expr, Surroundings& around) {
    const auto find = [&](DeclKind kind) {
        return around.machine != nullptr ? breadth_first(*around.machine, expr.name, kind) : nullptr;
    };
    expr.target = find(DeclKind::state);
    if (expr.target == nullptr && !finder_.names().is_lost(expr.name)) {
        const State* final_state = find(DeclKind::final);
        const Declaration* component = component_around(around.place.inside);
        const std::string kind(component != nullptr ? to_text(component->kind) : "package");
        const std::string why = final_state != nullptr ? ", this is a final state" : "";
        finder_.out().report(rules::te3, expr.span,
                             {expr.name.text(), kind, component != nullptr ? component->name : "", why});
    }
    return make_type(TypeForm::integer);
}

}  // namespace robochart::frontend
