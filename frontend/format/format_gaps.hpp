// SPDX-License-Identifier: Apache-2.0
// Formats tokens and the gaps between them (private to the formatter). Writes each token as soon as it is read. So no
// token is lost, even if the formatter misunderstands the text.
//
// Each function formats one construct and has its name. The comment of the function shows an example of the construct.
// The first parameter is the gap before it.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/format/format_document.hpp"
#include "frontend/format/format_words.hpp"

namespace robochart::frontend {

/// The text between two tokens.
enum class Gap : std::uint8_t {
    done,    ///< the gap has been written already
    none,    ///< no text
    blank,   ///< a blank
    soft,    ///< no text, or a line end if the group breaks
    line,    ///< a blank, or a line end if the group breaks
    open,    ///< a blank, or a line end if the group breaks; after an opening brace
    first,   ///< a line end after an opening brace
    member,  ///< a line end; an empty line in the source is preserved
    block,   ///< a line end and an empty line
    start,   ///< the beginning of the text
};

/// Owns the document and formats one token after the other.
class WordLayout : protected TokenReader {
public:
    WordLayout(const WordLayout&) = delete;
    WordLayout& operator=(const WordLayout&) = delete;

    /// Returns the whole text in the standard layout.
    [[nodiscard]] std::string run(std::string_view line_end);

protected:
    using TokenReader::TokenReader;
    ~WordLayout() = default;

    /// Formats one member of the file.
    virtual Doc format_member(Gap gap) = 0;

    Doc format_token(Gap gap);
    /// Returns the next token as it is written, without a gap.
    Doc advance() { return doc_.plain_text(take_token()); }
    /// Formats `count` tokens with blanks between them.
    Doc format_words(Gap gap, std::size_t count);
    /// Formats `A::B::C`.
    Doc format_names(Gap gap);
    /// Formats a keyword and a name.
    Doc format_phrase(Gap gap);
    /// Formats `import P::*`.
    Doc format_import(Gap gap);
    Doc format_gap(Gap gap);
    /// Formats the comments before a closing brace or the end of the text, with the indentation of the body that ends
    /// there.
    Doc closing_comments();

    Doc cat(Doc a, Doc b) { return doc_.cat(a, b); }
    Doc cat(std::initializer_list<Doc> docs) { return doc_.cat(docs); }
    /// Returns a group that is preceded by a gap.
    Doc group(Doc gap, Doc inner) { return doc_.cat(gap, doc_.group(inner)); }

    Document doc_;

private:
    Doc format_separator(Gap gap, std::size_t lines);
    Doc inline_comments(Gap gap, const std::vector<Piece>& pieces);
    Doc own_lines(Gap gap, const std::vector<Piece>& pieces, std::size_t trailing);
    Doc gap_after_comment(Gap gap, const Piece& before, const Piece& piece);
    Doc format_trailing(const std::vector<Piece>& pieces, std::size_t count);
    Doc format_comment(const Piece& piece);
    Doc comment_line(std::string_view line, std::size_t margin, bool moved);
};

}  // namespace robochart::frontend
