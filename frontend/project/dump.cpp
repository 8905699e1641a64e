// SPDX-License-Identifier: Apache-2.0
// The model as indented text, one node a line, for `--print ast` and `--print model`.
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

    void file(const File& file);
    [[nodiscard]] std::string take() { return std::move(out_); }

private:
    template <class... Args>
    void line(fmt::format_string<Args...> pattern, Args&&... args) {
        out_.append(2 * depth_, ' ');
        fmt::format_to(std::back_inserter(out_), pattern, std::forward<Args>(args)...);
        out_ += '\n';
    }
    template <class Body>
    void inside(Body body) {
        ++depth_;
        body();
        --depth_;
    }
    void declaration(const Declaration& declaration);
    void type_declaration(const TypeDeclaration& type);
    void function(const Function& function);
    void context(const Context& context);
    void machine(const Machine& machine);
    void component(const Component& component);
    void component_part(const Declaration& part);
    void reference(const Reference& reference);
    void connection(const Connection& connection);
    void nodes(const NodeContainer& container);
    void state(const State& state);
    void transition(const Transition& transition);
    void variable(const Variable& variable);
    void expressions(std::string_view word, const std::vector<ExprPtr>& list);
    void assertion(const Assertion& assertion);
    void csp_block(const CspBlock& block);
    [[nodiscard]] std::string parameters(const std::vector<VariablePtr>& list) const;
    /// ` -> file:line name` of the declaration that a name refers to.
    [[nodiscard]] std::string target(const Declaration* declaration) const;
    [[nodiscard]] std::string typed(const Expr& expr) const;

    const diagnostics::SourceManager& sources_;
    bool resolved_;
    std::string out_;
    std::size_t depth_ = 0;
};

std::string Dumper::target(const Declaration* declaration) const {
    if (!resolved_) return {};
    if (declaration == nullptr) return " -> nothing";
    const std::string place = sources_.place(declaration->name_span);
    return fmt::format(" -> {} {}{}{}", to_text(declaration->kind), declaration->name, place.empty() ? "" : " ", place);
}

std::string Dumper::typed(const Expr& expr) const {
    return to_text(expr) + (resolved_ ? " : " + to_string(expr.type) : "");
}

std::string Dumper::parameters(const std::vector<VariablePtr>& list) const {
    std::string out;
    for (const VariablePtr& parameter : list)
        out += (out.empty() ? "" : ", ") + parameter->name + ":" +
               (resolved_ || !parameter->type_expr ? to_string(parameter->type) : to_text(*parameter->type_expr));
    return out;
}

void Dumper::expressions(std::string_view word, const std::vector<ExprPtr>& list) {
    for (const ExprPtr& expr : list) line("{} {}", word, typed(*expr));
}

void Dumper::variable(const Variable& variable) {
    const bool semantic = resolved_ || !variable.type_expr;
    const std::string type = semantic ? to_string(variable.type) : to_text(*variable.type_expr);
    line("{} {}:{}{}", to_text(variable.kind), variable.name, type,
         variable.initial ? " = " + typed(*variable.initial) : "");
}

void Dumper::type_declaration(const TypeDeclaration& type) {
    line("{} {}", to_text(type.kind), type.name);
    inside([&] {
        for (const VariablePtr& field : type.fields) variable(*field);
        for (const auto& literal : type.literals) {
            std::string arguments;
            for (const TypeExprPtr& argument : literal->arguments)
                arguments += (arguments.empty() ? "" : ", ") + to_text(*argument);
            line("literal {}{}", literal->name, arguments.empty() ? "" : "(" + arguments + ")");
        }
    });
}

void Dumper::function(const Function& function) {
    line("function {}({}):{}", function.name, parameters(function.parameters),
         resolved_ || !function.result_expr ? to_string(function.result) : to_text(*function.result_expr));
    inside([&] {
        expressions("precondition", function.preconditions);
        expressions("postcondition", function.postconditions);
    });
}

void Dumper::context(const Context& context) {
    for (const InterfaceClause& clause : context.interfaces) {
        const std::string_view word = clause.use == InterfaceUse::uses       ? "uses"
                                      : clause.use == InterfaceUse::provides ? "provides"
                                                                             : "requires";
        line("{} {}{}", word, clause.name.text(), target(clause.target));
    }
    for (const VariablePtr& declared : context.variables) variable(*declared);
    for (const auto& event : context.events)
        line("{}event {}{}", event->broadcast ? "_broadcast " : "", event->name,
             event->type_expr ? ":" + (resolved_ ? to_string(event->type) : to_text(*event->type_expr)) : "");
    for (const auto& clock : context.clocks) line("clock {}", clock->name);
    for (const auto& signature : context.signatures)
        line("{}({}){}", signature->name, parameters(signature->parameters),
             signature->terminates ? " [terminates]" : "");
}

void Dumper::machine(const Machine& machine) {
    const bool is_operation = machine.kind == DeclKind::operation;
    line("{} {}{}", to_text(machine.kind), machine.name,
         is_operation ? "(" + parameters(machine.parameters) + ")" : "");
    inside([&] {
        if (machine.terminates) line("terminates");
        expressions("precondition", machine.preconditions);
        expressions("postcondition", machine.postconditions);
        context(machine);
        nodes(machine);
    });
}

void Dumper::nodes(const NodeContainer& container) {
    for (const auto& node : container.nodes) state(*node);
    for (const auto& transition : container.transitions) this->transition(*transition);
}

void Dumper::state(const State& state) {
    line("{} {}", to_text(state.kind), state.name);
    inside([&] {
        for (const Action& action : state.actions) {
            const std::string_view word = action.kind == ActionKind::entry    ? "entry"
                                          : action.kind == ActionKind::during ? "during"
                                                                              : "exit";
            line("{} {}", word, action.statement ? to_text(*action.statement) : "<error>");
        }
        nodes(state);
    });
}

void Dumper::transition(const Transition& transition) {
    line("transition {}: {} -> {}", transition.name, transition.from.text(), transition.to.text());
    inside([&] {
        if (resolved_) line("from{} to{}", target(transition.source), target(transition.target));
        if (transition.trigger)
            line("trigger {}{}", to_text(*transition.trigger), target(transition.trigger->event_target));
        if (transition.probability) line("probability {}", typed(*transition.probability));
        for (const Transition::Reset& reset : transition.resets) line("#{}{}", reset.name.text(), target(reset.clock));
        if (transition.deadline) line("<{{{}}}", typed(*transition.deadline));
        if (transition.otherwise) line("condition else");
        if (transition.condition) line("condition {}", typed(*transition.condition));
        if (transition.action) line("action {}", to_text(*transition.action));
    });
}

void Dumper::reference(const Reference& reference) {
    line("{} reference {} = {}{}", to_text(reference.refers_to), reference.name, reference.target_name.text(),
         target(reference.target));
}

void Dumper::connection(const Connection& connection) {
    line("connection {} on {} to {} on {}{}{}", connection.from.node.text(), connection.from.event.text(),
         connection.to.node.text(), connection.to.event.text(), connection.async ? " (_async)" : "",
         connection.multiple ? " [mult]" : "");
    if (!resolved_) return;
    inside([&] {
        for (const Connection::End* end : {&connection.from, &connection.to})
            line("end{}{}", target(end->node_target), target(end->event_target));
    });
}

void Dumper::component(const Component& component) {
    line("{} {}", to_text(component.kind), component.name);
    inside([&] {
        context(component);
        for (const Declaration* part : component.order) declaration(*part);
        for (const auto& connection : component.connections) this->connection(*connection);
    });
}

void Dumper::declaration(const Declaration& declared) {
    if (const auto* type = dynamic_cast<const TypeDeclaration*>(&declared)) return type_declaration(*type);
    if (const auto* declared_function = dynamic_cast<const Function*>(&declared)) return function(*declared_function);
    if (const auto* stm = dynamic_cast<const Machine*>(&declared)) return machine(*stm);
    if (const auto* part = dynamic_cast<const Component*>(&declared)) return component(*part);
    if (const auto* ref = dynamic_cast<const Reference*>(&declared)) return reference(*ref);
    if (const auto* plain = dynamic_cast<const Context*>(&declared)) {
        line("{} {}", to_text(plain->kind), plain->name);
        inside([&] { context(*plain); });
    }
}

void Dumper::csp_block(const CspBlock& block) {
    std::string associated;
    for (const QualifiedName& name : block.associated) associated += " " + name.text();
    line("csp {}{}{} ({} bytes)", block.name, associated.empty() ? "" : " associated to", associated,
         block.text.size());
}

void Dumper::assertion(const Assertion& assertion) {
    std::string_view wording =
        sources_.text(assertion.span.source).substr(assertion.span.begin, assertion.span.end - assertion.span.begin);
    line("{}", diagnostics::on_one_line(wording));
    inside([&] {
        line("subject {} other {} negated {} parameters {}", assertion.subject.text(), assertion.other.text(),
             assertion.negated, assertion.parameters.size());
    });
}

void Dumper::file(const File& file) {
    line("file {}", file.source == diagnostics::SourceId::none ? "?" : sources_.path(file.source));
    inside([&] {
        if (!file.package.empty()) line("package {}", file.package.text());
        for (const Import& import : file.imports) line("import {}{}", import.name.text(), import.wildcard ? "::*" : "");
        for (const auto& declared : file.declarations) declaration(*declared);
        for (const Assertion& asserted : file.assertions) assertion(asserted);
        for (const CspBlock& block : file.csp_blocks) csp_block(block);
        for (const ProbabilisticDefinition& each : file.probabilistic_definitions)
            line("{}", diagnostics::on_one_line(to_text(each)));
        for (const ProbabilisticAssertion& each : file.probabilistic_assertions)
            line("{}", diagnostics::on_one_line(to_text(each)));
        if (!file.kept.empty()) line("kept as text: {} parts", file.kept.size());
    });
}

}  // namespace

std::string dump(const Model& model, const diagnostics::SourceManager& sources, bool resolved) {
    Dumper dumper(sources, resolved);
    for (const auto& file : model.files) dumper.file(*file);
    return dumper.take();
}

}  // namespace robochart::frontend
