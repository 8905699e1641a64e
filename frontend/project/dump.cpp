// SPDX-License-Identifier: Apache-2.0
// Writes the model as indented text, with one node per line, for `--print ast` and `--print model`.
#include <fmt/format.h>

#include "base/diagnostics/text.hpp"
#include "frontend/project/project.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/types/types.hpp"

namespace robochart::frontend {

namespace {

class Dumper {
public:
    Dumper(const diagnostics::SourceManager& sources, bool resolved) : sources_(sources), resolved_(resolved) {}

    void dump_file(const File& file);
    [[nodiscard]] std::string take_text() { return std::move(out_); }

private:
    template <class... Args>
    void write_line(fmt::format_string<Args...> pattern, Args&&... args) {
        out_.append(2 * depth_, ' ');
        fmt::format_to(std::back_inserter(out_), pattern, std::forward<Args>(args)...);
        out_ += '\n';
    }
    template <class Body>
    void with_indentation(Body body) {
        ++depth_;
        body();
        --depth_;
    }
    void dump_declaration(const Declaration& declaration);
    void type_declaration(const TypeDeclaration& type);
    void dump_function(const Function& function);
    void dump_context(const Context& context);
    void dump_machine(const Machine& machine);
    void dump_component(const Component& component);
    void component_part(const Declaration& part);
    void dump_reference(const Reference& reference);
    void dump_connection(const Connection& connection);
    void dump_nodes(const NodeContainer& container);
    void dump_state(const State& state);
    void dump_transition(const Transition& transition);
    void dump_variable(const Variable& variable);
    void dump_expressions(std::string_view word, const std::vector<ExprPtr>& list);
    void dump_simulation(const Simulation& simulation);
    void dump_assertion(const Assertion& assertion);
    void csp_block(const CspBlock& block);
    [[nodiscard]] std::string parameter_list(const std::vector<VariablePtr>& list) const;
    /// Returns ` -> file:line name` for the declaration that a name refers to.
    [[nodiscard]] std::string target_text(const Declaration* declaration) const;
    [[nodiscard]] std::string text_with_type(const Expr& expr) const;

    const diagnostics::SourceManager& sources_;
    bool resolved_;
    std::string out_;
    std::size_t depth_ = 0;
};

std::string Dumper::target_text(const Declaration* declaration) const {
    if (!resolved_) return {};
    if (declaration == nullptr) return " -> nothing";
    const std::string place = sources_.path_and_line(declaration->name_span);
    return fmt::format(" -> {} {}{}{}", to_text(declaration->kind), declaration->name, place.empty() ? "" : " ", place);
}

std::string Dumper::text_with_type(const Expr& expr) const {
    return to_text(expr) + (resolved_ ? " : " + to_string(expr.type) : "");
}

std::string Dumper::parameter_list(const std::vector<VariablePtr>& list) const {
    std::string out;
    for (const VariablePtr& parameter : list)
        out += (out.empty() ? "" : ", ") + parameter->name + ":" +
               (resolved_ || !parameter->type_expr ? to_string(parameter->type) : to_text(*parameter->type_expr));
    return out;
}

void Dumper::dump_expressions(std::string_view word, const std::vector<ExprPtr>& list) {
    for (const ExprPtr& expr : list) write_line("{} {}", word, text_with_type(*expr));
}

void Dumper::dump_variable(const Variable& variable) {
    const bool semantic = resolved_ || !variable.type_expr;
    const std::string type = semantic ? to_string(variable.type) : to_text(*variable.type_expr);
    write_line("{} {}:{}{}", to_text(variable.kind), variable.name, type,
               variable.initial ? " = " + text_with_type(*variable.initial) : "");
}

void Dumper::type_declaration(const TypeDeclaration& type) {
    write_line("{} {}", to_text(type.kind), type.name);
    with_indentation([&] {
        for (const VariablePtr& field : type.fields) dump_variable(*field);
        for (const auto& literal : type.literals) {
            std::string arguments;
            for (const TypeExprPtr& argument : literal->arguments)
                arguments += (arguments.empty() ? "" : ", ") + to_text(*argument);
            write_line("literal {}{}", literal->name, arguments.empty() ? "" : "(" + arguments + ")");
        }
    });
}

void Dumper::dump_function(const Function& function) {
    write_line("function {}({}):{}", function.name, parameter_list(function.parameters),
               resolved_ || !function.result_expr ? to_string(function.result) : to_text(*function.result_expr));
    with_indentation([&] {
        dump_expressions("precondition", function.preconditions);
        dump_expressions("postcondition", function.postconditions);
    });
}

void Dumper::dump_context(const Context& context) {
    for (const InterfaceClause& clause : context.interfaces)
        write_line("{} {}{}", to_text(clause.use), clause.name.text(), target_text(clause.target));
    for (const VariablePtr& declared : context.variables) dump_variable(*declared);
    for (const auto& event : context.events) {
        std::string type;
        if (event->type_expr) type = ":" + (resolved_ ? to_string(event->type) : to_text(*event->type_expr));
        write_line("{}event {}{}", event->broadcast ? "_broadcast " : "", event->name, type);
    }
    for (const auto& clock : context.clocks) write_line("clock {}", clock->name);
    if (context.cycle) write_line("cycleDef {}", text_with_type(*context.cycle));
    for (const auto* registers : {&context.input, &context.output}) {
        if (!*registers) continue;
        write_line("{}", to_text((*registers)->kind));
        with_indentation([&] { this->dump_context(**registers); });
    }
    for (const auto& signature : context.signatures)
        write_line("{}({}){}", signature->name, parameter_list(signature->parameters),
                   signature->terminates ? " [terminates]" : "");
}

void Dumper::dump_machine(const Machine& machine) {
    const bool is_operation = machine.kind == DeclKind::operation;
    write_line("{} {}{}", to_text(machine.kind), machine.name,
               is_operation ? "(" + parameter_list(machine.parameters) + ")" : "");
    with_indentation([&] {
        if (machine.terminates) write_line("terminates");
        dump_expressions("precondition", machine.preconditions);
        dump_expressions("postcondition", machine.postconditions);
        dump_context(machine);
        dump_nodes(machine);
    });
}

void Dumper::dump_nodes(const NodeContainer& container) {
    for (const auto& node : container.nodes) dump_state(*node);
    for (const auto& transition : container.transitions) this->dump_transition(*transition);
}

void Dumper::dump_state(const State& state) {
    write_line("{} {}", to_text(state.kind), state.name);
    with_indentation([&] {
        for (const Action& action : state.actions)
            write_line("{} {}", to_text(action.kind), action.statement ? to_text(*action.statement) : "<error>");
        dump_nodes(state);
    });
}

void Dumper::dump_transition(const Transition& transition) {
    write_line("transition {}: {} -> {}", transition.name, transition.from.text(), transition.to.text());
    with_indentation([&] {
        if (resolved_) write_line("from{} to{}", target_text(transition.source), target_text(transition.target));
        if (transition.trigger)
            write_line("trigger {}{}", to_text(*transition.trigger), target_text(transition.trigger->event_target));
        if (transition.exec) write_line("exec");
        if (transition.probability) write_line("probability {}", text_with_type(*transition.probability));
        for (const Transition::Reset& reset : transition.resets)
            write_line("#{}{}", reset.name.text(), target_text(reset.clock));
        if (transition.deadline) write_line("<{{{}}}", text_with_type(*transition.deadline));
        if (transition.otherwise) write_line("condition else");
        if (transition.condition) write_line("condition {}", text_with_type(*transition.condition));
        if (transition.action) write_line("action {}", to_text(*transition.action));
    });
}

void Dumper::dump_reference(const Reference& reference) {
    write_line("{} reference {} = {}{}", to_text(reference.refers_to), reference.name, reference.target_name.text(),
               target_text(reference.target));
}

void Dumper::dump_connection(const Connection& connection) {
    write_line("connection {} on {} to {} on {}{}{}", connection.from.node.text(), connection.from.event.text(),
               connection.to.node.text(), connection.to.event.text(), connection.async ? " (_async)" : "",
               connection.multiple ? " [mult]" : "");
    if (!resolved_) return;
    with_indentation([&] {
        for (const Connection::End* end : {&connection.from, &connection.to})
            write_line("end{}{}", target_text(end->node_target), target_text(end->event_target));
    });
}

void Dumper::dump_component(const Component& component) {
    write_line("{} {}", to_text(component.kind), component.name);
    with_indentation([&] {
        dump_context(component);
        for (const Declaration* part : component.order) dump_declaration(*part);
        for (const auto& connection : component.connections) this->dump_connection(*connection);
    });
}

void Dumper::dump_declaration(const Declaration& declared) {
    if (const auto* type = dynamic_cast<const TypeDeclaration*>(&declared)) return type_declaration(*type);
    if (const auto* declared_function = dynamic_cast<const Function*>(&declared))
        return dump_function(*declared_function);
    if (const auto* stm = dynamic_cast<const Machine*>(&declared)) return dump_machine(*stm);
    if (const auto* part = dynamic_cast<const Component*>(&declared)) return dump_component(*part);
    if (const auto* ref = dynamic_cast<const Reference*>(&declared)) return dump_reference(*ref);
    if (const auto* plain = dynamic_cast<const Context*>(&declared)) {
        write_line("{} {}", to_text(plain->kind), plain->name);
        with_indentation([&] { dump_context(*plain); });
    }
}

void Dumper::dump_simulation(const Simulation& simulation) {
    const auto& steps = simulation.subject_path.steps;
    write_line("simulation {} of {}{}", simulation.name, simulation.subject.text(),
               target_text(steps.empty() ? nullptr : steps.back()));
    with_indentation([&] { dump_context(simulation); });
}

void Dumper::csp_block(const CspBlock& block) {
    std::string associated;
    for (const QualifiedName& name : block.associated) associated += " " + name.text();
    write_line("csp {}{}{} ({} bytes)", block.name, associated.empty() ? "" : " associated to", associated,
               block.text.size());
}

void Dumper::dump_assertion(const Assertion& assertion) {
    std::string_view wording = sources_.source_text(assertion.span.source)
                                   .substr(assertion.span.begin, assertion.span.end - assertion.span.begin);
    write_line("{}", diagnostics::on_one_line(wording));
    with_indentation([&] {
        write_line("subject {} other {} negated {} parameters {}", assertion.subject.text(), assertion.other.text(),
                   assertion.negated, assertion.parameters.size());
    });
}

void Dumper::dump_file(const File& file) {
    write_line("file {}", file.source == diagnostics::SourceId::none ? "?" : sources_.path(file.source));
    with_indentation([&] {
        if (!file.package.empty()) write_line("package {}", file.package.text());
        for (const Import& import : file.imports)
            write_line("import {}{}", import.name.text(), import.wildcard ? "::*" : "");
        for (const auto& declared : file.declarations) dump_declaration(*declared);
        for (const auto& simulation : file.simulations) dump_simulation(*simulation);
        for (const Assertion& asserted : file.assertions) dump_assertion(asserted);
        for (const CspBlock& block : file.csp_blocks) csp_block(block);
        for (const ProbabilisticDefinition& definition : file.probabilistic_definitions)
            write_line("{}", diagnostics::on_one_line(to_text(definition)));
        for (const ProbabilisticAssertion& assertion : file.probabilistic_assertions)
            write_line("{}", diagnostics::on_one_line(to_text(assertion)));
        if (!file.kept.empty()) write_line("kept as text: {} parts", file.kept.size());
    });
}

}  // namespace

std::string dump_model(const Model& model, const diagnostics::SourceManager& sources, bool resolved) {
    Dumper dumper(sources, resolved);
    for (const auto& file : model.files) dumper.dump_file(*file);
    return dumper.take_text();
}

}  // namespace robochart::frontend
