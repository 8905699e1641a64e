// SPDX-License-Identifier: Apache-2.0
// Parses files, packages, imports, types, functions, interfaces and platforms (RoboChart.xtext: RCPackage to
// RoboticPlatform).
#include <fmt/format.h>

#include <algorithm>

#include "frontend/syntax/parser.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::frontend {

void Parser::package_clause(File& file) {
    if (!accept_token("package")) return;
    file.package = qualified_name("the package's name");
    pass_separator("nothing ends the package clause");
}

void Parser::parse_import(File& file) {
    Import import;
    import.span = expect_token("import");
    import.name = qualified_name("the name of a package");
    if (at_token("::")) {
        advance_token();
        expect_token("*");
        import.wildcard = true;
    }
    import.span = span_since(import.span);
    pass_separator("nothing ends an import");
    file.imports.push_back(std::move(import));
}

void Parser::parse_diagram(File& file) {
    expect_token("diagram");
    file.diagrams.push_back(simple_name("the diagram's name").text());
}

/// Parses one member of a file. After a mistake, skips to the next declaration.
void Parser::top_level(File& file) {
    const std::size_t start = at_;
    const bool orphan = at_token("}") || (at_member_word() && !at_token("stm") && !at_token("operation") &&
                                          !at_token("controller") && !at_token("robotic"));
    // If a body was closed too early, its remaining members are reported as one mistake.
    if (orphan && orphans_) quiet_until_ = std::max(quiet_until_, at_ + 1);
    orphans_ = orphan;
    const bool read = catch_syntax_error([&] {
        if (at_token("import")) return parse_import(file);
        if (at_token("diagram")) return parse_diagram(file);
        if (at_token("package")) {
            report(syntax::late_package, peek().span);
            advance_token();
            qualified_name("the package's name");
            return;
        }
        if (neural_construct()) return;
        if (auto declared = note_failures([&] { return parse_declaration(); }))
            file.declarations.push_back(std::move(declared));
    });
    if (read || take_correction()) return mark_lost_names(start, at_);
    if (at_ == start && !at_token("{")) advance_token();
    while (!at_end() && !at_member_word() && !at_top_level_word()) {
        if (at_token("{"))
            skip_balanced();
        else
            advance_token();
    }
    mark_lost_names(start, at_);
}

std::unique_ptr<Declaration> Parser::parse_declaration() {
    if (at_token("interface")) return parse_interface();
    if (at_token("robotic")) return parse_platform();
    if (at_token("controller")) return parse_controller();
    if (at_token("stm")) return parse_machine();
    if (at_token("operation")) return parse_operation();
    if (at_token("function")) return parse_function();
    if (at_token("module")) return parse_module();
    if (at_token("}")) report_and_throw(syntax::stray_bracket, peek().span);
    return type_declaration();
}

std::unique_ptr<Declaration> Parser::type_declaration() {
    if (at_token("datatype") || at_token("record")) return record_type();
    if (at_token("enumeration")) return parse_enumeration();
    if (!at_token("type")) wrong_word("a declaration", {ForeignPlace::declaration});
    auto type = std::make_unique<TypeDeclaration>(DeclKind::primitive_type);
    type->span = expect_token("type");
    name(*type);
    type->span = span_since(type->span);
    return type;
}

std::unique_ptr<Declaration> Parser::record_type() {
    auto type = std::make_unique<TypeDeclaration>(DeclKind::record_type);
    type->record_keyword = at_token("record");
    type->span = advance_token().span;
    name(*type);
    const auto field = [&] {
        parse_variable(type->fields, DeclKind::field);
        pass_separator("separate the fields of a type with a space");
    };
    catch_syntax_error([&] { parse_braces(field, 0); });
    type->span = span_since(type->span);
    return type;
}

std::unique_ptr<Declaration> Parser::parse_enumeration() {
    auto type = std::make_unique<TypeDeclaration>(DeclKind::enumeration);
    type->span = expect_token("enumeration");
    name(*type);
    const auto literal = [&] {
        auto entry = std::make_unique<EnumLiteral>();
        entry->span = peek().span;
        name(*entry);
        if (accept_token("(")) {
            do entry->arguments.push_back(this->parse_type());
            while (accept_token(","));
            expect_token(")");
        }
        entry->span = span_since(entry->span);
        type->literals.push_back(std::move(entry));
        pass_separator("separate the literals of an enumeration with a space");
    };
    catch_syntax_error([&] { parse_braces(literal, 0); });
    type->span = span_since(type->span);
    return type;
}

/// Skips a superfluous separator, as in `{ NEAR, FAR }` and `package p;`.
void Parser::pass_separator(std::string_view reason) {
    if (at_token(",") || at_token(";")) pass_superfluous(reason);
}

/// Parses `( p:T, … )`.
std::vector<VariablePtr> Parser::parse_parameters() {
    std::vector<VariablePtr> list;
    expect_token("(");
    if (!at_token(")")) {
        do parse_variable(list, DeclKind::parameter);
        while (accept_token(",") || missing_comma());
    }
    expect_token(")");
    return list;
}

/// Parses `v:T`, with `= e` for variables and constants. The variable is declared even if its type cannot be parsed.
void Parser::parse_variable(std::vector<VariablePtr>& list, DeclKind kind) {
    auto owned = std::make_unique<Variable>(kind);
    Variable& variable = *owned;
    variable.span = peek().span;
    name(variable);
    list.push_back(std::move(owned));
    type_before_name(variable);
    if (at_token("=") || at_token(")") || at_token(",")) fail_expecting("`:` and a type");
    expect_token(":");
    variable.type_expr = parse_type();
    const bool may_have_value = kind == DeclKind::variable || kind == DeclKind::constant;
    const bool like_pascal = at_token(":") && peek(1).is_word("=");
    if (may_have_value && ((like_pascal && repair_assignment()) || accept_token("=")))
        variable.initial = parse_expression();
    variable.span = span_since(variable.span);
}

/// Reports `var nat x` and reads it as `var x : nat`.
void Parser::type_before_name(Variable& variable) {
    const Token name = peek();
    const bool swapped = name.kind == TokenKind::identifier && !name.first_on_line && names_core_type(variable.name);
    if (!swapped) return;
    const Span span = diagnostics::join_spans(variable.name_span, name.span);
    const std::string own = fmt::format("{} : {}", name.text, variable.name);
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, span,
               {fmt::format("{} {}", variable.name, name.text), "the type is written after the name and a `:`"});
    if (finding != nullptr) finding->fixes.push_back({span, own, "write"});
    lost_names_.emplace_back(name.text);
    throw SyntaxError{};
}

std::unique_ptr<Declaration> Parser::parse_function() {
    auto function = std::make_unique<Function>();
    function->span = expect_token("function");
    name(*function);
    const auto member = [&] {
        if (accept_token("precondition")) return function->preconditions.push_back(parse_expression());
        if (accept_token("postcondition")) return function->postconditions.push_back(parse_expression());
        fail_expecting("`precondition`, `postcondition` or `}`");
    };
    catch_syntax_error([&] {
        function->parameters = parse_parameters();
        expect_token(":");
        function->result_expr = parse_type();
        parse_braces(member, contract_members);
    });
    function->span = span_since(function->span);
    return function;
}

std::unique_ptr<Declaration> Parser::parse_interface() {
    auto interface = std::make_unique<Context>(DeclKind::interface);
    interface->dialect = dialect_;
    interface->span = expect_token("interface");
    name(*interface);
    const auto member = [&] {
        const bool clause = at_token("uses") || at_token("requires") || at_token("provides");
        if (clause || !context_member(*interface))
            wrong_word("an operation, event, variable, constant or clock", {ForeignPlace::member});
    };
    catch_syntax_error([&] { parse_braces(member, context_members); });
    interface->span = span_since(interface->span);
    return interface;
}

std::unique_ptr<Context> Parser::parse_platform() {
    auto platform = std::make_unique<Context>(DeclKind::platform);
    platform->dialect = dialect_;
    platform->span = expect_token("robotic");
    expect_token("platform");
    name(*platform);
    const auto member = [&] {
        if (!context_member(*platform)) wrong_word("a member of a robotic platform", {ForeignPlace::member});
    };
    catch_syntax_error([&] { parse_braces(member, context_members); });
    platform->span = span_since(platform->span);
    return platform;
}

}  // namespace robochart::frontend
