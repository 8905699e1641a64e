// SPDX-License-Identifier: Apache-2.0
// The tokens of a text and the comments between them, read in order (private to the formatter).
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "frontend/syntax/lexer.hpp"

namespace robochart::frontend {

/// A comment, or the token after the comments.
struct Piece {
    diagnostics::Span span;
    std::size_t lines;      ///< number of line ends before it, at most 2
    bool to_line_end;       ///< `// …`
    bool is_token = false;  ///< the token itself
};

/// Holds the current position. The text and the tokens must outlive it.
class TokenReader {
public:
    TokenReader(std::string_view text, const TokenStream& stream);

    // The next tokens
    [[nodiscard]] Token peek(std::size_t ahead = 0) const;
    [[nodiscard]] bool at(std::string_view word) const { return peek().is_word(word); }
    /// True if the next token is this word, as a keyword or as a name.
    [[nodiscard]] bool at_word(std::string_view word, std::size_t ahead = 0) const;
    [[nodiscard]] bool at_name() const { return peek().kind == TokenKind::identifier; }
    [[nodiscard]] bool at_end() const { return peek().kind == TokenKind::end; }
    [[nodiscard]] bool at_closing() const;
    /// The last token taken; no value at the beginning.
    [[nodiscard]] std::optional<Token> last_token() const {
        return at_ == 0 ? std::nullopt : std::optional<Token>(stream_.tokens[at_ - 1]);
    }
    /// True if the last token and the next would be read as the same two tokens without a blank between them.
    [[nodiscard]] bool may_touch() const;
    /// Takes the next token and returns its text.
    std::string_view take_token();

    // Comments before the next token
    [[nodiscard]] bool has_comment() const;
    /// True if neither a token nor a comment has been read.
    [[nodiscard]] bool is_untouched() const { return at_ == 0 && comment_ == 0; }
    /// The number of line ends between the last piece read and the next token, at most 2.
    [[nodiscard]] std::size_t lines_before() const { return line_ends(previous_end_, peek().span.begin); }
    /// The comments before the next token, and the token itself. Marks the comments as read.
    [[nodiscard]] std::vector<Piece> take_comments();
    /// Marks the comments before an offset as read.
    void skip_comments(std::size_t offset);
    /// Sets the offset at which the last piece read ends.
    void read_to(std::size_t offset) { previous_end_ = offset; }

    // The text
    [[nodiscard]] std::string_view text() const { return text_; }
    [[nodiscard]] std::string_view source_text(diagnostics::Span span) const;
    /// The blanks before an offset on its line; no value if something else precedes it on the line.
    [[nodiscard]] std::optional<std::string_view> margin_before(std::size_t offset) const;

private:
    [[nodiscard]] std::size_t line_ends(std::size_t begin, std::size_t end) const;

    std::string_view text_;
    const TokenStream& stream_;
    std::size_t at_ = 0;
    std::size_t comment_ = 0;       ///< the next comment
    std::size_t previous_end_ = 0;  ///< the offset after the last piece read
};

}  // namespace robochart::frontend
