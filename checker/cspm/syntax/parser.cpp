// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/syntax/parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/diagnostics/spelling.hpp"
#include "checker/cspm/syntax/advice.hpp"
#include "checker/cspm/syntax/rules.hpp"

namespace robochart::cspm {

const Token& Parser::peek(std::size_t ahead) const {
    return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
}

const Token& Parser::take_token() {
    const Token& token = peek();
    if (at_ + 1 < tokens_.size()) ++at_;
    return token;
}

bool Parser::accept(Tok kind) {
    if (!at_token(kind)) return false;
    take_token();
    return true;
}

namespace {
std::string describe_token(Tok kind) {
    const std::string text(spelling(kind));
    const bool spelt = kind > Tok::include || kind == Tok::print || kind == Tok::include;
    return spelt ? "'" + text + "'" : text;
}

/// Returns the word that the user probably misspelt: the expected word, or the keyword of a declaration. Returns "" if
/// no such word is similar to the text.
std::string meant_word(std::string_view expected, const Token& found, const Token* before) {
    if (found.kind == Tok::identifier && expected.size() > 3 && expected.front() == '\'') {
        const std::string word(expected.substr(1, expected.size() - 2));
        if (const std::string near = diagnostics::nearest_spelling(found.text, {word}); !near.empty()) return near;
    }
    if (expected != "'='" || before == nullptr || before->kind != Tok::identifier) return "";
    return diagnostics::nearest_spelling(before->text, {"assert", "channel", "datatype", "external", "include",
                                                        "instance", "module", "nametype", "subtype", "transparent"});
}

diagnostics::AdviceWord advice_word(const Token& token) {
    using enum diagnostics::WordKind;
    switch (token.kind) {
        case Tok::identifier:
            return {name, token.text};
        case Tok::integer:
            return {number, token.text};
        case Tok::string:
            return {text, token.text};
        case Tok::newline:
        case Tok::end:
            return {end, {}};
        default:
            return {other, token.text};
    }
}

}  // namespace

const Token& Parser::expect(Tok kind) {
    if (!at_token(kind)) fail(describe_token(kind));
    return take_token();
}

void Parser::fail(std::string_view expected) {
    const Token& found = peek();
    std::string what = describe_token(found.kind);
    if (found.kind == Tok::identifier) what = "'" + std::string(found.text.substr(0, 60)) + "'";
    diagnostics::Diagnostic& finding =
        diagnostics_.report(rules::unexpected_token, found.span, {std::string(expected), what});
    const Token* const before = at_ > 0 ? &tokens_[at_ - 1] : nullptr;
    if (const std::string meant = meant_word(expected, found, before); !meant.empty())
        finding.notes.push_back({found.span, "did you mean '" + meant + "'?"});
    const auto word = [&](std::ptrdiff_t ahead) -> diagnostics::AdviceWord {
        const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(at_) + ahead;
        if (at < 0 || at >= std::ssize(tokens_)) return {diagnostics::WordKind::end, {}};
        return advice_word(tokens_[static_cast<std::size_t>(at)]);
    };
    if (const std::string_view advice = diagnostics::advice_on(all_advice(), expected, word); !advice.empty())
        finding.notes.push_back({found.span, std::string(advice)});
    if (found.kind == Tok::newline || found.kind == Tok::end)
        if (const Token* const open = open_bracket(expected))
            finding.notes.push_back({open->span, fmt::format("this {} is not closed", describe_token(open->kind))});
    throw SyntaxError{};
}

const Token* Parser::open_bracket(std::string_view expected) const {
    constexpr std::array<std::pair<Tok, Tok>, 4> brackets{{{Tok::l_paren, Tok::r_paren},
                                                           {Tok::l_brace, Tok::r_brace},
                                                           {Tok::l_pipe_brace, Tok::r_pipe_brace},
                                                           {Tok::l_map, Tok::r_map}}};
    for (const auto& [opening, closing] : brackets) {
        if (expected != describe_token(closing)) continue;
        std::size_t closed = 0;
        for (std::size_t i = at_; i-- > 0;) {
            if (tokens_[i].kind == closing) ++closed;
            if (tokens_[i].kind == opening && closed-- == 0) return &tokens_[i];
        }
    }
    return nullptr;
}

void Parser::fail(std::string_view expected, std::string_view advice, Span about) {
    std::string what = describe_token(peek().kind);
    if (at_token(Tok::identifier)) what = "'" + std::string(peek().text.substr(0, 60)) + "'";
    diagnostics_.report(rules::unexpected_token, peek().span, {std::string(expected), what})
        .notes.push_back({about, std::string(advice)});
    throw SyntaxError{};
}

void Parser::fail(const diagnostics::Rule& rule, Span span, std::vector<std::string> arguments) {
    diagnostics_.report(rule, span, std::move(arguments));
    throw SyntaxError{};
}

Span Parser::span_since(Span from) const {
    const Span last = at_ > 0 ? tokens_[at_ - 1].span : from;
    return {from.source, from.begin, std::max(from.end, last.end)};
}

Parser::Depth::Depth(Parser& parser) : parser_(parser) {
    parser_.diagnostics_.poll();
    if (++parser_.depth_ <= max_depth) return;
    --parser_.depth_;
    parser_.fail(rules::too_deep, parser_.peek().span, {std::to_string(max_depth)});
}

// ---------------------------------------------------------------- nodes

// Returns the height of a tree. Every node was created by the parser as an ExprNode, so the cast below is safe.
unsigned Parser::height_of(const ExprPtr& expr) {
    return expr ? static_cast<const ExprNode&>(*expr).height : 0;
}
unsigned Parser::height_of(const Decl& decl) {
    return static_cast<const DeclNode&>(decl).height;
}

ExprPtr Parser::finish_node(ExprNode node, Span from) {
    node.span = span_since(from);
    unsigned tallest = 0;
    for (const ExprPtr& arg : node.args) tallest = std::max(tallest, height_of(arg));
    for (const Field& field : node.fields) tallest = std::max(tallest, height_of(field.value));
    for (const Clause& clause : node.clauses) tallest = std::max(tallest, height_of(clause.value));
    for (const Link& link : node.links) tallest = std::max({tallest, height_of(link.from), height_of(link.to)});
    for (const DeclPtr& decl : node.decls) tallest = std::max(tallest, height_of(*decl));
    node.height = tallest + 1;
    if (node.height > max_height) fail(rules::too_deep, node.span, {std::to_string(max_height)});
    return std::make_shared<const ExprNode>(std::move(node));
}

ExprPtr Parser::make_node(ExprKind kind, Span from, std::vector<ExprPtr> args) {
    ExprNode result;
    result.kind = kind;
    result.args = std::move(args);
    return finish_node(std::move(result), from);
}

DeclPtr Parser::finish_node(DeclNode decl, Span from) {
    decl.span = span_since(from);
    unsigned tallest = height_of(decl.body);
    for (const Constructor& constructor : decl.constructors) tallest = std::max(tallest, height_of(constructor.fields));
    for (const DeclPtr& inner : decl.decls) tallest = std::max(tallest, height_of(*inner));
    for (const DeclPtr& exported : decl.exports) tallest = std::max(tallest, height_of(*exported));
    for (const ExprPtr& argument : decl.arguments) tallest = std::max(tallest, height_of(argument));
    decl.height = tallest + 1;
    if (decl.height > max_height) fail(rules::too_deep, decl.span, {std::to_string(max_height)});
    return std::make_shared<const DeclNode>(std::move(decl));
}

std::string decode_string(std::string_view token) {
    std::string result;
    const std::string_view inner = token.substr(1, token.size() - 2);
    for (std::size_t i = 0; i < inner.size(); ++i) {
        char c = inner[i];
        if (c == '\\' && i + 1 < inner.size()) {
            c = inner[++i];
            if (c == 'n')
                c = '\n';
            else if (c == 't')
                c = '\t';
            else if (c == 'r')
                c = '\r';
        }
        result.push_back(c);
    }
    return result;
}

}  // namespace robochart::cspm
