// SPDX-License-Identifier: Apache-2.0
// Reads the tokens of a text one after the other. Scenarios and mappings are small notations with RoboChart's tokens.
// Reading stops at the first syntax error.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/advice/advice.hpp"
#include "base/diagnostics/diagnostic.hpp"
#include "frontend/syntax/lexer.hpp"

namespace robochart::frontend {

/// A token and its place.
struct Word {
    std::string text;
    diagnostics::Span span;
};

class WordReader {
public:
    /// Syntax errors are reported with the rule `syntax`. The message contains the expected and the actual text, and
    /// the matching row of `advice`.
    WordReader(const diagnostics::SourceManager&, diagnostics::SourceId, const diagnostics::Rule& syntax,
               diagnostics::Diagnostics&, std::span<const diagnostics::Advice> advice = {});

    [[nodiscard]] bool has_failed() const { return failed_; }
    [[nodiscard]] bool at_word(std::string_view word) const;
    [[nodiscard]] bool at_end() const { return current_token().kind == TokenKind::end; }
    [[nodiscard]] bool at_number() const;
    [[nodiscard]] Token current_token() const { return stream_.tokens.token_at(next_); }
    [[nodiscard]] diagnostics::Span last_span() const { return last_; }
    /// Returns the text from a place to the last token read, on one line.
    [[nodiscard]] std::string text_since(diagnostics::Span from) const;

    /// Consumes the next token if it is this word. Otherwise returns false.
    bool take_word(std::string_view word);
    void expect_word(std::string_view word);
    /// Consumes any name. `what` is its description in the error message.
    Word name(std::string_view what);
    /// Consumes a qualified name `a::b::c`.
    Word qualified_name(std::string_view what);
    /// Reads a string without its quotes.
    std::string read_quoted(std::string_view what);

    /// Reports a syntax error. `words` are the words that are allowed here. The message suggests the word nearest to
    /// the text.
    void fail_expecting(std::string_view expected, const std::vector<std::string>& words = {});
    /// Reports a finding. The returned pointer is valid until the next report. After a syntax error, no finding is
    /// reported and the result is null.
    diagnostics::Diagnostic* report(const diagnostics::Rule&, diagnostics::Span, std::vector<std::string> arguments);

protected:
    void advance_token();
    [[nodiscard]] Token token_behind() const { return stream_.tokens.token_at(next_ + 1); }

private:
    const diagnostics::SourceManager& sources_;
    const diagnostics::Rule& syntax_;
    std::span<const diagnostics::Advice> advice_;
    diagnostics::Diagnostics& diagnostics_;
    TokenStream stream_;
    std::size_t next_ = 0;
    diagnostics::Span last_;
    bool failed_ = false;
};

}  // namespace robochart::frontend
