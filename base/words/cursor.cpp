// SPDX-License-Identifier: Apache-2.0
// Moves through the list of tokens, and reports errors with advice.
#include "base/words/cursor.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/spelling.hpp"

namespace robochart::words {
namespace {

std::string found_text(const Token& token) {
    if (token.kind == Tok::end) return "the end of the text";
    return fmt::format("'{}'", diagnostics::escape_for_display(token.text.substr(0, 40)));
}

}  // namespace

void Cursor::enter_level() {
    if (depth_ >= most_levels_) {
        diagnostics_.report(findings_.too_deep, peek().span, {fmt::format("{}", most_levels_)});
        throw SyntaxError{};
    }
    ++depth_;
}

const Token& Cursor::peek(std::size_t ahead) const {
    return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
}

bool Cursor::is_at(std::string_view text, std::size_t ahead) const {
    const Token& token = peek(ahead);
    return token.kind != Tok::end && token.kind != Tok::number && token.text == text;
}

bool Cursor::at_name(std::size_t ahead) const {
    return peek(ahead).kind == Tok::word && use_of(peek(ahead).text) != WordUse::reserved;
}

const Token& Cursor::take_token() {
    const Token& token = peek();
    if (token.kind != Tok::end) ++at_;
    return token;
}

bool Cursor::accept(std::string_view text) {
    if (!is_at(text)) return false;
    take_token();
    return true;
}

diagnostics::Span Cursor::expect(std::string_view text) {
    if (!is_at(text)) fail(fmt::format("'{}'", text), {std::string(text)});
    return take_token().span;
}

Name Cursor::simple_name(std::string_view what) {
    if (!at_name()) fail(what);
    const Token& token = take_token();
    return {std::string(token.text), token.span};
}

Name Cursor::qualified_name(std::string_view what) {
    Name result = simple_name(what);
    while (is_at("::") && !is_at("*", 1)) {
        take_token();
        result.text += "::" + simple_name(what).text;
    }
    result.span = span_since(result.span);
    return result;
}

diagnostics::Span Cursor::span_since(diagnostics::Span from) const {
    return at_ == 0 ? from : diagnostics::join_spans(from, tokens_[at_ - 1].span);
}

diagnostics::AdviceWord Cursor::advice_word(std::ptrdiff_t ahead) const {
    using enum diagnostics::WordKind;
    const std::ptrdiff_t place = static_cast<std::ptrdiff_t>(at_) + ahead;
    if (place < 0 || place >= std::ssize(tokens_)) return {end, {}};
    const Token& token = tokens_[static_cast<std::size_t>(place)];
    if (token.kind == Tok::end) return {end, {}};
    if (token.kind == Tok::number) return {number, token.text};
    return {token.kind == Tok::word && use_of(token.text) == WordUse::name ? name : other, token.text};
}

void Cursor::fail(std::string_view expected, const Words& words) {
    const Token& token = peek();
    auto& finding =
        diagnostics_.report(findings_.unexpected_token, token.span, {std::string(expected), found_text(token)});
    const std::string written(token.text);
    const std::string meant = token.kind == Tok::word ? diagnostics::nearest_spelling(written, words) : "";
    if (!meant.empty() && meant != written)
        finding.fixes.push_back(
            {token.span, meant, diagnostics::suggestion_verb(diagnostics::is_certain(written, meant, words))});
    const std::string_view form =
        diagnostics::advice_on(advice_, expected, [this](std::ptrdiff_t ahead) { return advice_word(ahead); });
    if (!form.empty())
        finding.notes.push_back({{}, std::string(form)});
    else if (words.empty() && token.kind == Tok::word && use_of(token.text) == WordUse::reserved)
        finding.notes.push_back({{}, fmt::format("'{}' is a word of the language and cannot be a name", token.text)});
    throw SyntaxError{};
}

}  // namespace robochart::words
