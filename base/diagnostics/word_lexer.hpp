// SPDX-License-Identifier: Apache-2.0
// The part that the lexers of rules (claims/sleec/syntax) and claims (claims/syntax) share: blanks, comments and words.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "base/diagnostics/scanner.hpp"

namespace robochart::diagnostics {

/// The base class of lexers whose comments begin with `//` or are inside `/*` and `*/`. `Token` has the members `kind`,
/// `span` and `text`; the type of its kinds has `word`, `comment` and `end`.
template <class Token>
class WordLexer : protected Scanner {
public:
    using Kind = decltype(Token::kind);

    /// `comments`: whether comments are tokens. `open_comment`: the error about a comment without end.
    WordLexer(std::string_view text, SourceId source, Diagnostics& diagnostics, bool comments, const Rule& open_comment)
        : Scanner(text, source), diagnostics_(diagnostics), comments_(comments), open_comment_(open_comment) {}
    WordLexer(const WordLexer&) = delete;
    WordLexer& operator=(const WordLexer&) = delete;
    virtual ~WordLexer() = default;

    /// The tokens of the text. The last one is an `end`.
    std::vector<Token> read_tokens() {
        while (!at_end()) {
            diagnostics_.poll();
            next();
        }
        push_token(Kind::end, at_);
        return std::move(tokens_);
    }

protected:
    /// Reads a number, of which the first digit is here.
    virtual void read_number() = 0;
    /// Reads anything else.
    virtual void read_symbol() = 0;

    void push_token(Kind kind, std::size_t begin) { tokens_.push_back({kind, span_from(begin), text_from(begin)}); }
    [[nodiscard]] Diagnostics& diagnostics() { return diagnostics_; }

private:
    void next() {
        const char c = peek();
        if (c == '\n' || c == ' ' || c == '\t' || c == '\r' || c == '\f') {
            ++at_;
        } else if (c == '/' && (peek(1) == '/' || peek(1) == '*')) {
            read_comment();
        } else if (begins_name(c)) {
            const std::size_t begin = at_;
            skip_name();
            push_token(Kind::word, begin);
        } else if (is_digit(c)) {
            read_number();
        } else {
            read_symbol();
        }
    }

    void read_comment() {
        const std::size_t begin = at_;
        if (accept("/*")) {
            const Span opening = span_from(begin);
            if (!skip_past("*/")) diagnostics_.report(open_comment_, opening);
        } else {
            at_ = line_end();
        }
        if (comments_) push_token(Kind::comment, begin);
    }

    Diagnostics& diagnostics_;
    bool comments_;
    const Rule& open_comment_;
    std::vector<Token> tokens_;
};

}  // namespace robochart::diagnostics
