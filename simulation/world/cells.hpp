// SPDX-License-Identifier: Apache-2.0
// Disks sorted into the squares of a uniform grid (a cell list: Hockney, Eastwood, "Computer Simulation Using
// Particles", 1988, 8-4), for finding neighbours and for following rays.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "simulation/world/geometry.hpp"

namespace robochart::simulation {

class Cells {
public:
    /// Sorts the centres again. Cells are at least `size` wide, and there are not many more cells than disks.
    void sort_disks(std::span<const double> x, std::span<const double> y, double size);

    struct Cell {
        std::int32_t column = 0;
        std::int32_t row = 0;
    };
    /// The cell of a point; points outside the disks' bounding box have cells outside the grid.
    [[nodiscard]] Cell cell_of(Vector) const;
    /// The disks whose centres are in a cell, ascending; empty outside the grid.
    [[nodiscard]] std::span<const std::uint32_t> disks_in(Cell) const;
    [[nodiscard]] double size() const { return size_; }
    [[nodiscard]] Vector corner() const { return corner_; }
    [[nodiscard]] Vector far_corner() const { return corner_ + Vector{columns_ * size_, rows_ * size_}; }

private:
    Vector corner_;
    double size_ = 1;
    double per_size_ = 1;
    std::int32_t columns_ = 0;
    std::int32_t rows_ = 0;
    std::vector<std::uint32_t> begin_;  ///< start of each cell in disks_, and the end
    std::vector<std::uint32_t> disks_;
    std::vector<std::uint32_t> cell_of_;
};

}  // namespace robochart::simulation
