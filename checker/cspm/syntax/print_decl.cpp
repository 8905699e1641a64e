// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "checker/cspm/syntax/levels.hpp"
#include "checker/cspm/syntax/printer.hpp"
#include "checker/cspm/syntax/reader.hpp"

namespace robochart::cspm {

namespace {

std::string on_one_line(const ExprPtr& expr) {
    Layout layout(1U << 30U);
    Printer(layout).expression(expr);
    std::string result = layout.render();
    std::ranges::replace(result, '\n', ' ');
    return result;
}

}  // namespace

void Printer::script(const Script& script) {
    declarations(script.decls);
    out_.line();
}

void Printer::declarations(const std::vector<DeclPtr>& decls) {
    bool first = true;
    for (const DeclPtr& decl : decls) {
        if (!first) out_.line();
        if (!first && !decl->comment.empty()) out_.line();
        first = false;
        comment(decl->comment);
        declaration(*decl);
    }
}

void Printer::comment(const std::string& text) {
    std::size_t from = 0;
    while (from < text.size()) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        out_.text("-- " + text.substr(from, end - from));
        out_.line();
        from = end + 1;
    }
}

void Printer::names(const std::vector<std::string>& names) {
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) {
            out_.text(",");
            out_.space_or_line();
        }
        out_.text(names[i]);
    }
}

void Printer::declaration(const Decl& decl) {
    out_.open();
    out_.indent();
    switch (decl.kind) {
        case DeclKind::function:
        case DeclKind::value:
            definition(decl);
            break;
        case DeclKind::channel:
            out_.text("channel ");
            names(decl.names);
            if (decl.body) {
                out_.text(" : ");
                expression(decl.body);
            }
            break;
        case DeclKind::datatype:
        case DeclKind::subtype:
            datatype(decl);
            break;
        case DeclKind::nametype:
            out_.text("nametype " + decl.names.at(0) + " = ");
            expression(decl.body);
            break;
        case DeclKind::module:
            module(decl);
            break;
        case DeclKind::instance:
            out_.text("instance " + decl.names.at(0) + " = " + decl.text);
            if (!decl.arguments.empty()) list("(", decl.arguments, ")");
            break;
        case DeclKind::timed:
            out_.text("Timed");
            if (decl.body) {
                out_.text("(");
                expression(decl.body);
                out_.text(")");
            }
            out_.text(" {");
            block(decl.decls);
            out_.outdent();
            out_.line();
            out_.text("}");
            out_.indent();
            break;
        case DeclKind::transparent:
        case DeclKind::external:
            out_.text(decl.kind == DeclKind::transparent ? "transparent " : "external ");
            names(decl.names);
            break;
        case DeclKind::annotation:
            names(decl.names);
            out_.text(" :: " + decl.text);
            break;
        case DeclKind::print:
            out_.text("print " + on_one_line(decl.body));  // FDR reads the rest of the line
            break;
        case DeclKind::assertion:
            assertion(decl.assertion);
            break;
        case DeclKind::include:
            out_.text("include \"" + decl.names.at(0) + "\"");
            break;
    }
    out_.outdent();
    out_.close();
}

void Printer::definition(const Decl& decl) {
    if (decl.kind == DeclKind::function) {
        out_.text(decl.names.at(0));
        for (const auto& group : decl.patterns) patterns("(", group, ")");
    } else {
        pattern(*decl.patterns.at(0).at(0));
    }
    out_.text(" =");
    if (bare(decl.body).kind == ExprKind::let)
        out_.line();
    else
        out_.space_or_line();
    expression(decl.body);
}

void Printer::datatype(const Decl& decl) {
    out_.text((decl.kind == DeclKind::datatype ? "datatype " : "subtype ") + decl.names.at(0) + " =");
    bool first = true;
    for (const Constructor& each : decl.constructors) {
        out_.space_or_line();
        if (!first) out_.text("| ");
        first = false;
        out_.text(each.name);
        if (!each.fields) continue;
        out_.text(".");
        expression(each.fields, bare(each.fields).kind == ExprKind::dot ? dot_level_expr : postfix_level);
    }
}

void Printer::block(const std::vector<DeclPtr>& decls) {
    if (decls.empty()) return;
    out_.line();
    declarations(decls);
}

// The group around a declaration has indented once; the module's own keywords are one level to the left.
void Printer::module(const Decl& decl) {
    out_.text("module " + decl.names.at(0));
    if (!decl.parameters.empty()) {
        out_.text("(");
        names(decl.parameters);
        out_.text(")");
    }
    block(decl.decls);
    out_.outdent();
    out_.line();
    out_.text("exports");
    out_.indent();
    block(decl.exports);
    out_.outdent();
    out_.line();
    out_.text("endmodule");
    out_.indent();
}

namespace {

std::string_view model_name(Model model) {
    switch (model) {
        case Model::traces:
            return "T";
        case Model::failures:
            return "F";
        case Model::failures_divergences:
            return "FD";
        case Model::refusals:
            return "R";
        case Model::refusals_divergences:
            return "RD";
        case Model::revivals:
            return "V";
        case Model::revivals_divergences:
            return "VD";
        case Model::none:
            return "";
    }
    return "";
}

std::string_view property_name(AssertionKind kind) {
    switch (kind) {
        case AssertionKind::deadlock_free:
            return "deadlock free";
        case AssertionKind::divergence_free:
            return "divergence free";
        case AssertionKind::deterministic:
            return "deterministic";
        default:
            return "has trace";
    }
}

}  // namespace

void Printer::assertion(const Assertion& assertion) {
    out_.text(assertion.negated ? "assert not " : "assert ");
    // `assert not P` would be a negated assertion.
    const bool ambiguous = !assertion.negated && on_one_line(assertion.specification).starts_with("not ");
    expression(assertion.specification, ambiguous ? atom_level : lowest_level);
    const std::string model(model_name(assertion.model));
    if (assertion.kind == AssertionKind::refinement) {
        out_.space_or_line();
        out_.text("[" + model + "= ");
        expression(assertion.implementation);
    } else {
        out_.text(" :[" + std::string(property_name(assertion.kind)) + (model.empty() ? "" : " [" + model + "]") + "]");
        if (assertion.kind == AssertionKind::has_trace) {
            out_.text(": ");
            expression(assertion.implementation);
        }
    }
    if (assertion.tau_priority) {
        out_.text(" :[tau priority]: ");
        expression(assertion.tau_priority);
    }
    if (assertion.partial_order) out_.text(" :[partial order reduce]");
}

std::string print(const Script& script) {
    Layout layout(110);
    Printer(layout).script(script);
    return layout.render();
}

std::string print(const Decl& decl) {
    Layout layout(110);
    Printer(layout).declaration(decl);
    return layout.render();
}

}  // namespace robochart::cspm
