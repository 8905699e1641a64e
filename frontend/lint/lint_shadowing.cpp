// SPDX-License-Identifier: Apache-2.0
// Reports names that hide others. The order of lookup (language reference 1.3) is: bound variables, parameters, own
// declarations, interfaces in order, enumeration literals.
#include <fmt/format.h>

#include <map>

#include "frontend/lint/lints.hpp"
#include "frontend/names/scopes.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/expression_visitor.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::frontend {

namespace {

class Shadowing {
public:
    Shadowing(const File& file, const Context& context, const Names& names, Diagnostics& out)
        : file_(file), context_(context), names_(names), out_(out) {}

    void run() {
        if (const auto* machine = dynamic_cast<const Machine*>(&context_)) {
            for (const auto& parameter : machine->parameters) enter_variable(*parameter);
            enter_members();
            check_binders(*machine);
        } else {
            enter_members();
        }
    }

private:
    void enter_members() {
        for (const auto& variable : context_.variables) enter_variable(*variable);
        for (const InterfaceClause& clause : context_.interfaces) {
            const Context* interface = interface_of(clause);
            if (interface == nullptr || clause.use == InterfaceUse::provides) continue;
            for (const auto& variable : interface->variables) enter_foreign(*variable, *interface, clause);
        }
    }

    /// Records a declaration of the component itself.
    void enter_variable(const Variable& variable) {
        visible_.emplace(variable.name, &variable);
        QualifiedName name;
        name.parts = {variable.name};
        const Declaration* literal = names_.find({&file_, &context_}, name, {DeclKind::enum_literal});
        if (literal != nullptr) report(variable, *literal);
    }

    /// Records a declaration of an interface. It is hidden if the component or an earlier interface declares the same
    /// name.
    void enter_foreign(const Variable& variable, const Context& interface, const InterfaceClause& clause) {
        const auto [first, fresh] = visible_.emplace(variable.name, &variable);
        if (fresh || first->second == &variable) return;
        auto& finding =
            out_.report(rules::w_hidden_member, clause.name.span,
                        {variable.name, interface.name, std::string(to_text(first->second->kind)), context_.name});
        finding.notes.push_back({first->second->name_span, fmt::format("`{}` means this declaration", variable.name)});
        finding.notes.push_back({variable.name_span, "this declaration is hidden"});
    }

    void check_binders(const Machine& machine) {
        const auto visit = [&](const Expr& expr) { this->check_expression(expr); };
        for_actions(machine, [&](const Stmt& action) {
            walk_tree(action, [&](const Stmt& statement) { for_expressions(statement, visit); });
        });
        walk_tree(machine, [&](const NodeContainer& container) {
            for (const auto& transition : container.transitions)
                if (transition->condition) visit(*transition->condition);
        });
        for (const ExprPtr& condition : machine.preconditions) visit(*condition);
        for (const ExprPtr& condition : machine.postconditions) visit(*condition);
    }

    void check_expression(const Expr& expr) {
        const std::size_t before = bound_.size();
        if (expr.kind != ExprKind::record)
            for (const Binding& binding : expr.bindings)
                if (binding.variable) bind_variable(*binding.variable);
        for_children(expr, [&](const Expr& part) { this->check_expression(part); });
        bound_.resize(before);
    }

    void bind_variable(const Variable& variable) {
        const Declaration* hidden = nullptr;
        for (const Variable* outer : bound_)
            if (outer->name == variable.name) hidden = outer;
        const auto found = visible_.find(variable.name);
        if (hidden == nullptr && found != visible_.end()) hidden = found->second;
        if (hidden != nullptr) report(variable, *hidden);
        bound_.push_back(&variable);
    }

    void report(const Variable& variable, const Declaration& hidden) {
        out_.report(rules::w_shadows, variable.name_span,
                    {std::string(to_text(variable.kind)), variable.name, std::string(to_text(hidden.kind))})
            .notes.push_back({hidden.name_span, "the hidden element is declared here"});
    }

    const File& file_;
    const Context& context_;
    const Names& names_;
    Diagnostics& out_;
    std::map<std::string_view, const Variable*> visible_;
    std::vector<const Variable*> bound_;
};

}  // namespace

void lint_shadowing(const File& file, const Context& context, const Names& names, Diagnostics& out) {
    Shadowing(file, context, names, out).run();
}

}  // namespace robochart::frontend
