// SPDX-License-Identifier: Apache-2.0
#include "frontend/syntax/word_reader.hpp"

#include <fmt/format.h>

#include "base/diagnostics/spelling.hpp"
#include "base/diagnostics/text.hpp"
#include "frontend/syntax/foreign_words.hpp"

namespace robochart::frontend {

namespace {

std::string quoted_token(const Token& token) {
    return token.kind == TokenKind::end ? "the end of the file" : fmt::format("'{}'", shorten(token.text));
}

}  // namespace

WordReader::WordReader(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                       const diagnostics::Rule& syntax, diagnostics::Diagnostics& diagnostics,
                       std::span<const diagnostics::Advice> advice)
    : sources_(sources), syntax_(syntax), advice_(advice), diagnostics_(diagnostics) {
    const std::size_t before = diagnostics.errors();
    stream_ = tokenize(sources, source, false, diagnostics);
    failed_ = diagnostics.errors() > before || stream_.tokens.empty();
    last_ = {source, 0, 0};
}

bool WordReader::at(std::string_view word) const {
    const Token next = token();
    return next.kind != TokenKind::end && next.kind != TokenKind::string && next.text == word;
}

bool WordReader::at_number() const {
    const TokenKind kind = token().kind;
    return kind == TokenKind::integer || kind == TokenKind::real || at("-");
}

std::string WordReader::text_since(diagnostics::Span from) const {
    return diagnostics::on_one_line(sources_.text(from.source).substr(from.begin, last_.end - from.begin));
}

void WordReader::advance() {
    last_ = token().span;
    if (!at_end()) ++next_;
}

bool WordReader::take(std::string_view word) {
    if (failed_ || !at(word)) return false;
    advance();
    return true;
}

void WordReader::expect(std::string_view word) {
    if (!failed_ && !take(word)) fail(fmt::format("'{}'", word));
}

void WordReader::fail(std::string_view expected, const std::vector<std::string>& words) {
    if (failed_) return;
    failed_ = true;
    diagnostics::Diagnostic& finding =
        diagnostics_.report(syntax_, token().span, {std::string(expected), quoted_token(token())});
    const std::string written(token().text);
    if (const std::string meant = diagnostics::nearest(written, words); !meant.empty() && meant != written)
        finding.fixes.push_back(
            {token().span, meant, diagnostics::suggested(diagnostics::is_certain(written, meant, words))});
    const std::string_view advice = diagnostics::advice_on(advice_, expected, [this](std::ptrdiff_t ahead) {
        return advice_word(stream_.tokens, static_cast<std::ptrdiff_t>(next_) + ahead);
    });
    if (!advice.empty()) finding.notes.push_back({{}, std::string(advice)});
    if (!at_end()) return;
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < next_; ++i) {
        const Token each = stream_.tokens.at(i);
        if (each.is("{")) open.push_back(i);
        if (each.is("}") && !open.empty()) open.pop_back();
    }
    if (!open.empty()) finding.notes.push_back({stream_.tokens.at(open.back()).span, "this '{' is not closed"});
}

diagnostics::Diagnostic* WordReader::report(const diagnostics::Rule& rule, diagnostics::Span span,
                                            std::vector<std::string> arguments) {
    return failed_ ? nullptr : &diagnostics_.report(rule, span, std::move(arguments));
}

Word WordReader::name(std::string_view what) {
    const Token next = token();
    if (next.kind != TokenKind::identifier && next.kind != TokenKind::keyword) fail(what);
    if (failed_) return {};
    advance();
    return {std::string(next.text), next.span};
}

Word WordReader::qualified_name(std::string_view what) {
    Word result = name(what);
    while (take("::")) {
        const Word part = name(what);
        result.text += "::" + part.text;
        result.span = diagnostics::join(result.span, part.span);
    }
    return result;
}

std::string WordReader::quoted(std::string_view what) {
    const Token next = token();
    if (next.kind != TokenKind::string) fail(what);
    if (failed_) return "";
    advance();
    return std::string(next.text.substr(1, next.text.size() - 2));
}

}  // namespace robochart::frontend
