// SPDX-License-Identifier: Apache-2.0
// Reads the tokens of a text and the comments between them, in order (private to the formatter).
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "frontend/syntax/lexer.hpp"

namespace robochart::frontend {

/// A comment, or the token that follows the comments.
struct Piece {
    diagnostics::Span span;
    std::size_t lines;      ///< number of line ends before the piece, at most 2
    bool to_line_end;       ///< the comment ends at the end of its line: `// …`
    bool is_token = false;  ///< true for the token, false for a comment
};

/// Reads a text from its beginning. The text and the tokens must outlive the reader.
class TokenReader {
public:
    TokenReader(std::string_view text, const TokenStream& stream);

    // Returns the next tokens
    [[nodiscard]] Token peek(std::size_t ahead = 0) const;
    [[nodiscard]] bool at(std::string_view word) const { return peek().is_word(word); }
    /// True if the next token is this word, as a keyword or as a name.
    [[nodiscard]] bool at_word(std::string_view word, std::size_t ahead = 0) const;
    [[nodiscard]] bool at_name() const { return peek().kind == TokenKind::identifier; }
    [[nodiscard]] bool at_end() const { return peek().kind == TokenKind::end; }
    [[nodiscard]] bool at_closing() const;
    /// Returns the last token taken, or no value at the beginning.
    [[nodiscard]] std::optional<Token> last_token() const {
        return at_ == 0 ? std::nullopt : std::optional<Token>(stream_.tokens[at_ - 1]);
    }
    /// True if the last and the next token remain the same two tokens if no blank separates them.
    [[nodiscard]] bool may_touch() const;
    /// Takes the next token and returns its text.
    std::string_view take_token();

    // Comments before the next token
    [[nodiscard]] bool has_comment() const;
    /// True if neither a token nor a comment has been read.
    [[nodiscard]] bool is_untouched() const { return at_ == 0 && comment_ == 0; }
    /// Returns the number of line ends between the last piece read and the next token, at most 2.
    [[nodiscard]] std::size_t lines_before() const { return line_ends(previous_end_, peek().span.begin); }
    /// Returns the comments before the next token, and the token itself. Marks the comments as read.
    [[nodiscard]] std::vector<Piece> take_comments();
    /// Marks the comments before an offset as read.
    void skip_comments(std::size_t offset);
    /// Sets the offset at which the last piece read ends.
    void read_to(std::size_t offset) { previous_end_ = offset; }

    // Returns the text
    [[nodiscard]] std::string_view text() const { return text_; }
    [[nodiscard]] std::string_view source_text(diagnostics::Span span) const;
    /// Returns the blanks before an offset on its line, or no value if something else precedes it on the line.
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
