// SPDX-License-Identifier: Apache-2.0
// Builds and prints documents that can be laid out in several ways (private to the formatter), after Wadler, "A
// prettier printer" (2003). A group is written on one line if it fits. Otherwise the breaks directly in it become line
// ends. Nodes store their widths, so each decision takes constant time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace robochart::frontend {

/// A node of a Document; 0 is the empty text.
using Doc = std::uint32_t;

/// The width of one tab of indentation, in columns.
inline constexpr std::size_t tab_width = 4;
/// The longest line, in columns.
inline constexpr std::uint16_t line_limit = 120;
/// The last column up to which a body in braces may be written on one line.
inline constexpr std::uint16_t body_limit = 80;

/// Owns the nodes of documents.
class Document {
public:
    Document();

    /// Returns a text that is written unchanged. The view must outlive the document.
    Doc plain_text(std::string_view text);
    /// Returns a comment. It is written as a text, but groups before it fit on their line even if the comment exceeds
    /// the limit.
    Doc comment_text(std::string_view text);
    /// Returns a line comment `// …`. A group that contains it never fits on one line.
    Doc line_comment(std::string_view text);
    [[nodiscard]] Doc blank() const { return blank_; }
    [[nodiscard]] Doc line() const { return line_; }              ///< a blank or a line end
    [[nodiscard]] Doc soft() const { return soft_; }              ///< no text, or a line end
    [[nodiscard]] Doc hard() const { return hard_; }              ///< a line end
    [[nodiscard]] Doc empty_line() const { return empty_line_; }  ///< a line end and an empty line
    [[nodiscard]] Doc raw() const { return raw_; }                ///< a line end without indentation
    Doc cat(Doc a, Doc b);
    Doc cat(std::initializer_list<Doc> docs);
    Doc nest_indented(Doc inner);  ///< the contents are indented by one more tab
    Doc group(Doc inner, std::uint16_t limit = line_limit);
    /// Removes all nodes except the constant ones.
    void clear();

private:
    friend class Printer;
    enum class Kind : std::uint8_t { text, comment, line, soft, hard, empty_line, raw, cat, nest, group };
    struct Node {
        Kind kind = Kind::text;
        bool breaks = false;      ///< contains a possible line break
        std::uint16_t flat = 0;   ///< columns on one line; `endless` if the node needs several lines
        std::uint16_t lead = 0;   ///< columns before the first possible line break
        std::uint16_t limit = 0;  ///< the last column that a group may use on one line
        Doc a = 0;
        Doc b = 0;
        std::string_view text;
    };
    static constexpr std::uint16_t endless = 0xffff;

    Doc add(const Node& node);
    Doc add_break(Kind kind, std::uint16_t flat);
    Doc add_text(Kind kind, std::string_view text);
    static std::uint16_t capped_sum(std::uint16_t a, std::uint16_t b);

    std::vector<Node> nodes_;
    Doc blank_ = 0, line_ = 0, soft_ = 0, hard_ = 0, empty_line_ = 0, raw_ = 0;
    std::size_t constant_ = 0;
};

/// Writes documents one after the other.
class Printer {
public:
    Printer(const Document& document, std::string_view line_end) : document_(document), line_end_(line_end) {}

    void print(Doc doc);
    [[nodiscard]] std::string take_text() { return std::move(out_); }

private:
    using Kind = Document::Kind;
    struct Item {
        Doc doc;
        std::uint32_t indent;
        bool flat;
    };

    void print_item(Item item);
    void write(std::string_view text);
    void end_line(std::uint32_t indent, int count);
    [[nodiscard]] bool fits_line(const Document::Node& group) const;

    const Document& document_;
    std::string_view line_end_;
    std::vector<Item> pending_;
    std::string out_;
    std::uint32_t indent_ = 0;  ///< tabs to write before the next text
    std::size_t column_ = 0;
};

}  // namespace robochart::frontend
