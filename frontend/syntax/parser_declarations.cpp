// SPDX-License-Identifier: Apache-2.0
// Files, packages, imports, types, functions, interfaces, platforms (RoboChart.xtext: RCPackage to RoboticPlatform).
#include <fmt/format.h>

#include <algorithm>

#include "frontend/syntax/parser.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::frontend {

void Parser::package_clause(File& file) {
    if (!accept("package")) return;
    file.package = qualified_name("the package's name");
    pass_separator("nothing ends the package clause");
}

void Parser::import(File& file) {
    Import import;
    import.span = expect("import");
    import.name = qualified_name("the name of a package");
    if (at("::")) {
        advance();
        expect("*");
        import.wildcard = true;
    }
    import.span = since(import.span);
    pass_separator("nothing ends an import");
    file.imports.push_back(std::move(import));
}

void Parser::diagram(File& file) {
    expect("diagram");
    file.diagrams.push_back(simple_name("the diagram's name").text());
}

/// Parses one member of a file; after a mistake, skips to the next declaration.
void Parser::top_level(File& file) {
    const std::size_t start = at_;
    const bool orphan =
        at("}") || (at_member_word() && !at("stm") && !at("operation") && !at("controller") && !at("robotic"));
    // If a body was closed too early, its remaining members are reported as one mistake.
    if (orphan && orphans_) quiet_until_ = std::max(quiet_until_, at_ + 1);
    orphans_ = orphan;
    const bool read = guarded([&] {
        if (at("import")) return import(file);
        if (at("diagram")) return diagram(file);
        if (at("package")) {
            report(syntax::late_package, peek().span);
            advance();
            qualified_name("the package's name");
            return;
        }
        if (neural_construct()) return;
        if (auto declared = watched([&] { return declaration(); })) file.declarations.push_back(std::move(declared));
    });
    if (read || corrected()) return forget(start, at_);
    if (at_ == start && !at("{")) advance();
    while (!at_end() && !at_member_word() && !at_top_level_word()) {
        if (at("{"))
            skip_balanced();
        else
            advance();
    }
    forget(start, at_);
}

std::unique_ptr<Declaration> Parser::declaration() {
    if (at("interface")) return interface();
    if (at("robotic")) return platform();
    if (at("controller")) return controller();
    if (at("stm")) return machine();
    if (at("operation")) return operation();
    if (at("function")) return function();
    if (at("module")) return module();
    if (at("}")) fail(syntax::stray_bracket, peek().span);
    return type_declaration();
}

std::unique_ptr<Declaration> Parser::type_declaration() {
    if (at("datatype") || at("record")) return record_type();
    if (at("enumeration")) return enumeration();
    if (!at("type")) wrong_word("a declaration", {ForeignPlace::declaration});
    auto type = std::make_unique<TypeDeclaration>(DeclKind::primitive_type);
    type->span = expect("type");
    name(*type);
    type->span = since(type->span);
    return type;
}

std::unique_ptr<Declaration> Parser::record_type() {
    auto type = std::make_unique<TypeDeclaration>(DeclKind::record_type);
    type->record_keyword = at("record");
    type->span = advance().span;
    name(*type);
    const auto field = [&] {
        variable(type->fields, DeclKind::field);
        pass_separator("between the fields of a type stands a blank");
    };
    guarded([&] { braces(field, 0); });
    type->span = since(type->span);
    return type;
}

std::unique_ptr<Declaration> Parser::enumeration() {
    auto type = std::make_unique<TypeDeclaration>(DeclKind::enumeration);
    type->span = expect("enumeration");
    name(*type);
    const auto literal = [&] {
        auto entry = std::make_unique<EnumLiteral>();
        entry->span = peek().span;
        name(*entry);
        if (accept("(")) {
            do entry->arguments.push_back(this->type());
            while (accept(","));
            expect(")");
        }
        entry->span = since(entry->span);
        type->literals.push_back(std::move(entry));
        pass_separator("between the literals of an enumeration stands a blank");
    };
    guarded([&] { braces(literal, 0); });
    type->span = since(type->span);
    return type;
}

/// Skips a superfluous separator, as in `{ NEAR, FAR }` and `package p;`.
void Parser::pass_separator(std::string_view reason) {
    if (at(",") || at(";")) pass_superfluous(reason);
}

/// `( p:T, … )`
std::vector<VariablePtr> Parser::parameters() {
    std::vector<VariablePtr> list;
    expect("(");
    if (!at(")")) {
        do variable(list, DeclKind::parameter);
        while (accept(",") || missing_comma());
    }
    expect(")");
    return list;
}

/// `v:T`, and `= e` for variables and constants. The variable is declared even if its type cannot be parsed.
void Parser::variable(std::vector<VariablePtr>& list, DeclKind kind) {
    auto owned = std::make_unique<Variable>(kind);
    Variable& variable = *owned;
    variable.span = peek().span;
    name(variable);
    list.push_back(std::move(owned));
    type_before_name(variable);
    if (at("=") || at(")") || at(",")) expected("`:` and a type");
    expect(":");
    variable.type_expr = type();
    const bool may_have_value = kind == DeclKind::variable || kind == DeclKind::constant;
    const bool like_pascal = at(":") && peek(1).is("=");
    if (may_have_value && ((like_pascal && repair_assignment()) || accept("="))) variable.initial = expression();
    variable.span = since(variable.span);
}

/// `var nat x` is read as `var x : nat`.
void Parser::type_before_name(Variable& variable) {
    const Token name = peek();
    const bool swapped = name.kind == TokenKind::identifier && !name.first_on_line && names_core_type(variable.name);
    if (!swapped) return;
    const Span span = diagnostics::join(variable.name_span, name.span);
    const std::string own = fmt::format("{} : {}", name.text, variable.name);
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, span,
               {fmt::format("{} {}", variable.name, name.text), "the type stands behind the name and a `:`"});
    if (finding != nullptr) finding->fixes.push_back({span, own, "write"});
    lost_names_.emplace_back(name.text);
    throw SyntaxError{};
}

std::unique_ptr<Declaration> Parser::function() {
    auto function = std::make_unique<Function>();
    function->span = expect("function");
    name(*function);
    const auto member = [&] {
        if (accept("precondition")) return function->preconditions.push_back(expression());
        if (accept("postcondition")) return function->postconditions.push_back(expression());
        expected("`precondition`, `postcondition` or `}`");
    };
    guarded([&] {
        function->parameters = parameters();
        expect(":");
        function->result_expr = type();
        braces(member, contract_members);
    });
    function->span = since(function->span);
    return function;
}

std::unique_ptr<Declaration> Parser::interface() {
    auto interface = std::make_unique<Context>(DeclKind::interface);
    interface->span = expect("interface");
    name(*interface);
    const auto member = [&] {
        const bool clause = at("uses") || at("requires") || at("provides");
        if (clause || !context_member(*interface))
            wrong_word("an operation, event, variable, constant or clock", {ForeignPlace::member});
    };
    guarded([&] { braces(member, context_members); });
    interface->span = since(interface->span);
    return interface;
}

std::unique_ptr<Context> Parser::platform() {
    auto platform = std::make_unique<Context>(DeclKind::platform);
    platform->span = expect("robotic");
    expect("platform");
    name(*platform);
    const auto member = [&] {
        if (!context_member(*platform)) wrong_word("a member of a robotic platform", {ForeignPlace::member});
    };
    guarded([&] { braces(member, context_members); });
    platform->span = since(platform->span);
    return platform;
}

}  // namespace robochart::frontend
