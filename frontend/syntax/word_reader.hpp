// The words of a text in RoboChart's notation one after the other, for the small notations beside models: scenarios,
// mappings. After the first syntax error nothing more is read.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/advice/advice.hpp"
#include "diagnostics/diagnostic.hpp"
#include "frontend/syntax/lexer.hpp"

namespace robochart::frontend {

/// A word of the text and its place.
struct Word {
    std::string text;
    diagnostics::Span span;
};

class WordReader {
public:
    /// `syntax` is reported with what was expected and what was found, and with what `advice` says of it.
    WordReader(const diagnostics::SourceManager&, diagnostics::SourceId, const diagnostics::Rule& syntax,
               diagnostics::Diagnostics&, std::span<const diagnostics::Advice> advice = {});

    [[nodiscard]] bool failed() const { return failed_; }
    [[nodiscard]] bool at(std::string_view word) const;
    [[nodiscard]] bool at_end() const { return token().kind == TokenKind::end; }
    [[nodiscard]] bool at_number() const;
    [[nodiscard]] Token token() const { return stream_.tokens.at(next_); }
    [[nodiscard]] diagnostics::Span last_span() const { return last_; }
    /// The text from a place to the last word read, on one line.
    [[nodiscard]] std::string text_since(diagnostics::Span from) const;

    /// Takes the word if it is the next one.
    bool take(std::string_view word);
    void expect(std::string_view word);
    /// Any name; `what` for the message.
    Word name(std::string_view what);
    /// `a::b::c`.
    Word qualified_name(std::string_view what);
    /// A string without its quotes.
    std::string quoted(std::string_view what);

    /// `words`: those that may stand here; the nearest is suggested.
    void fail(std::string_view expected, const std::vector<std::string>& words = {});
    /// Valid until the next report; null behind a syntax error, where nothing is reported.
    diagnostics::Diagnostic* report(const diagnostics::Rule&, diagnostics::Span, std::vector<std::string> arguments);

protected:
    void advance();
    [[nodiscard]] Token token_behind() const { return stream_.tokens.at(next_ + 1); }

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
