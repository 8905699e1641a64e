// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "checker/cspm/syntax/levels.hpp"
#include "checker/cspm/syntax/printer.hpp"
#include "checker/cspm/syntax/reader.hpp"

namespace robochart::cspm {

namespace {

std::string on_one_line(const ExprPtr& expr) {
    Layout layout(1U << 30U);
    Printer(layout).print_expression(expr);
    std::string result = layout.render();
    std::ranges::replace(result, '\n', ' ');
    return result;
}

}  // namespace

void Printer::print_script(const Script& script) {
    print_declarations(script.decls);
    out_.break_line();
}

void Printer::print_declarations(const std::vector<DeclPtr>& decls) {
    bool first = true;
    for (const DeclPtr& decl : decls) {
        if (!first) out_.break_line();
        if (!first && !decl->comment.empty()) out_.break_line();
        first = false;
        print_comment(decl->comment);
        print_declaration(*decl);
    }
}

void Printer::print_comment(const std::string& text) {
    std::size_t from = 0;
    while (from < text.size()) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        out_.add_text("-- " + text.substr(from, end - from));
        out_.break_line();
        from = end + 1;
    }
}

void Printer::print_names(const std::vector<std::string>& names) {
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) {
            out_.add_text(",");
            out_.space_or_line();
        }
        out_.add_text(names[i]);
    }
}

void Printer::print_declaration(const Decl& decl) {
    out_.open_group();
    out_.indent();
    switch (decl.kind) {
        case DeclKind::function:
        case DeclKind::value:
            print_definition(decl);
            break;
        case DeclKind::channel:
            out_.add_text("channel ");
            print_names(decl.names);
            if (decl.body) {
                out_.add_text(" : ");
                print_expression(decl.body);
            }
            break;
        case DeclKind::datatype:
        case DeclKind::subtype:
            print_datatype(decl);
            break;
        case DeclKind::nametype:
            out_.add_text("nametype " + decl.names.at(0) + " = ");
            print_expression(decl.body);
            break;
        case DeclKind::module:
            print_module(decl);
            break;
        case DeclKind::instance:
            out_.add_text("instance " + decl.names.at(0) + " = " + decl.text);
            if (!decl.arguments.empty()) print_list("(", decl.arguments, ")");
            break;
        case DeclKind::timed:
            out_.add_text("Timed");
            if (decl.body) {
                out_.add_text("(");
                print_expression(decl.body);
                out_.add_text(")");
            }
            out_.add_text(" {");
            print_block(decl.decls);
            out_.outdent();
            out_.break_line();
            out_.add_text("}");
            out_.indent();
            break;
        case DeclKind::transparent:
        case DeclKind::external:
            out_.add_text(decl.kind == DeclKind::transparent ? "transparent " : "external ");
            print_names(decl.names);
            break;
        case DeclKind::annotation:
            print_names(decl.names);
            out_.add_text(" :: " + decl.text);
            break;
        case DeclKind::print:
            out_.add_text("print " + on_one_line(decl.body));  // FDR reads the rest of the line after `print`
            break;
        case DeclKind::assertion:
            print_assertion(decl.assertion);
            break;
        case DeclKind::include:
            out_.add_text("include \"" + decl.names.at(0) + "\"");
            break;
    }
    out_.outdent();
    out_.close_group();
}

void Printer::print_definition(const Decl& decl) {
    if (decl.kind == DeclKind::function) {
        out_.add_text(decl.names.at(0));
        for (const auto& group : decl.patterns) print_patterns("(", group, ")");
    } else {
        print_pattern(*decl.patterns.at(0).at(0));
    }
    out_.add_text(" =");
    if (strip_parentheses(decl.body).kind == ExprKind::let)
        out_.break_line();
    else
        out_.space_or_line();
    print_expression(decl.body);
}

void Printer::print_datatype(const Decl& decl) {
    out_.add_text((decl.kind == DeclKind::datatype ? "datatype " : "subtype ") + decl.names.at(0) + " =");
    bool first = true;
    for (const Constructor& constructor : decl.constructors) {
        out_.space_or_line();
        if (!first) out_.add_text("| ");
        first = false;
        out_.add_text(constructor.name);
        if (!constructor.fields) continue;
        out_.add_text(".");
        print_expression(constructor.fields,
                         strip_parentheses(constructor.fields).kind == ExprKind::dot ? dot_level_expr : postfix_level);
    }
}

void Printer::print_block(const std::vector<DeclPtr>& decls) {
    if (decls.empty()) return;
    out_.break_line();
    print_declarations(decls);
}

// Prints a module. Its keywords move one level to the left, because the group of the declaration is indented.
void Printer::print_module(const Decl& decl) {
    out_.add_text("module " + decl.names.at(0));
    if (!decl.parameters.empty()) {
        out_.add_text("(");
        print_names(decl.parameters);
        out_.add_text(")");
    }
    print_block(decl.decls);
    out_.outdent();
    out_.break_line();
    out_.add_text("exports");
    out_.indent();
    print_block(decl.exports);
    out_.outdent();
    out_.break_line();
    out_.add_text("endmodule");
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
        case AssertionKind::refinement:
        case AssertionKind::has_trace:
            break;
    }
    return "has trace";
}

}  // namespace

void Printer::print_assertion(const Assertion& assertion) {
    out_.add_text(assertion.negated ? "assert not " : "assert ");
    // Without parentheses, `not` would negate the assertion.
    const bool ambiguous = !assertion.negated && on_one_line(assertion.specification).starts_with("not ");
    print_expression(assertion.specification, ambiguous ? atom_level : lowest_level);
    const std::string model(model_name(assertion.model));
    if (assertion.kind == AssertionKind::refinement) {
        out_.space_or_line();
        out_.add_text("[" + model + "= ");
        print_expression(assertion.implementation);
    } else {
        out_.add_text(" :[" + std::string(property_name(assertion.kind)) + (model.empty() ? "" : " [" + model + "]") +
                      "]");
        if (assertion.kind == AssertionKind::has_trace) {
            out_.add_text(": ");
            print_expression(assertion.implementation);
        }
    }
    if (assertion.tau_priority) {
        out_.add_text(" :[tau priority]: ");
        print_expression(assertion.tau_priority);
    }
    if (assertion.partial_order) out_.add_text(" :[partial order reduce]");
}

std::string print(const Script& script) {
    Layout layout(110);
    Printer(layout).print_script(script);
    return layout.render();
}

std::string print(const Decl& decl) {
    Layout layout(110);
    Printer(layout).print_declaration(decl);
    return layout.render();
}

}  // namespace robochart::cspm
