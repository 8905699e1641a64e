// SPDX-License-Identifier: Apache-2.0
// A picture without its geometry, for exports that compute their own layout.
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

    /// An identifier of letters and digits, unique for each box.
    [[nodiscard]] std::string id(std::size_t box) const;
    /// The first line of the box.
    [[nodiscard]] std::string title_of_box(std::size_t box) const;
    /// The lines of the box after the title: rows or actions. Text that the picture elides is complete.
    [[nodiscard]] std::vector<std::string> rows_of(std::size_t box) const;
    /// The label on one line.
    [[nodiscard]] std::string label_of(const PictureLine& line) const;
    /// The boxes directly inside a box, without squares of events; for `none`, the boxes that are in no box.
    [[nodiscard]] const std::vector<std::size_t>& boxes_inside(std::size_t box) const;
    /// The squares of events on the border of the box.
    [[nodiscard]] const std::vector<std::size_t>& events_of(std::size_t box) const;
    /// The lines between boxes directly in a box.
    [[nodiscard]] const std::vector<std::size_t>& lines_inside(std::size_t box) const;
    /// True for a machine or an operation: lines join boxes, not squares.
    [[nodiscard]] bool is_machine() const { return machine_; }

private:
    const Picture& picture_;
    bool machine_ = false;
    std::vector<std::vector<std::size_t>> inside_, events_, lines_;  ///< indexed by box; the last entry is for `none`
};

}  // namespace robochart::diagrams
