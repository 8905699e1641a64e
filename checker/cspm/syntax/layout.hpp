// SPDX-License-Identifier: Apache-2.0
// Lays out a text. The text marks places where a line may end, in nested groups. If a group does not fit on its line,
// the line ends at all places of the group (Oppen 1980, with consistent breaking).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace robochart::cspm {

class Layout {
public:
    explicit Layout(std::size_t width) : width_(width) {}

    /// Adds text without line ends. Inserts a space if two pieces would otherwise form another token, such as `{-`,
    /// `<-` or `{|`.
    void add_text(std::string_view piece);
    void space_or_line() { add_piece(Kind::line, " "); }
    void break_line() { add_piece(Kind::hard_line, ""); }
    void open_group() { pieces_.push_back({Kind::open, ""}); }
    void close_group() { pieces_.push_back({Kind::close, ""}); }
    void indent() { pieces_.push_back({Kind::indent, ""}); }
    void outdent() { pieces_.push_back({Kind::outdent, ""}); }

    [[nodiscard]] std::string render() const;

private:
    enum class Kind : std::uint8_t { text, line, hard_line, open, close, indent, outdent };
    struct Piece {
        Kind kind;
        std::string text;
    };

    void add_piece(Kind kind, std::string text);
    [[nodiscard]] std::vector<std::size_t> group_widths() const;

    std::size_t width_;
    char last_ = '\0';  // the previous character on the same line
    std::vector<Piece> pieces_;
};

}  // namespace robochart::cspm
