// SPDX-License-Identifier: Apache-2.0
// Lays out the rows of a box. A row contains an icon and declarations, one after the other, and is broken if it is too
// wide.
#pragma once

#include <string>
#include <vector>

#include "frontend/diagrams/notation/elements.hpp"
#include "frontend/diagrams/notation/picture.hpp"
#include "frontend/syntax/ast.hpp"

namespace robochart::diagrams {

/// Sizes of text in pixels.
namespace measure {
inline constexpr double title_font = 12;
inline constexpr double title = 26;  ///< height of the title of a component
inline constexpr double state_title = 24;
inline constexpr double row_font = 11;
inline constexpr double row = 16;
inline constexpr double line = 14;  ///< the height of a line of a label or an action
inline constexpr double padding = 7;
inline constexpr double sign = 24;  ///< width of the icon column
inline constexpr double widest_row = 420;
inline constexpr std::size_t longest_title = 60;  ///< the greatest number of characters of a title
}  // namespace measure

/// A text of a row.
struct RowText {
    std::string text;
    std::size_t element = none;
    bool italic = false;
};

/// One row of a box.
struct Row {
    Icon icon = Icon::no_icon;
    std::vector<RowText> texts;  ///< one after another
};

/// Several rows, and the texts that they elide.
struct Rows {
    std::vector<Row> rows;
    std::string whole;  ///< the complete text if a part of it is elided

    /// Adds one row for each line that the texts need. Commas separate the texts.
    void add(Icon icon, const std::vector<RowText>& texts);
    [[nodiscard]] bool empty() const { return rows.empty(); }
    /// Returns the size including margins.
    [[nodiscard]] layout::Size size() const;
    /// Writes the rows into a box, below a point.
    void write(const layout::Point& corner, PictureBox& box) const;
};

/// Returns the rows of a context: the cycle and the registers of RoboSim, clauses, operations, constants, variables,
/// clocks, and events if they are not drawn as squares.
[[nodiscard]] Rows rows_of(const frontend::Context& context, const Elements& elements, bool with_events);
/// Adds pre- or postconditions.
void add_conditions(Rows& rows, Icon icon, const std::vector<frontend::ExprPtr>& conditions, const Elements& elements);

}  // namespace robochart::diagrams
