// SPDX-License-Identifier: Apache-2.0
// Traverses all parts of a file that have names or that resolution fills. The visitor has an overload of `visit` for
// every kind of node. A node is visited before its parts. The recursion is bounded, because the parser limits nesting.
#pragma once

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

template <class Visitor>
class Traversal {
public:
    explicit Traversal(Visitor& visitor) : visitor_(visitor) {}

    /// Visits all parts of a file. `AnyFile` is `File` or `const File`, and all nodes are visited with the same
    /// constness.
    template <class AnyFile>
    void visit_file(AnyFile& file) {
        for (auto& import : file.imports) visitor_.visit(import);
        for (auto& declaration : file.declarations) this->visit_declaration(*declaration);
        for (auto& assertion : file.assertions) {
            visitor_.visit(assertion);
            for (auto& parameter : assertion.parameters) {
                visitor_.visit(parameter);
                visit_expression(parameter.value);
            }
        }
        for (auto& simulation : file.simulations) {
            visitor_.visit(*simulation);
            visit_context(*simulation);
        }
        for (auto& block : file.csp_blocks) visitor_.visit(block);
        for (auto& definition : file.probabilistic_definitions) this->visit_definition(definition);
        for (auto& assertion : file.probabilistic_assertions) {
            for (const ExprPtr* part :
                 {&assertion.property, &assertion.path.steps, &assertion.path.repeats, &assertion.path.limit})
                visit_expression(*part);
            for (auto& clause : assertion.clauses) visit_definition(clause.definition);
        }
    }

private:
    template <class AnyDefinition>
    void visit_definition(AnyDefinition& definition) {
        if (definition.constant) visit_variable(*definition.constant);
        visit_expression(definition.value);
        for (auto& setting : definition.constants) {
            visit_expression(setting.constant);
            visit_expression(setting.value);
        }
        for (auto& item : definition.rewards)
            for (const ExprPtr* part : {&item.event, &item.guard, &item.value}) visit_expression(*part);
        for (auto& function : definition.functions) {
            for (auto& parameter : function.parameters) visit_variable(*parameter);
            visit_expression(function.result);
            visit_updates(function.updates);
        }
        for (auto& module : definition.modules) {
            for (auto& declared : module.variables) {
                visit_variable(*declared.variable);
                visit_expression(declared.low);
                visit_expression(declared.high);
            }
            for (auto& command : module.commands) {
                visit_expression(command.event);
                visit_expression(command.guard);
                visit_updates(command.updates);
            }
        }
    }

    template <class Updates>
    void visit_updates(Updates& list) {
        for (auto& update : list)
            for (const ExprPtr* part : {&update.probability, &update.variable, &update.value}) visit_expression(*part);
    }

    void visit_declaration(Declaration& any) {
        if (auto* type = dynamic_cast<TypeDeclaration*>(&any)) return type_declaration(*type);
        if (auto* function = dynamic_cast<Function*>(&any)) return this->visit_function(*function);
        if (auto* machine = dynamic_cast<Machine*>(&any)) return this->visit_machine(*machine);
        if (auto* component = dynamic_cast<Component*>(&any)) return this->visit_component(*component);
        if (auto* plain = dynamic_cast<Context*>(&any)) {
            visitor_.visit(*plain);
            visit_context(*plain);
        }
    }

    void type_declaration(TypeDeclaration& declaration) {
        visitor_.visit(declaration);
        visit_variables(declaration.fields);
        for (auto& literal : declaration.literals) {
            visitor_.visit(*literal);
            for (auto& argument : literal->arguments) visit_type(argument);
        }
    }

    void visit_function(Function& function) {
        visitor_.visit(function);
        visit_variables(function.parameters);
        visit_type(function.result_expr);
        visit_expressions(function.preconditions);
        visit_expressions(function.postconditions);
    }

    void visit_context(Context& context) {
        for (auto& clause : context.interfaces) visitor_.visit(clause);
        visit_variables(context.variables);
        for (auto& event : context.events) {
            visitor_.visit(*event);
            visit_type(event->type_expr);
        }
        for (auto& clock : context.clocks) visitor_.visit(*clock);
        for (auto& signature : context.signatures) {
            visitor_.visit(*signature);
            visit_variables(signature->parameters);
        }
        visit_expression(context.cycle);
        for (auto* registers : {&context.input, &context.output}) {
            if (!*registers) continue;
            visitor_.visit(**registers);
            visit_context(**registers);
        }
    }

    void visit_machine(Machine& machine) {
        visitor_.visit(machine);
        visit_variables(machine.parameters);
        visit_context(machine);
        visit_expressions(machine.preconditions);
        visit_expressions(machine.postconditions);
        visit_nodes(machine);
    }

    void visit_component(Component& component) {
        visitor_.visit(component);
        visit_context(component);
        for (auto& part : component.platforms) visit_declaration(*part);
        for (auto& part : component.controllers) visit_declaration(*part);
        for (auto& part : component.machines) visit_declaration(*part);
        for (auto& part : component.operations) visit_declaration(*part);
        for (auto& reference : component.references) visitor_.visit(*reference);
        for (auto& connection : component.connections) visitor_.visit(*connection);
    }

    void visit_nodes(NodeContainer& container) {
        for (auto& state : container.nodes) {
            visitor_.visit(*state);
            for (auto& action : state->actions) visit_statement(action.statement);
            visit_nodes(*state);
        }
        for (auto& transition : container.transitions) {
            visitor_.visit(*transition);
            if (transition->trigger) visit_communication(*transition->trigger);
            visit_expression(transition->probability);
            visit_expression(transition->deadline);
            visit_expression(transition->condition);
            visit_statement(transition->action);
        }
    }

    void visit_variables(std::vector<VariablePtr>& list) {
        for (auto& variable : list) this->visit_variable(*variable);
    }
    void visit_variable(Variable& variable) {
        visitor_.visit(variable);
        visit_type(variable.type_expr);
        visit_expression(variable.initial);
    }

    void visit_type(TypeExprPtr& written) {
        if (!written) return;
        visitor_.visit(*written);
        for (auto& arg : written->args) visit_type(arg);
        visit_expressions(written->sizes);
    }

    void visit_expressions(std::vector<ExprPtr>& list) {
        for (auto& expression : list) visit_expression(expression);
    }
    void visit_expression(const ExprPtr& expr) {
        if (!expr) return;
        visitor_.visit(*expr);
        visit_expression(expr->callee);
        visit_type(expr->type_expr);
        for (Binding& binding : expr->bindings) {
            // The names in a record literal refer to fields and declare nothing, so they are visited with the literal.
            // The names in a simulation are parameters of its method.
            const bool declares = expr->kind != ExprKind::record && expr->kind != ExprKind::simulation;
            if (declares) visit_variable(*binding.variable);
            visit_expression(binding.value);
        }
        for (auto& arg : expr->args) visit_expression(arg);
    }

    void visit_communication(Communication& communication) {
        visitor_.visit(communication);
        visit_expression(communication.value);
        visit_expression(communication.predicate);
    }

    void visit_statement(const StmtPtr& statement) {
        if (!statement) return;
        visitor_.visit(*statement);
        visit_expression(statement->condition);
        visit_expression(statement->target);
        visit_expression(statement->value);
        visit_expression(statement->upper);
        if (statement->communication) visit_communication(*statement->communication);
        for (auto& arg : statement->args) visit_expression(arg);
        for (auto& inner : statement->body) this->visit_statement(inner);
    }

    Visitor& visitor_;
};

}  // namespace robochart::frontend
