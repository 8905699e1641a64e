// SPDX-License-Identifier: Apache-2.0
// Describes a picture without its geometry, for exports that compute their own layout.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "frontend/diagrams/notation/picture.hpp"

namespace robochart::diagrams {

/// The contents of a picture as a tree of boxes.
class Outline {
public:
    explicit Outline(const Picture& picture);

    /// Returns an identifier of letters and digits, unique for each box.
    [[nodiscard]] std::string id(std::size_t box) const;
    /// Returns the first line of text in the box.
    [[nodiscard]] std::string title_of_box(std::size_t box) const;
    /// Returns the lines of the box after the title: rows or actions. Text that the picture shortens is complete here.
    [[nodiscard]] std::vector<std::string> rows_of(std::size_t box) const;
    /// Returns the label on one line.
    [[nodiscard]] std::string label_of(const PictureLine& line) const;
    /// Returns the boxes directly inside a box, without squares of events. For `none`, returns the boxes that are in no
    /// box.
    [[nodiscard]] const std::vector<std::size_t>& boxes_inside(std::size_t box) const;
    /// Returns the squares of events on the border of the box.
    [[nodiscard]] const std::vector<std::size_t>& events_of(std::size_t box) const;
    /// Returns the lines between boxes directly in a box.
    [[nodiscard]] const std::vector<std::size_t>& lines_inside(std::size_t box) const;
    /// True if the picture shows a machine or an operation, in which lines join boxes and not squares.
    [[nodiscard]] bool is_machine() const { return machine_; }

private:
    const Picture& picture_;
    bool machine_ = false;
    std::vector<std::vector<std::size_t>> inside_, events_, lines_;  ///< indexed by box; the last entry is for `none`
};

}  // namespace robochart::diagrams
