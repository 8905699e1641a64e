// Words with the gaps between them (private to the formatter). Every word is written when it is read, so that no word
// can be lost, whatever a reading of the text does not foresee.
//
// Functions are named after what they lay out and take the gap to leave before it.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/format/format_document.hpp"
#include "frontend/format/format_words.hpp"

namespace robochart::frontend {

/// The text between two words.
enum class Gap : std::uint8_t {
    done,    ///< written already
    none,    ///< nothing
    blank,   ///< a blank
    soft,    ///< nothing, or a line end if the group breaks
    line,    ///< a blank, or a line end if the group breaks
    open,    ///< the same after an opening brace
    first,   ///< a line end after an opening brace
    member,  ///< a line end; an empty line is kept
    block,   ///< a line end and an empty line
    start,   ///< the beginning of the text
};

/// Owns the document; the layout of one word after the other.
class WordLayout : protected TokenReader {
public:
    WordLayout(const WordLayout&) = delete;
    WordLayout& operator=(const WordLayout&) = delete;

    /// The whole text in the standard layout.
    [[nodiscard]] std::string run(std::string_view line_end);

protected:
    using TokenReader::TokenReader;
    ~WordLayout() = default;

    /// What the text consists of.
    virtual Doc member(Gap gap) = 0;

    Doc token(Gap gap);
    /// The word here as it is written, without a gap.
    Doc advance() { return doc_.text(take()); }
    /// Words with blanks between.
    Doc words(Gap gap, std::size_t count);
    /// `A::B::C`
    Doc names(Gap gap);
    /// A word and a name.
    Doc phrase(Gap gap);
    /// `import P::*`
    Doc import(Gap gap);
    Doc gap(Gap gap);
    /// The comments before a closing brace or the end, inside what is closed.
    Doc closing_comments();

    Doc cat(Doc a, Doc b) { return doc_.cat(a, b); }
    Doc cat(std::initializer_list<Doc> docs) { return doc_.cat(docs); }
    /// A group whose gap stands before it.
    Doc group(Doc gap, Doc inner) { return doc_.cat(gap, doc_.group(inner)); }

    Document doc_;

private:
    Doc separator(Gap gap, std::size_t lines);
    Doc inline_comments(Gap gap, const std::vector<Piece>& pieces);
    Doc own_lines(Gap gap, const std::vector<Piece>& pieces, std::size_t trailing);
    Doc following(Gap gap, const Piece& before, const Piece& piece);
    Doc trailing(const std::vector<Piece>& pieces, std::size_t count);
    Doc comment(const Piece& piece);
    Doc comment_line(std::string_view line, std::size_t margin, bool moved);
};

}  // namespace robochart::frontend
