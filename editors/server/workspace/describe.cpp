// SPDX-License-Identifier: Apache-2.0
// Prints heads of declarations and finds the comments above them.
#include "editors/server/workspace/describe.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/syntax/print.hpp"
#include "frontend/types/types.hpp"

namespace robochart::lsp {

namespace {

using namespace frontend;

std::string type_text(const TypeExprPtr& written, const TypePtr& type) {
    if (written) return to_text(*written);
    return type ? to_string(type) : std::string();
}

std::string name_with_type(const Variable& variable) {
    const std::string type = type_text(variable.type_expr, variable.type);
    return type.empty() ? variable.name : fmt::format("{} : {}", variable.name, type);
}

std::string parameter_list(const std::vector<VariablePtr>& parameters) {
    std::string out;
    for (const VariablePtr& parameter : parameters) out += (out.empty() ? "" : ", ") + name_with_type(*parameter);
    return "(" + out + ")";
}

std::string variable_text(const Variable& variable) {
    std::string out = name_with_type(variable);
    if (variable.initial) out += " = " + to_text(*variable.initial);
    if (variable.kind == DeclKind::variable) return "var " + out;
    return variable.kind == DeclKind::constant ? "const " + out : out;
}

std::string literal_text(const EnumLiteral& literal) {
    std::string arguments;
    for (const TypeExprPtr& argument : literal.arguments)
        arguments += (arguments.empty() ? "" : ", ") + to_text(*argument);
    const std::string owner = literal.parent != nullptr ? literal.parent->name + "::" : "";
    return owner + literal.name + (arguments.empty() ? "" : "(" + arguments + ")");
}

std::string type_declaration(const TypeDeclaration& type) {
    if (type.kind == DeclKind::primitive_type) return "type " + type.name;
    std::string members;
    for (const VariablePtr& field : type.fields) members += "\n    " + name_with_type(*field);
    for (const auto& literal : type.literals) members += " " + literal->name;
    const bool record = type.kind == DeclKind::record_type;
    return fmt::format("{} {} {{{}{}}}", record ? "datatype" : "enumeration", type.name, members, record ? "\n" : " ");
}

std::string transition_text(const Transition& transition) {
    std::string out =
        fmt::format("transition {} {{ from {} to {}", transition.name, transition.from.text(), transition.to.text());
    if (transition.trigger) out += " trigger " + to_text(*transition.trigger);
    if (transition.condition) out += " condition " + to_text(*transition.condition);
    if (transition.action) out += " action " + to_text(*transition.action);
    return out + " }";
}

std::string reference_text(const Reference& reference) {
    return fmt::format("{} {} = {}", reference_word(reference.refers_to), reference.name, reference.target_name.text());
}

/// Returns the keyword that begins the declaration.
std::string_view keyword_of(DeclKind kind) {
    if (kind == DeclKind::state_machine) return "stm";
    if (kind == DeclKind::platform) return "robotic platform";
    const std::string_view words = to_text(kind);
    return words.substr(0, words.find(' '));
}

}  // namespace

std::string signature_text(const Declaration& declaration) {
    if (const auto* v = dynamic_cast<const Variable*>(&declaration)) return variable_text(*v);
    if (const auto* l = dynamic_cast<const EnumLiteral*>(&declaration)) return literal_text(*l);
    if (const auto* t = dynamic_cast<const TypeDeclaration*>(&declaration)) return type_declaration(*t);
    if (const auto* t = dynamic_cast<const Transition*>(&declaration)) return transition_text(*t);
    if (const auto* r = dynamic_cast<const Reference*>(&declaration)) return reference_text(*r);
    if (const auto* s = dynamic_cast<const OperationSignature*>(&declaration))
        return s->name + parameter_list(s->parameters) + (s->terminates ? " [terminates]" : "");
    if (const auto* f = dynamic_cast<const Function*>(&declaration))
        return fmt::format("function {}{} : {}", f->name, parameter_list(f->parameters),
                           type_text(f->result_expr, f->result));
    if (const auto* e = dynamic_cast<const Event*>(&declaration)) {
        const std::string type = type_text(e->type_expr, e->type);
        return fmt::format("{}event {}{}{}", e->broadcast ? "_broadcast " : "", e->name, type.empty() ? "" : " : ",
                           type);
    }
    const auto* machine = dynamic_cast<const Machine*>(&declaration);
    const bool operation = machine != nullptr && machine->kind == DeclKind::operation;
    return fmt::format("{} {}{}", keyword_of(declaration.kind), declaration.name,
                       operation ? parameter_list(machine->parameters) : "");
}

std::string detail_of(const Declaration& declaration) {
    if (const auto* v = dynamic_cast<const Variable*>(&declaration)) return type_text(v->type_expr, v->type);
    if (const auto* e = dynamic_cast<const Event*>(&declaration)) return type_text(e->type_expr, e->type);
    if (const auto* r = dynamic_cast<const Reference*>(&declaration)) return "= " + r->target_name.text();
    if (const auto* t = dynamic_cast<const Transition*>(&declaration))
        return fmt::format("{} → {}", t->from.text(), t->to.text());
    if (const auto* l = dynamic_cast<const EnumLiteral*>(&declaration))
        return l->parent != nullptr ? l->parent->name : std::string();
    if (dynamic_cast<const OperationSignature*>(&declaration) != nullptr || declaration.kind == DeclKind::function ||
        declaration.kind == DeclKind::operation)
        return signature_text(declaration);
    return std::string(to_text(declaration.kind));
}

std::string parent_text(const Declaration& declaration) {
    const Declaration* parent = declaration.parent;
    if (parent == nullptr || parent->name.empty()) return {};
    return fmt::format("in {} `{}`", to_text(parent->kind), parent->name);
}

// ---------------------------------------------------------------- comments

namespace {

std::string_view trim_text(std::string_view text) {
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
    while (!text.empty() && blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && blank(text.back())) text.remove_suffix(1);
    return text;
}

/// Returns the text of a comment, without comment marks and the stars of a boxed comment.
std::string words_of(std::string_view comment) {
    if (comment.starts_with("//")) return std::string(trim_text(comment.substr(2)));
    comment.remove_prefix(std::min<std::size_t>(2, comment.size()));
    if (comment.ends_with("*/")) comment.remove_suffix(2);
    std::string out;
    while (!comment.empty()) {
        const std::size_t end = std::min(comment.find('\n'), comment.size());
        std::string_view line = trim_text(comment.substr(0, end));
        while (line.starts_with("*")) line = trim_text(line.substr(1));
        if (!out.empty() || !line.empty()) out += std::string(line) + "\n";
        comment.remove_prefix(std::min(end + 1, comment.size()));
    }
    return std::string(trim_text(out));
}

bool ends_its_line(const SourceManager& sources, Span span) {
    const std::string_view rest = sources.source_text(span.source).substr(span.end);
    return trim_text(rest.substr(0, rest.find_first_of("\r\n"))).empty();
}

bool begins_its_line(const SourceManager& sources, Span span) {
    const std::string_view text = sources.source_text(span.source);
    std::size_t at = span.begin;
    while (at > 0 && (text[at - 1] == ' ' || text[at - 1] == '\t')) --at;
    return at == 0 || text[at - 1] == '\n' || text[at - 1] == '\r';
}

}  // namespace

std::string comment_about(const SourceManager& sources, const File& file, Span name) {
    const auto line_of = [&](std::uint32_t offset) { return sources.position(file.source, offset).line; };
    const std::uint32_t line = line_of(name.begin);
    std::string above;
    std::string behind;
    std::uint32_t line_below = line;
    for (auto comment = file.comments.rbegin(); comment != file.comments.rend(); ++comment) {
        const std::string_view text =
            sources.source_text(file.source).substr(comment->begin, comment->end - comment->begin);
        if (comment->begin >= name.end && line_of(comment->begin) == line && ends_its_line(sources, *comment))
            behind = words_of(text);
        if (comment->end > name.begin || line_of(comment->end) + 1 != line_below || !begins_its_line(sources, *comment))
            continue;
        above = words_of(text) + (above.empty() ? "" : "\n" + above);
        if (!text.starts_with("//")) break;
        line_below = line_of(comment->begin);
    }
    return above.empty() ? behind : above;
}

// ---------------------------------------------------------------- kinds

namespace {

struct KindRow {
    DeclKind kind;
    int symbol;
    int completion;
};

// SymbolKind, CompletionItemKind
constexpr KindRow kinds[] = {
    {DeclKind::package, 4, 9},         {DeclKind::primitive_type, 26, 25},    {DeclKind::record_type, 23, 22},
    {DeclKind::field, 8, 5},           {DeclKind::enumeration, 10, 13},       {DeclKind::enum_literal, 22, 20},
    {DeclKind::function, 12, 3},       {DeclKind::operation_signature, 6, 2}, {DeclKind::parameter, 13, 6},
    {DeclKind::variable, 13, 6},       {DeclKind::constant, 14, 21},          {DeclKind::event, 24, 23},
    {DeclKind::clock, 7, 10},          {DeclKind::interface, 11, 8},          {DeclKind::platform, 19, 7},
    {DeclKind::operation, 6, 2},       {DeclKind::state_machine, 5, 7},       {DeclKind::controller, 5, 7},
    {DeclKind::module, 2, 9},          {DeclKind::reference, 20, 18},         {DeclKind::connection, 20, 18},
    {DeclKind::state, 3, 12},          {DeclKind::initial, 19, 12},           {DeclKind::final, 19, 12},
    {DeclKind::junction, 19, 12},      {DeclKind::probabilistic, 19, 12},     {DeclKind::transition, 25, 24},
    {DeclKind::bound_variable, 13, 6},
};

const KindRow& row_of(DeclKind kind) {
    for (const KindRow& row : kinds)
        if (row.kind == kind) return row;
    return kinds[0];
}

}  // namespace

int symbol_kind(const Declaration& declaration) {
    return row_of(declaration.kind).symbol;
}

int completion_kind(const Declaration& declaration) {
    return row_of(declaration.kind).completion;
}

}  // namespace robochart::lsp
