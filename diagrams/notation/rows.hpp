// Rows of a box: a sign and what is declared, one element behind the other, broken where it gets too wide.
#pragma once

#include <string>
#include <vector>

#include "diagrams/notation/elements.hpp"
#include "diagrams/notation/picture.hpp"
#include "frontend/syntax/ast.hpp"

namespace robochart::diagrams {

/// Sizes of what is written, in pixels.
namespace measure {
inline constexpr double title_font = 12;
inline constexpr double title = 26;  ///< height of the title of a component
inline constexpr double state_title = 24;
inline constexpr double row_font = 11;
inline constexpr double row = 16;
inline constexpr double line = 14;  ///< of a label or an action
inline constexpr double padding = 7;
inline constexpr double sign = 24;  ///< width of the column with signs
inline constexpr double widest_row = 420;
inline constexpr std::size_t longest_title = 60;  ///< in characters
}  // namespace measure

/// A text of a row.
struct RowText {
    std::string text;
    std::size_t element = none;
    bool italic = false;
};

/// One line of a box.
struct Row {
    Icon icon = Icon::no_icon;
    std::vector<RowText> texts;  ///< one behind the other
};

/// Several rows, and what they left out.
struct Rows {
    std::vector<Row> rows;
    std::string whole;  ///< texts that are elided

    /// A row for each line that the texts need; commas between them.
    void add(Icon icon, const std::vector<RowText>& texts);
    [[nodiscard]] bool empty() const { return rows.empty(); }
    /// With space around them.
    [[nodiscard]] layout::Size size() const;
    /// Writes them into a box, below a place.
    void write(const layout::Point& corner, PictureBox& box) const;
};

/// Clauses, operations, constants, variables, clocks of a context; its events too where they are no squares.
[[nodiscard]] Rows rows_of(const frontend::Context& context, const Elements& elements, bool with_events);
/// Pre- and postconditions.
void add_conditions(Rows& rows, Icon icon, const std::vector<frontend::ExprPtr>& conditions, const Elements& elements);

}  // namespace robochart::diagrams
