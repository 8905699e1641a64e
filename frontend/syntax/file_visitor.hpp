// SPDX-License-Identifier: Apache-2.0
// One traversal of everything in a file that has a name or that resolution fills. The visitor has an overload of
// `visit` for every kind of node; it is called before the parts of the node. The recursion is bounded, because the
// parser limits nesting.
#pragma once

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

template <class Visitor>
class Traversal {
public:
    explicit Traversal(Visitor& visitor) : visitor_(visitor) {}

    /// `File` is `File` or `const File`; values inside vectors are visited with the same constness.
    template <class AnyFile>
    void file(AnyFile& file) {
        for (auto& import : file.imports) visitor_.visit(import);
        for (auto& declaration : file.declarations) this->declaration(*declaration);
        for (auto& assertion : file.assertions) {
            visitor_.visit(assertion);
            for (auto& parameter : assertion.parameters) {
                visitor_.visit(parameter);
                expression(parameter.value);
            }
        }
        for (auto& block : file.csp_blocks) visitor_.visit(block);
        for (auto& definition : file.probabilistic_definitions) this->definition(definition);
        for (auto& assertion : file.probabilistic_assertions) {
            for (const ExprPtr* part :
                 {&assertion.property, &assertion.path.steps, &assertion.path.repeats, &assertion.path.limit})
                expression(*part);
            for (auto& clause : assertion.clauses) definition(clause.definition);
        }
    }

private:
    template <class AnyDefinition>
    void definition(AnyDefinition& definition) {
        if (definition.constant) variable(*definition.constant);
        expression(definition.value);
        for (auto& each : definition.constants) {
            expression(each.constant);
            expression(each.value);
        }
        for (auto& item : definition.rewards)
            for (const ExprPtr* part : {&item.event, &item.guard, &item.value}) expression(*part);
        for (auto& function : definition.functions) {
            for (auto& parameter : function.parameters) variable(*parameter);
            expression(function.result);
            updates(function.updates);
        }
        for (auto& module : definition.modules) {
            for (auto& each : module.variables) {
                variable(*each.variable);
                expression(each.low);
                expression(each.high);
            }
            for (auto& command : module.commands) {
                expression(command.event);
                expression(command.guard);
                updates(command.updates);
            }
        }
    }

    template <class Updates>
    void updates(Updates& list) {
        for (auto& update : list)
            for (const ExprPtr* part : {&update.probability, &update.variable, &update.value}) expression(*part);
    }

    void declaration(Declaration& any) {
        if (auto* type = dynamic_cast<TypeDeclaration*>(&any)) return type_declaration(*type);
        if (auto* function = dynamic_cast<Function*>(&any)) return this->function(*function);
        if (auto* machine = dynamic_cast<Machine*>(&any)) return this->machine(*machine);
        if (auto* component = dynamic_cast<Component*>(&any)) return this->component(*component);
        if (auto* plain = dynamic_cast<Context*>(&any)) {
            visitor_.visit(*plain);
            context(*plain);
        }
    }

    void type_declaration(TypeDeclaration& declaration) {
        visitor_.visit(declaration);
        variables(declaration.fields);
        for (auto& literal : declaration.literals) {
            visitor_.visit(*literal);
            for (auto& argument : literal->arguments) type(argument);
        }
    }

    void function(Function& function) {
        visitor_.visit(function);
        variables(function.parameters);
        type(function.result_expr);
        expressions(function.preconditions);
        expressions(function.postconditions);
    }

    void context(Context& context) {
        for (auto& clause : context.interfaces) visitor_.visit(clause);
        variables(context.variables);
        for (auto& event : context.events) {
            visitor_.visit(*event);
            type(event->type_expr);
        }
        for (auto& clock : context.clocks) visitor_.visit(*clock);
        for (auto& signature : context.signatures) {
            visitor_.visit(*signature);
            variables(signature->parameters);
        }
    }

    void machine(Machine& machine) {
        visitor_.visit(machine);
        variables(machine.parameters);
        context(machine);
        expressions(machine.preconditions);
        expressions(machine.postconditions);
        nodes(machine);
    }

    void component(Component& component) {
        visitor_.visit(component);
        context(component);
        for (auto& part : component.platforms) declaration(*part);
        for (auto& part : component.controllers) declaration(*part);
        for (auto& part : component.machines) declaration(*part);
        for (auto& part : component.operations) declaration(*part);
        for (auto& reference : component.references) visitor_.visit(*reference);
        for (auto& connection : component.connections) visitor_.visit(*connection);
    }

    void nodes(NodeContainer& container) {
        for (auto& state : container.nodes) {
            visitor_.visit(*state);
            for (auto& action : state->actions) statement(action.statement);
            nodes(*state);
        }
        for (auto& transition : container.transitions) {
            visitor_.visit(*transition);
            if (transition->trigger) communication(*transition->trigger);
            expression(transition->probability);
            expression(transition->deadline);
            expression(transition->condition);
            statement(transition->action);
        }
    }

    void variables(std::vector<VariablePtr>& list) {
        for (auto& variable : list) this->variable(*variable);
    }
    void variable(Variable& variable) {
        visitor_.visit(variable);
        type(variable.type_expr);
        expression(variable.initial);
    }

    void type(TypeExprPtr& written) {
        if (!written) return;
        visitor_.visit(*written);
        for (auto& arg : written->args) type(arg);
        expressions(written->sizes);
    }

    void expressions(std::vector<ExprPtr>& list) {
        for (auto& each : list) expression(each);
    }
    void expression(const ExprPtr& expr) {
        if (!expr) return;
        visitor_.visit(*expr);
        expression(expr->callee);
        type(expr->type_expr);
        for (Binding& binding : expr->bindings) {
            // The names in a record literal refer to fields and declare nothing; the visitor sees them with the
            // literal. The names in a simulation are parameters of its method.
            const bool declares = expr->kind != ExprKind::record && expr->kind != ExprKind::simulation;
            if (declares) variable(*binding.variable);
            expression(binding.value);
        }
        for (auto& arg : expr->args) expression(arg);
    }

    void communication(Communication& communication) {
        visitor_.visit(communication);
        expression(communication.value);
        expression(communication.predicate);
    }

    void statement(const StmtPtr& statement) {
        if (!statement) return;
        visitor_.visit(*statement);
        expression(statement->condition);
        expression(statement->target);
        expression(statement->value);
        expression(statement->upper);
        if (statement->communication) communication(*statement->communication);
        for (auto& arg : statement->args) expression(arg);
        for (auto& inner : statement->body) this->statement(inner);
    }

    Visitor& visitor_;
};

}  // namespace robochart::frontend
