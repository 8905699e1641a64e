// A picture without its geometry, as exports to other layouts need it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "diagrams/notation/picture.hpp"

namespace robochart::diagrams {

/// What a picture holds, as a tree of boxes.
class Outline {
public:
    explicit Outline(const Picture& picture);

    /// A name of letters and digits, different for each box.
    [[nodiscard]] std::string id(std::size_t box) const;
    /// Its first line.
    [[nodiscard]] std::string title(std::size_t box) const;
    /// Its other lines: rows or actions; what was elided as a whole.
    [[nodiscard]] std::vector<std::string> rows(std::size_t box) const;
    /// On one line.
    [[nodiscard]] std::string label(const PictureLine& line) const;
    /// Boxes directly in a box (`none`: in no box), squares of events apart.
    [[nodiscard]] const std::vector<std::size_t>& inside(std::size_t box) const;
    /// The squares on its border.
    [[nodiscard]] const std::vector<std::size_t>& events(std::size_t box) const;
    /// The lines between boxes directly in a box.
    [[nodiscard]] const std::vector<std::size_t>& lines(std::size_t box) const;
    /// Is it a machine or an operation: boxes joined as nodes, not as squares?
    [[nodiscard]] bool is_machine() const { return machine_; }

private:
    const Picture& picture_;
    bool machine_ = false;
    std::vector<std::vector<std::size_t>> inside_, events_, lines_;  ///< by box; the last for no box
};

}  // namespace robochart::diagrams
