// SPDX-License-Identifier: Apache-2.0
// Reads the tokens of a text in RoboChart's notation one after another, for the small notations of scenarios and
// mappings. Reading stops at the first syntax error.
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
    /// A syntax error is reported by the rule `syntax`, with what was expected, what was found, and the matching row of
    /// `advice`.
    WordReader(const diagnostics::SourceManager&, diagnostics::SourceId, const diagnostics::Rule& syntax,
               diagnostics::Diagnostics&, std::span<const diagnostics::Advice> advice = {});

    [[nodiscard]] bool has_failed() const { return failed_; }
    [[nodiscard]] bool at_word(std::string_view word) const;
    [[nodiscard]] bool at_end() const { return current_token().kind == TokenKind::end; }
    [[nodiscard]] bool at_number() const;
    [[nodiscard]] Token current_token() const { return stream_.tokens.token_at(next_); }
    [[nodiscard]] diagnostics::Span last_span() const { return last_; }
    /// The text from a place to the last token read, on one line.
    [[nodiscard]] std::string text_since(diagnostics::Span from) const;

    /// Consumes the next token if it is this word; otherwise returns false.
    bool take_word(std::string_view word);
    void expect_word(std::string_view word);
    /// Consumes any name. `what` names it in the error message.
    Word name(std::string_view what);
    /// `a::b::c`.
    Word qualified_name(std::string_view what);
    /// A string without its quotes.
    std::string read_quoted(std::string_view what);

    /// `words`: the words that are allowed here; the nearest is suggested.
    void fail_expecting(std::string_view expected, const std::vector<std::string>& words = {});
    /// Reports a finding. The result is valid until the next report. After a syntax error, no finding is reported and
    /// the result is null.
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
