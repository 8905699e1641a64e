// SPDX-License-Identifier: Apache-2.0
// Prints whole files as RoboChart text, one member a line. See print.hpp.
#include <fmt/format.h>

#include "frontend/syntax/print.hpp"

namespace robochart::frontend {

namespace {

/// Writes indented lines.
class Printer {
public:
    void declaration(const Declaration& declaration);
    void assertion(const Assertion& assertion);
    void file(const File& file);
    [[nodiscard]] std::string take() { return std::move(out_); }

private:
    void line(std::string_view text) {
        out_.append(4 * depth_, ' ');
        out_ += text;
        out_ += '\n';
    }
    template <class Body>
    void braces(const std::string& head, Body body) {
        line(head + " {");
        ++depth_;
        body();
        --depth_;
        line("}");
    }
    void types(const TypeDeclaration& type);
    void function(const Function& function);
    void clauses(const Context& context);
    void context(const Context& context);
    void machine(const Machine& machine);
    void component(const Component& component);
    void reference(const Reference& reference);
    void connection(const Connection& connection);
    void nodes(const NodeContainer& container);
    void node(const State& node);
    void transition(const Transition& transition);
    void csp_block(const CspBlock& block);
    void conditions(std::string_view word, const std::vector<ExprPtr>& list);

    std::string out_;
    std::size_t depth_ = 0;
};

std::string typed(const Variable& variable) {
    std::string out = written_name(variable.name);
    if (variable.type_expr) out += " : " + to_text(*variable.type_expr);
    return out;
}

std::string parameters(const std::vector<VariablePtr>& list) {
    std::string out;
    for (const VariablePtr& parameter : list) out += (out.empty() ? "" : ", ") + typed(*parameter);
    return "(" + out + ")";
}

void Printer::conditions(std::string_view word, const std::vector<ExprPtr>& list) {
    for (const ExprPtr& condition : list) line(fmt::format("{} {}", word, to_text(*condition)));
}

void Printer::types(const TypeDeclaration& type) {
    const std::string name = written_name(type.name);
    if (type.kind == DeclKind::primitive_type) return line("type " + name);
    if (type.kind == DeclKind::record_type)
        return braces((type.record_keyword ? "record " : "datatype ") + name, [&] {
            for (const VariablePtr& field : type.fields) line(typed(*field));
        });
    braces("enumeration " + name, [&] {
        for (const auto& literal : type.literals) {
            std::string arguments;
            for (const TypeExprPtr& argument : literal->arguments)
                arguments += (arguments.empty() ? "" : ", ") + to_text(*argument);
            line(written_name(literal->name) + (arguments.empty() ? "" : "(" + arguments + ")"));
        }
    });
}

void Printer::function(const Function& function) {
    const std::string result = function.result_expr ? " : " + to_text(*function.result_expr) : "";
    braces("function " + written_name(function.name) + parameters(function.parameters) + result, [&] {
        conditions("precondition", function.preconditions);
        conditions("postcondition", function.postconditions);
    });
}

void Printer::clauses(const Context& context) {
    for (const InterfaceClause& clause : context.interfaces) {
        const std::string_view word = clause.use == InterfaceUse::uses       ? "uses"
                                      : clause.use == InterfaceUse::provides ? "provides"
                                                                             : "requires";
        line(fmt::format("{} {}", word, written_name(clause.name)));
    }
}

void Printer::context(const Context& context) {
    clauses(context);
    for (const VariablePtr& variable : context.variables)
        line(fmt::format("{} {}{}", variable->kind == DeclKind::constant ? "const" : "var", typed(*variable),
                         variable->initial ? " = " + to_text(*variable->initial) : ""));
    for (const auto& event : context.events)
        line(fmt::format("{}event {}{}", event->broadcast ? "_broadcast " : "", written_name(event->name),
                         event->type_expr ? " : " + to_text(*event->type_expr) : ""));
    for (const auto& clock : context.clocks) line("clock " + written_name(clock->name));
    for (const auto& signature : context.signatures)
        line(written_name(signature->name) + parameters(signature->parameters) +
             (signature->terminates ? " [terminates]" : ""));
}

// ---------------------------------------------------------------- machines

void Printer::machine(const Machine& machine) {
    const bool operation = machine.kind == DeclKind::operation;
    const std::string name = written_name(machine.name);
    braces(operation ? "operation " + name + parameters(machine.parameters) : "stm " + name, [&] {
        if (machine.terminates) line("terminates");
        conditions("precondition", machine.preconditions);
        conditions("postcondition", machine.postconditions);
        context(machine);
        nodes(machine);
    });
}

void Printer::nodes(const NodeContainer& container) {
    for (const auto& each : container.nodes) node(*each);
    for (const auto& each : container.transitions) transition(*each);
}

std::string_view node_word(DeclKind kind) {
    switch (kind) {
        case DeclKind::initial:
            return "initial";
        case DeclKind::final:
            return "final";
        case DeclKind::junction:
            return "junction";
        case DeclKind::probabilistic:
            return "probabilistic";
        default:
            return "state";
    }
}

std::string_view action_word(ActionKind kind) {
    return kind == ActionKind::entry ? "entry" : kind == ActionKind::during ? "during" : "exit";
}

void Printer::node(const State& node) {
    const std::string head = fmt::format("{} {}", node_word(node.kind), written_name(node.name));
    const bool empty = node.actions.empty() && node.nodes.empty() && node.transitions.empty();
    if (empty) return line(node.kind == DeclKind::state ? head + " {}" : head);
    braces(head, [&] {
        for (const Action& action : node.actions)
            line(fmt::format("{} {}", action_word(action.kind), action.statement ? to_text(*action.statement) : ""));
        nodes(node);
    });
}

void Printer::transition(const Transition& transition) {
    braces("transition " + written_name(transition.name), [&] {
        line(fmt::format("from {} to {}", written_name(transition.from), written_name(transition.to)));
        if (transition.legacy_trigger) line("trigger");
        if (transition.trigger) line("trigger " + to_text(*transition.trigger));
        if (transition.probability) line("probability " + to_text(*transition.probability));
        for (const Transition::Reset& reset : transition.resets) line("#" + written_name(reset.name));
        if (transition.deadline) line("<{" + to_text(*transition.deadline) + "}");
        if (transition.otherwise) line("condition else");
        if (transition.condition) line("condition " + to_text(*transition.condition));
        if (transition.action) line("action " + to_text(*transition.action));
    });
}

// ---------------------------------------------------------------- components

void Printer::reference(const Reference& reference) {
    const std::string_view word = reference.refers_to == DeclKind::platform        ? "rref"
                                  : reference.refers_to == DeclKind::controller    ? "cref"
                                  : reference.refers_to == DeclKind::state_machine ? "sref"
                                                                                   : "opref";
    line(fmt::format("{} {} = {}", word, written_name(reference.name), written_name(reference.target_name)));
}

void Printer::connection(const Connection& connection) {
    line(fmt::format("connection {} on {} to {} on {}{}{}", written_name(connection.from.node),
                     written_name(connection.from.event), written_name(connection.to.node),
                     written_name(connection.to.event), connection.async ? " (_async)" : "",
                     connection.multiple ? " [mult]" : ""));
}

void Printer::component(const Component& component) {
    braces(fmt::format("{} {}", to_text(component.kind), written_name(component.name)), [&] {
        context(component);
        for (const Declaration* part : component.order) declaration(*part);
        for (const auto& each : component.connections) connection(*each);
    });
}

void Printer::declaration(const Declaration& declared) {
    if (const auto* type = dynamic_cast<const TypeDeclaration*>(&declared)) return types(*type);
    if (const auto* contract = dynamic_cast<const Function*>(&declared)) return function(*contract);
    if (const auto* stm = dynamic_cast<const Machine*>(&declared)) return machine(*stm);
    if (const auto* part = dynamic_cast<const Component*>(&declared)) return component(*part);
    if (const auto* named = dynamic_cast<const Reference*>(&declared)) return reference(*named);
    if (const auto* plain = dynamic_cast<const Context*>(&declared))
        braces(fmt::format("{} {}", to_text(plain->kind), written_name(plain->name)), [&] { context(*plain); });
}

// ---------------------------------------------------------------- assertions

std::string_view time_word(AssertionTime time) {
    return time == AssertionTime::timed ? "timed " : time == AssertionTime::untimed ? "untimed " : "";
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
        case AssertionKind::clock_initialised:
            break;
    }
    return fmt::format("clock {} is {}initialised", other, negated ? "not " : "");
}

/// `with P`, or `with P, P and P`.
std::string parameter_list(const std::vector<AssertionParameter>& list) {
    std::string out;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const AssertionParameter& each = list[i];
        out += i == 0 ? " with " : i + 1 == list.size() ? " and " : ", ";
        out += fmt::format("{} {} of {} set to {}", each.constant ? "constant" : "parameter", written_name(each.name),
                           written_name(each.context), each.value ? to_text(*each.value) : "");
    }
    return out;
}

void Printer::assertion(const Assertion& assertion) {
    const std::string model =
        assertion.model ? fmt::format(" in the {} model", model_words(*assertion.model)) : std::string();
    const bool of_rule = assertion.kind == AssertionKind::conforms;
    line(fmt::format("{}{}assertion {} : {}{}{}", time_word(assertion.time), of_rule ? "sleec " : "",
                     written_name(assertion.name), claim(assertion), model, parameter_list(assertion.parameters)));
}

void Printer::csp_block(const CspBlock& block) {
    std::string associated;
    for (const QualifiedName& name : block.associated)
        associated += (associated.empty() ? " associated to " : ", ") + written_name(name);
    line(fmt::format("{}csp {}{} csp-begin{}csp-end", time_word(block.time), written_name(block.name), associated,
                     block.text));
}

void Printer::file(const File& file) {
    if (!file.package.empty()) line("package " + written_name(file.package));
    for (const Import& import : file.imports)
        line(fmt::format("import {}{}", written_name(import.name), import.wildcard ? "::*" : ""));
    for (const std::string& diagram : file.diagrams) line("diagram " + written_name(diagram));
    for (const auto& declared : file.declarations) {
        out_ += '\n';
        declaration(*declared);
    }
    for (const CspBlock& block : file.csp_blocks) csp_block(block);
    for (const Assertion& asserted : file.assertions) assertion(asserted);
    for (const ProbabilisticDefinition& definition : file.probabilistic_definitions) out_ += to_text(definition);
    for (const ProbabilisticAssertion& asserted : file.probabilistic_assertions) out_ += to_text(asserted);
    for (const KeptPart& part : file.kept) line(part.text);
}

}  // namespace

std::string to_text(const Declaration& declaration) {
    Printer printer;
    printer.declaration(declaration);
    return printer.take();
}

std::string to_text(const Assertion& assertion) {
    Printer printer;
    printer.assertion(assertion);
    return printer.take();
}

std::string to_text(const File& file) {
    Printer printer;
    printer.file(file);
    return printer.take();
}

}  // namespace robochart::frontend
