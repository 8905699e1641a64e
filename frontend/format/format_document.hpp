// Texts that may be laid out in several ways (private to the formatter), after Wadler, "A prettier printer" (2003):
// a group is written on one line if it fits, and otherwise every line of its own breaks. Widths are kept in the nodes,
// so that each decision takes constant time.
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

/// Columns that one tab of indentation counts.
inline constexpr std::size_t tab_width = 4;
/// Columns of a line.
inline constexpr std::uint16_t line_limit = 120;
/// Columns up to which a body in braces may stand on one line.
inline constexpr std::uint16_t body_limit = 80;

/// Owns the nodes.
class Document {
public:
    Document();

    /// A text that is written as it is; the view must outlive the document.
    Doc text(std::string_view text);
    /// A comment: as a text, but what comes before need not leave space for it.
    Doc comment(std::string_view text);
    /// `// …`: no group that holds it fits on one line.
    Doc line_comment(std::string_view text);
    [[nodiscard]] Doc blank() const { return blank_; }
    [[nodiscard]] Doc line() const { return line_; }              ///< a blank or a line end
    [[nodiscard]] Doc soft() const { return soft_; }              ///< nothing or a line end
    [[nodiscard]] Doc hard() const { return hard_; }              ///< a line end
    [[nodiscard]] Doc empty_line() const { return empty_line_; }  ///< a line end and an empty line
    [[nodiscard]] Doc raw() const { return raw_; }                ///< a line end without indentation
    Doc cat(Doc a, Doc b);
    Doc cat(std::initializer_list<Doc> docs);
    Doc nest(Doc inner);  ///< one tab further in
    Doc group(Doc inner, std::uint16_t limit = line_limit);
    /// Forgets all nodes but the constant ones.
    void clear();

private:
    friend class Printer;
    enum class Kind : std::uint8_t { text, comment, line, soft, hard, empty_line, raw, cat, nest, group };
    struct Node {
        Kind kind = Kind::text;
        bool breaks = false;      ///< has a place for a line end
        std::uint16_t flat = 0;   ///< columns on one line; `endless` if that cannot be
        std::uint16_t lead = 0;   ///< columns before the first place for a line end
        std::uint16_t limit = 0;  ///< groups
        Doc a = 0;
        Doc b = 0;
        std::string_view text;
    };
    static constexpr std::uint16_t endless = 0xffff;

    Doc add(const Node& node);
    Doc add_break(Kind kind, std::uint16_t flat);
    Doc add_text(Kind kind, std::string_view text);
    static std::uint16_t sum(std::uint16_t a, std::uint16_t b);

    std::vector<Node> nodes_;
    Doc blank_ = 0, line_ = 0, soft_ = 0, hard_ = 0, empty_line_ = 0, raw_ = 0;
    std::size_t constant_ = 0;
};

/// Writes documents one after the other.
class Printer {
public:
    Printer(const Document& document, std::string_view line_end) : document_(document), line_end_(line_end) {}

    void print(Doc doc);
    [[nodiscard]] std::string take() { return std::move(out_); }

private:
    using Kind = Document::Kind;
    struct Item {
        Doc doc;
        std::uint32_t indent;
        bool flat;
    };

    void step(Item item);
    void write(std::string_view text);
    void end_line(std::uint32_t indent, int count);
    [[nodiscard]] bool fits(const Document::Node& group) const;

    const Document& document_;
    std::string_view line_end_;
    std::vector<Item> pending_;
    std::string out_;
    std::uint32_t indent_ = 0;  ///< tabs still to be written before the next text
    std::size_t column_ = 0;
};

}  // namespace robochart::frontend
