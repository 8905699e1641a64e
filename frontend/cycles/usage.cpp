// SPDX-License-Identifier: Apache-2.0
#include "frontend/cycles/usage.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/names/scopes.hpp"
#include "frontend/syntax/expression_visitor.hpp"

namespace robochart::frontend {

const Machine* Callers::definition(std::string_view operation) const {
    const auto found =
        std::ranges::find_if(definitions_, [&](const Machine* definition) { return definition->name == operation; });
    return found == definitions_.end() ? nullptr : *found;
}

namespace {

bool contains_variable(const std::vector<const Variable*>& list, const Variable& variable) {
    return std::ranges::find(list, &variable) != list.end();
}

}  // namespace

const Variable* Callers::variable_of_root(std::string_view name) const {
    const Scope scope = scope_of(*root_);
    const auto found = scope.variables.find(name);
    return found == scope.variables.end() ? nullptr : found->second;
}

VariableRole Callers::role(const Machine& where, const Variable& variable) const {
    if (variable.kind == DeclKind::parameter || !contains_variable(required_variables(where), variable))
        return VariableRole::own;
    if (&where == root_) return variable.kind == DeclKind::constant ? VariableRole::constant : VariableRole::shared;
    const Variable* const outer = variable_of_root(variable.name);
    if (outer == nullptr)
        throw NoCyclicForm(variable.name_span,
                           fmt::format("variable `{}` of operation `{}`", variable.name, where.name),
                           fmt::format("only an operation that calls it has the variable, and not `{}`", root_->name));
    const VariableRole role_of_root = role(*root_, *outer);
    return role_of_root == VariableRole::own ? VariableRole::callers : role_of_root;
}

bool is_input(const Communication& communication, bool trigger) {
    return trigger || communication.kind == CommKind::input;
}

const Variable* assigned_variable(const Stmt& assignment) {
    const Expr* target = assignment.target.get();
    while (target != nullptr && target->kind != ExprKind::name)
        target = target->args.empty() ? nullptr : target->args[0].get();
    return target == nullptr ? nullptr : dynamic_cast<const Variable*>(target->target);
}

namespace {

class UsageCollector {
public:
    UsageCollector(const Machine& machine, const Callers& callers, Usage& usage)
        : machine_(machine), callers_(callers), usage_(usage) {}

    void collect() {
        for_transitions(machine_, [&](const Transition& transition) { add_transition(transition); });
        for_actions(machine_, [&](const Stmt& action) {
            walk_tree(action, [&](const Stmt& statement) { add_statement(statement); });
        });
        for (const ExprPtr& condition : machine_.preconditions) add_expression(*condition);
        for (const ExprPtr& condition : machine_.postconditions) add_expression(*condition);
    }

private:
    void add_transition(const Transition& transition) {
        if (transition.trigger) add_communication(*transition.trigger, true);
        for (const ExprPtr* part : {&transition.condition, &transition.deadline, &transition.probability})
            if (*part) add_expression(**part);
    }

    void add_communication(const Communication& communication, bool trigger) {
        const auto* event = dynamic_cast<const Event*>(communication.event_target);
        if (event == nullptr) return;
        (is_input(communication, trigger) ? usage_.inputs : usage_.outputs).emplace(event->name, event);
        if (const auto* stored = dynamic_cast<const Variable*>(communication.variable_target)) note_write(*stored);
        if (communication.value) add_expression(*communication.value);
    }

    void add_statement(const Stmt& statement) {
        for_expressions(statement, [&](const Expr& expr) {
            if (&expr != statement.target.get() || expr.kind != ExprKind::name) add_expression(expr);
        });
        if (statement.kind == StmtKind::communication) add_communication(*statement.communication, false);
        if (statement.kind == StmtKind::call) add_call(statement);
        if (statement.kind == StmtKind::assignment)
            if (const Variable* assigned = assigned_variable(statement)) note_write(*assigned);
    }

    void add_call(const Stmt& statement) {
        const auto* signature = dynamic_cast<const OperationSignature*>(statement.declaration);
        if (signature == nullptr) return;
        const Machine* const definition = callers_.definition(signature->name);
        if (definition == nullptr) {
            usage_.platform.emplace(signature->name, signature);
        } else if (usage_.software.emplace(signature->name, signature).second) {
            UsageCollector(*definition, callers_, usage_).collect();
        }
    }

    void add_expression(const Expr& expr) {
        walk_tree(expr, [&](const Expr& part) {
            const auto* variable = dynamic_cast<const Variable*>(part.target);
            if (part.kind != ExprKind::name || variable == nullptr || variable->kind == DeclKind::bound_variable)
                return;
            const VariableRole role = callers_.role(machine_, *variable);
            if (role == VariableRole::shared) usage_.read.emplace(variable->name, variable);
            if (role == VariableRole::constant) usage_.constants.emplace(variable->name, variable);
        });
    }

    void note_write(const Variable& variable) {
        if (callers_.role(machine_, variable) == VariableRole::shared) usage_.written.emplace(variable.name, &variable);
    }

    const Machine& machine_;
    const Callers& callers_;
    Usage& usage_;
};

}  // namespace

Usage usage_of(const Machine& machine, const Callers& callers) {
    Usage usage;
    UsageCollector(machine, callers, usage).collect();
    return usage;
}

}  // namespace robochart::frontend
