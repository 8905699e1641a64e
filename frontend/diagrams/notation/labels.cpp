// SPDX-License-Identifier: Apache-2.0
// See labels.hpp.
#include "frontend/diagrams/notation/labels.hpp"

#include <fmt/format.h>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/text.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::diagrams {

using namespace frontend;

namespace {

std::string printable_line(const std::string& text) {
    return diagnostics::escape_for_display(diagnostics::on_one_line(text));
}

std::string parameters_of(const std::vector<VariablePtr>& parameters) {
    std::string result;
    for (const VariablePtr& parameter : parameters) result += (result.empty() ? "" : ", ") + text_of(*parameter);
    return "(" + result + ")";
}

std::string label_with_type(const std::string& name, const TypeExprPtr& type) {
    return shown_name(name) + (type ? ": " + printable_line(to_text(*type)) : "");
}

std::string body_of(const StmtPtr& statement) {
    return statement ? text_of(*statement) : "";
}

std::string sequence_of(const Stmt& statement) {
    std::string result;
    for (const StmtPtr& part : statement.body) result += (result.empty() ? "" : "; ") + body_of(part);
    return result;
}

std::string choice_of(const Stmt& statement) {
    const std::string condition = statement.condition ? text_of(*statement.condition) : "";
    const std::string otherwise = statement.body.size() > 1 ? " else " + body_of(statement.body[1]) : "";
    return fmt::format("if {} then {}{} end", condition, statement.body.empty() ? "" : body_of(statement.body[0]),
                       otherwise);
}

}  // namespace

std::string shown_name(std::string_view name) {
    if (name.starts_with('?')) return "";  // the parser's placeholder for a missing name
    return diagnostics::escape_for_display(name);
}

std::string text_of(const Expr& expr) {
    return printable_line(to_text(expr));
}

std::string text_of(const Stmt& statement) {
    switch (statement.kind) {
        case StmtKind::sequence:
            return sequence_of(statement);
        case StmtKind::if_then_else:
            return choice_of(statement);
        case StmtKind::communication:
            return statement.communication ? printable_line(to_text(*statement.communication)) : "";
        case StmtKind::deadline:
            return fmt::format("{} <{{{}}}", statement.body.empty() ? "" : body_of(statement.body[0]),
                               statement.value ? text_of(*statement.value) : "");
        case StmtKind::parenthesised:
            return "(" + (statement.body.empty() ? "" : body_of(statement.body[0])) + ")";
        case StmtKind::skip:
        case StmtKind::assignment:
        case StmtKind::call:
        case StmtKind::wait:
        case StmtKind::wait_interval:
        case StmtKind::clock_reset:
        case StmtKind::exec:
        case StmtKind::error:
            break;
    }
    return printable_line(to_text(statement));
}

std::string text_of(const Variable& variable) {
    return label_with_type(variable.name, variable.type_expr) +
           (variable.initial ? " = " + text_of(*variable.initial) : "");
}

std::string text_of(const Event& event) {
    return label_with_type(event.name, event.type_expr);
}

std::string text_of(const OperationSignature& signature) {
    return shown_name(signature.name) + parameters_of(signature.parameters) +
           (signature.terminates ? " [terminates]" : "");
}

std::string title_of(const Machine& operation) {
    return shown_name(operation.name) + parameters_of(operation.parameters) +
           (operation.terminates ? " [terminates]" : "");
}

std::string text_of(const Function& function) {
    return shown_name(function.name) + parameters_of(function.parameters) +
           (function.result_expr ? ": " + printable_line(to_text(*function.result_expr)) : "");
}

std::string text_of(const EnumLiteral& literal) {
    std::string arguments;
    for (const TypeExprPtr& argument : literal.arguments)
        if (argument) arguments += (arguments.empty() ? "" : ", ") + printable_line(to_text(*argument));
    return shown_name(literal.name) + (arguments.empty() ? "" : "(" + arguments + ")");
}

std::vector<std::string> label_of(const Transition& transition) {
    std::vector<std::string> pieces;
    std::string head = transition.trigger ? printable_line(to_text(*transition.trigger)) : "";
    const auto add = [&](const std::string& text) { head += (head.empty() ? "" : " ") + text; };
    if (transition.exec) add("exec");
    for (const Transition::Reset& reset : transition.resets) add("#" + shown_name(reset.name.text()));
    if (transition.deadline) add("<{" + text_of(*transition.deadline) + "}");
    if (transition.probability) add("p{" + text_of(*transition.probability) + "}");
    if (!head.empty()) pieces.push_back(head);
    if (transition.condition) pieces.push_back("[" + text_of(*transition.condition) + "]");
    if (transition.otherwise) pieces.emplace_back("[else]");
    if (transition.action) pieces.push_back("/" + text_of(*transition.action));
    return pieces;
}

}  // namespace robochart::diagrams
