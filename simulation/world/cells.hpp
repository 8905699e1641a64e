// SPDX-License-Identifier: Apache-2.0
// Sorts disks into the squares of a uniform grid (a cell list: Hockney, Eastwood, "Computer Simulation Using
// Particles", 1988, 8-4). The grid is used to find neighbours and to follow rays.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "simulation/world/geometry.hpp"

namespace robochart::simulation {

class Cells {
public:
    /// Sorts the disks again, by their centres. Cells are at least `size` wide, and there are not many more cells than
    /// disks.
    void sort_disks(std::span<const double> x, std::span<const double> y, double size);

    struct Cell {
        std::int32_t column = 0;
        std::int32_t row = 0;
    };
    /// Returns the cell of a point. Points outside the disks' bounding box have cells outside the grid.
    [[nodiscard]] Cell cell_of(Vector) const;
    /// Returns the disks whose centres are in a cell, ascending; empty outside the grid.
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
