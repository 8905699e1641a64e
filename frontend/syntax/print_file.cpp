// SPDX-License-Identifier: Apache-2.0
// Prints whole files as RoboChart text, with one member per line. See print.hpp.
#include <fmt/format.h>

#include "frontend/syntax/print.hpp"

namespace robochart::frontend {

namespace {

/// Prints a file as indented lines.
class Printer {
public:
    void print_declaration(const Declaration& declaration);
    void print_assertion(const Assertion& assertion);
    void print_file(const File& file);
    [[nodiscard]] std::string take_text() { return std::move(out_); }

private:
    void print_line(std::string_view text) {
        out_.append(4 * depth_, ' ');
        out_ += text;
        out_ += '\n';
    }
    template <class Body>
    void print_braces(const std::string& head, Body body) {
        print_line(head + " {");
        ++depth_;
        body();
        --depth_;
        print_line("}");
    }
    void print_types(const TypeDeclaration& type);
    void print_function(const Function& function);
    void print_clauses(const Context& context);
    void print_context(const Context& context);
    void print_cycle(const Context& context);
    void print_simulation(const Simulation& simulation);
    void print_machine(const Machine& machine);
    void print_component(const Component& component);
    void print_reference(const Reference& reference);
    void print_connection(const Connection& connection);
    void print_nodes(const NodeContainer& container);
    void print_node(const State& node);
    void print_transition(const Transition& transition);
    void csp_block(const CspBlock& block);
    void print_conditions(std::string_view word, const std::vector<ExprPtr>& list);

    std::string out_;
    std::size_t depth_ = 0;
};

std::string typed_name(const Variable& variable) {
    std::string out = written_name(variable.name);
    if (variable.type_expr) out += " : " + to_text(*variable.type_expr);
    return out;
}

std::string parameters_text(const std::vector<VariablePtr>& list) {
    std::string out;
    for (const VariablePtr& parameter : list) out += (out.empty() ? "" : ", ") + typed_name(*parameter);
    return "(" + out + ")";
}

void Printer::print_conditions(std::string_view word, const std::vector<ExprPtr>& list) {
    for (const ExprPtr& condition : list) print_line(fmt::format("{} {}", word, to_text(*condition)));
}

void Printer::print_types(const TypeDeclaration& type) {
    const std::string name = written_name(type.name);
    if (type.kind == DeclKind::primitive_type) return print_line("type " + name);
    if (type.kind == DeclKind::record_type)
        return print_braces((type.record_keyword ? "record " : "datatype ") + name, [&] {
            for (const VariablePtr& field : type.fields) print_line(typed_name(*field));
        });
    print_braces("enumeration " + name, [&] {
        for (const auto& literal : type.literals) {
            std::string arguments;
            for (const TypeExprPtr& argument : literal->arguments)
                arguments += (arguments.empty() ? "" : ", ") + to_text(*argument);
            print_line(written_name(literal->name) + (arguments.empty() ? "" : "(" + arguments + ")"));
        }
    });
}

void Printer::print_function(const Function& function) {
    const std::string result = function.result_expr ? " : " + to_text(*function.result_expr) : "";
    print_braces("function " + written_name(function.name) + parameters_text(function.parameters) + result, [&] {
        print_conditions("precondition", function.preconditions);
        print_conditions("postcondition", function.postconditions);
    });
}

void Printer::print_clauses(const Context& context) {
    for (const InterfaceClause& clause : context.interfaces)
        print_line(fmt::format("{} {}", to_text(clause.use), written_name(clause.name)));
}

/// Prints the constructs of RoboSim: the length of a cycle, and the contexts.
void Printer::print_cycle(const Context& context) {
    if (context.cycle) print_line("cycleDef " + to_text(*context.cycle));
    for (const auto* registers : {&context.input, &context.output})
        if (*registers) print_braces(std::string(to_text((*registers)->kind)), [&] { print_context(**registers); });
}

void Printer::print_context(const Context& context) {
    print_clauses(context);
    print_cycle(context);
    for (const VariablePtr& variable : context.variables)
        print_line(fmt::format("{} {}{}", variable->kind == DeclKind::constant ? "const" : "var", typed_name(*variable),
                               variable->initial ? " = " + to_text(*variable->initial) : ""));
    for (const auto& event : context.events)
        print_line(fmt::format("{}event {}{}", event->broadcast ? "_broadcast " : "", written_name(event->name),
                               event->type_expr ? " : " + to_text(*event->type_expr) : ""));
    for (const auto& clock : context.clocks) print_line("clock " + written_name(clock->name));
    for (const auto& signature : context.signatures)
        print_line(written_name(signature->name) + parameters_text(signature->parameters) +
                   (signature->terminates ? " [terminates]" : ""));
}

// ---------------------------------------------------------------- machines

void Printer::print_machine(const Machine& machine) {
    const bool operation = machine.kind == DeclKind::operation;
    const std::string name = written_name(machine.name);
    print_braces(operation ? "operation " + name + parameters_text(machine.parameters) : "stm " + name, [&] {
        if (machine.terminates) print_line("terminates");
        print_conditions("precondition", machine.preconditions);
        print_conditions("postcondition", machine.postconditions);
        print_context(machine);
        print_nodes(machine);
    });
}

void Printer::print_nodes(const NodeContainer& container) {
    for (const auto& node : container.nodes) print_node(*node);
    for (const auto& transition : container.transitions) print_transition(*transition);
}

std::string_view node_word(DeclKind kind) {
    if (kind == DeclKind::initial) return "initial";
    if (kind == DeclKind::final) return "final";
    if (kind == DeclKind::junction) return "junction";
    return kind == DeclKind::probabilistic ? "probabilistic" : "state";
}

void Printer::print_node(const State& node) {
    const std::string head = fmt::format("{} {}", node_word(node.kind), written_name(node.name));
    const bool empty = node.actions.empty() && node.nodes.empty() && node.transitions.empty();
    if (empty) return print_line(node.kind == DeclKind::state ? head + " {}" : head);
    print_braces(head, [&] {
        for (const Action& action : node.actions)
            print_line(fmt::format("{} {}", to_text(action.kind), action.statement ? to_text(*action.statement) : ""));
        print_nodes(node);
    });
}

void Printer::print_transition(const Transition& transition) {
    print_braces("transition " + written_name(transition.name), [&] {
        print_line(fmt::format("from {} to {}", written_name(transition.from), written_name(transition.to)));
        if (transition.legacy_trigger) print_line("trigger");
        if (transition.trigger) print_line("trigger " + to_text(*transition.trigger));
        if (transition.exec) print_line("exec");
        if (transition.probability) print_line("probability " + to_text(*transition.probability));
        for (const Transition::Reset& reset : transition.resets) print_line("#" + written_name(reset.name));
        if (transition.deadline) print_line("<{" + to_text(*transition.deadline) + "}");
        if (transition.otherwise) print_line("condition else");
        if (transition.condition) print_line("condition " + to_text(*transition.condition));
        if (transition.action) print_line("action " + to_text(*transition.action));
    });
}

// ---------------------------------------------------------------- components

void Printer::print_reference(const Reference& reference) {
    print_line(fmt::format("{} {} = {}", reference_word(reference.refers_to), written_name(reference.name),
                           written_name(reference.target_name)));
}

void Printer::print_connection(const Connection& connection) {
    print_line(fmt::format("connection {} on {} to {} on {}{}{}", written_name(connection.from.node),
                           written_name(connection.from.event), written_name(connection.to.node),
                           written_name(connection.to.event), connection.async ? " (_async)" : "",
                           connection.multiple ? " [mult]" : ""));
}

void Printer::print_component(const Component& component) {
    print_braces(fmt::format("{} {}", to_text(component.kind), written_name(component.name)), [&] {
        print_context(component);
        for (const Declaration* part : component.order) print_declaration(*part);
        for (const auto& connection : component.connections) print_connection(*connection);
    });
}

void Printer::print_declaration(const Declaration& declared) {
    if (const auto* type = dynamic_cast<const TypeDeclaration*>(&declared)) return print_types(*type);
    if (const auto* contract = dynamic_cast<const Function*>(&declared)) return print_function(*contract);
    if (const auto* stm = dynamic_cast<const Machine*>(&declared)) return print_machine(*stm);
    if (const auto* part = dynamic_cast<const Component*>(&declared)) return print_component(*part);
    if (const auto* named = dynamic_cast<const Reference*>(&declared)) return print_reference(*named);
    if (const auto* plain = dynamic_cast<const Context*>(&declared))
        print_braces(fmt::format("{} {}", to_text(plain->kind), written_name(plain->name)),
                     [&] { print_context(*plain); });
}

// ---------------------------------------------------------------- assertions

std::string_view time_word(AssertionTime time) {
    switch (time) {
        case AssertionTime::timed:
            return "timed ";
        case AssertionTime::untimed:
            return "untimed ";
        case AssertionTime::both:
            break;
    }
    return "";
}

std::string_view model_words(AssertionModel model) {
    switch (model) {
        case AssertionModel::traces:
            return "traces";
        case AssertionModel::failures:
            return "failures";
        case AssertionModel::tick_tock:
            return "tick-tock";
        case AssertionModel::failures_divergences:
            break;
    }
    return "failures divergences";
}

std::string claim(const Assertion& assertion) {
    const std::string subject = written_name(assertion.subject);
    const std::string other = written_name(assertion.other);
    const bool negated = assertion.negated;
    const auto is = [&](std::string_view property) {
        return fmt::format("{} is {}{}", subject, negated ? "not " : "", property);
    };
    switch (assertion.kind) {
        case AssertionKind::deadlock_free:
            return is("deadlock-free");
        case AssertionKind::divergence_free:
            return is("divergence-free");
        case AssertionKind::deterministic:
            return is("deterministic");
        case AssertionKind::timelock_free:
            return is("timelock-free");
        case AssertionKind::terminates:
            return subject + (negated ? " does not terminate" : " terminates");
        case AssertionKind::refines:
            return subject + (negated ? " does not refine " : " refines ") + other;
        case AssertionKind::equals:
            return subject + (negated ? " is not equal to " : " equals ") + other;
        case AssertionKind::reachable:
            return fmt::format("{} is {}reachable in {}", other, negated ? "not " : "", subject);
        case AssertionKind::event_missed:
            return fmt::format("event {} is {}missed in {}{}", written_name(assertion.event), negated ? "not " : "",
                               other,
                               assertion.time_units ? fmt::format(" for {} time units", *assertion.time_units) : "");
        case AssertionKind::conforms:
            return subject + (negated ? " does not conform to " : " conforms to ") + other;
        case AssertionKind::schedulable:
            return is("schedulable");
        case AssertionKind::clock_initialised:
            break;
    }
    return fmt::format("clock {} is {}initialised", other, negated ? "not " : "");
}

/// Prints `constant c`, `parameter p` or `cycleDef`.
std::string set_name(const AssertionParameter& parameter) {
    switch (parameter.kind) {
        case ParameterKind::constant:
            return "constant " + written_name(parameter.name);
        case ParameterKind::parameter:
            return "parameter " + written_name(parameter.name);
        case ParameterKind::cycle:
            break;
    }
    return "cycleDef";
}

/// Prints `with P` or `with P, P and P`.
std::string parameter_list(const std::vector<AssertionParameter>& list) {
    std::string out;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const AssertionParameter& parameter = list[i];
        if (i == 0)
            out += " with ";
        else
            out += i + 1 == list.size() ? " and " : ", ";
        out += fmt::format("{} of {} set to {}", set_name(parameter), written_name(parameter.context),
                           parameter.value ? to_text(*parameter.value) : "");
    }
    return out;
}

void Printer::print_assertion(const Assertion& assertion) {
    const std::string model =
        assertion.model ? fmt::format(" in the {} model", model_words(*assertion.model)) : std::string();
    const bool of_rule = assertion.kind == AssertionKind::conforms;
    print_line(fmt::format("{}{}assertion {} : {}{}{}", time_word(assertion.time), of_rule ? "sleec " : "",
                           written_name(assertion.name), claim(assertion), model,
                           parameter_list(assertion.parameters)));
}

void Printer::print_simulation(const Simulation& simulation) {
    print_braces(fmt::format("simulation {} of {}", written_name(simulation.name), written_name(simulation.subject)),
                 [&] { print_cycle(simulation); });
}

void Printer::csp_block(const CspBlock& block) {
    std::string associated;
    for (const QualifiedName& name : block.associated)
        associated += (associated.empty() ? " associated to " : ", ") + written_name(name);
    print_line(fmt::format("{}csp {}{} csp-begin{}csp-end", time_word(block.time), written_name(block.name), associated,
                           block.text));
}

void Printer::print_file(const File& file) {
    if (!file.package.empty()) print_line("package " + written_name(file.package));
    for (const Import& import : file.imports)
        print_line(fmt::format("import {}{}", written_name(import.name), import.wildcard ? "::*" : ""));
    for (const std::string& diagram : file.diagrams) print_line("diagram " + written_name(diagram));
    for (const auto& declared : file.declarations) {
        out_ += '\n';
        print_declaration(*declared);
    }
    for (const auto& simulation : file.simulations) print_simulation(*simulation);
    for (const CspBlock& block : file.csp_blocks) csp_block(block);
    for (const Assertion& asserted : file.assertions) print_assertion(asserted);
    for (const ProbabilisticDefinition& definition : file.probabilistic_definitions) out_ += to_text(definition);
    for (const ProbabilisticAssertion& asserted : file.probabilistic_assertions) out_ += to_text(asserted);
    for (const KeptPart& part : file.kept) print_line(part.text);
}

}  // namespace

std::string to_text(const Declaration& declaration) {
    Printer printer;
    printer.print_declaration(declaration);
    return printer.take_text();
}

std::string to_text(const Assertion& assertion) {
    Printer printer;
    printer.print_assertion(assertion);
    return printer.take_text();
}

std::string to_text(const File& file) {
    Printer printer;
    printer.print_file(file);
    return printer.take_text();
}

}  // namespace robochart::frontend
