// The words of a text and the comments between them, read one after the other (private to the formatter).
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "frontend/syntax/lexer.hpp"

namespace robochart::frontend {

/// A comment, or the word that comments precede.
struct Piece {
    diagnostics::Span span;
    std::size_t lines;      ///< line ends before it, at most 2
    bool to_line_end;       ///< `// …`
    bool is_token = false;  ///< the word itself
};

/// Owns the place in the text; text and tokens outlive it.
class TokenReader {
public:
    TokenReader(std::string_view text, const TokenStream& stream);

    // The next words
    [[nodiscard]] Token peek(std::size_t ahead = 0) const;
    [[nodiscard]] bool at(std::string_view word) const { return peek().is(word); }
    /// The same, for words that may be names elsewhere.
    [[nodiscard]] bool at_word(std::string_view word, std::size_t ahead = 0) const;
    [[nodiscard]] bool at_name() const { return peek().kind == TokenKind::identifier; }
    [[nodiscard]] bool at_end() const { return peek().kind == TokenKind::end; }
    [[nodiscard]] bool at_closing() const;
    /// The last word that was taken; none at the beginning.
    [[nodiscard]] std::optional<Token> last() const {
        return at_ == 0 ? std::nullopt : std::optional<Token>(stream_.tokens[at_ - 1]);
    }
    /// Would the last word and the next be read the same without a blank between them?
    [[nodiscard]] bool may_touch() const;
    /// The next word as it is written; the one after it is next then.
    std::string_view take();

    // Comments before the next word
    [[nodiscard]] bool commented() const;
    /// Whether nothing was read yet, neither words nor comments.
    [[nodiscard]] bool untouched() const { return at_ == 0 && comment_ == 0; }
    /// Line ends between what was read last and the next word, at most 2.
    [[nodiscard]] std::size_t lines_before() const { return line_ends(previous_end_, peek().span.begin); }
    /// The comments before the next word, and the word. The comments are read then.
    [[nodiscard]] std::vector<Piece> take_comments();
    /// The comments that begin before an offset are read then.
    void skip_comments(std::size_t offset);
    /// What was read last ends at an offset.
    void read_to(std::size_t offset) { previous_end_ = offset; }

    // The text
    [[nodiscard]] std::string_view text() const { return text_; }
    [[nodiscard]] std::string_view source(diagnostics::Span span) const;
    /// The blanks that precede a place on its line; nothing if something else does.
    [[nodiscard]] std::optional<std::string_view> margin(std::size_t offset) const;

private:
    [[nodiscard]] std::size_t line_ends(std::size_t begin, std::size_t end) const;

    std::string_view text_;
    const TokenStream& stream_;
    std::size_t at_ = 0;
    std::size_t comment_ = 0;       ///< the next comment
    std::size_t previous_end_ = 0;  ///< offset behind what was read last
};

}  // namespace robochart::frontend
