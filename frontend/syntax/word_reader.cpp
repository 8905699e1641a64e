// SPDX-License-Identifier: Apache-2.0
#include "frontend/syntax/word_reader.hpp"

#include <fmt/format.h>

#include "base/diagnostics/spelling.hpp"
#include "base/diagnostics/text.hpp"
#include "frontend/syntax/foreign_words.hpp"

namespace robochart::frontend {

namespace {

std::string quoted_token(const Token& token) {
    return token.kind == TokenKind::end ? "the end of the file" : fmt::format("'{}'", shorten_token(token.text));
}

}  // namespace

WordReader::WordReader(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                       const diagnostics::Rule& syntax, diagnostics::Diagnostics& diagnostics,
                       std::span<const diagnostics::Advice> advice)
    : sources_(sources), syntax_(syntax), advice_(advice), diagnostics_(diagnostics) {
    const std::size_t before = diagnostics.error_count();
    stream_ = tokenize(sources, source, false, diagnostics);
    failed_ = diagnostics.error_count() > before || stream_.tokens.empty();
    last_ = {source, 0, 0};
}

bool WordReader::at_word(std::string_view word) const {
    const Token next = current_token();
    return next.kind != TokenKind::end && next.kind != TokenKind::string && next.text == word;
}

bool WordReader::at_number() const {
    const TokenKind kind = current_token().kind;
    return kind == TokenKind::integer || kind == TokenKind::real || at_word("-");
}

std::string WordReader::text_since(diagnostics::Span from) const {
    return diagnostics::on_one_line(sources_.source_text(from.source).substr(from.begin, last_.end - from.begin));
}

void WordReader::advance_token() {
    last_ = current_token().span;
    if (!at_end()) ++next_;
}

bool WordReader::take_word(std::string_view word) {
    if (failed_ || !at_word(word)) return false;
    advance_token();
    return true;
}

void WordReader::expect_word(std::string_view word) {
    if (!failed_ && !take_word(word)) fail_expecting(fmt::format("'{}'", word));
}

void WordReader::fail_expecting(std::string_view expected, const std::vector<std::string>& words) {
    if (failed_) return;
    failed_ = true;
    diagnostics::Diagnostic& finding =
        diagnostics_.report(syntax_, current_token().span, {std::string(expected), quoted_token(current_token())});
    const std::string written(current_token().text);
    if (const std::string meant = diagnostics::nearest_spelling(written, words); !meant.empty() && meant != written)
        finding.fixes.push_back({current_token().span, meant,
                                 diagnostics::suggestion_verb(diagnostics::is_certain(written, meant, words))});
    const std::string_view advice = diagnostics::advice_on(advice_, expected, [this](std::ptrdiff_t ahead) {
        return advice_word(stream_.tokens, static_cast<std::ptrdiff_t>(next_) + ahead);
    });
    if (!advice.empty()) finding.notes.push_back({{}, std::string(advice)});
    if (!at_end()) return;
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < next_; ++i) {
        const Token token = stream_.tokens.token_at(i);
        if (token.is_word("{")) open.push_back(i);
        if (token.is_word("}") && !open.empty()) open.pop_back();
    }
    if (!open.empty()) finding.notes.push_back({stream_.tokens.token_at(open.back()).span, "this '{' is not closed"});
}

diagnostics::Diagnostic* WordReader::report(const diagnostics::Rule& rule, diagnostics::Span span,
                                            std::vector<std::string> arguments) {
    return failed_ ? nullptr : &diagnostics_.report(rule, span, std::move(arguments));
}

Word WordReader::name(std::string_view what) {
    const Token next = current_token();
    if (next.kind != TokenKind::identifier && next.kind != TokenKind::keyword) fail_expecting(what);
    if (failed_) return {};
    advance_token();
    return {std::string(next.text), next.span};
}

Word WordReader::qualified_name(std::string_view what) {
    Word result = name(what);
    while (take_word("::")) {
        const Word part = name(what);
        result.text += "::" + part.text;
        result.span = diagnostics::join_spans(result.span, part.span);
    }
    return result;
}

std::string WordReader::read_quoted(std::string_view what) {
    const Token next = current_token();
    if (next.kind != TokenKind::string) fail_expecting(what);
    if (failed_) return "";
    advance_token();
    return std::string(next.text.substr(1, next.text.size() - 2));
}

}  // namespace robochart::frontend
