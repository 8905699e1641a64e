// SPDX-License-Identifier: Apache-2.0
#include "simulation/world/cells.hpp"

#include <algorithm>
#include <cmath>

namespace robochart::simulation {

void Cells::sort_disks(std::span<const double> x, std::span<const double> y, double size) {
    const auto [left, right] = std::minmax_element(x.begin(), x.end());
    const auto [low, high] = std::minmax_element(y.begin(), y.end());
    corner_ = x.empty() ? Vector{} : Vector{*left, *low};
    const Vector extent = x.empty() ? Vector{} : Vector{*right - *left, *high - *low};
    // The limit prevents a million empty cells if two disks are far from all others.
    const double fair = std::sqrt(extent.x * extent.y / (4.0 * static_cast<double>(x.size()) + 1));
    size_ = std::max({size, fair, std::max(extent.x, extent.y) / 4096});
    per_size_ = 1 / size_;
    columns_ = static_cast<std::int32_t>(extent.x * per_size_) + 1;
    rows_ = static_cast<std::int32_t>(extent.y * per_size_) + 1;
    begin_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
    cell_of_.resize(x.size());
    disks_.resize(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Cell at = cell_of({x[i], y[i]});
        cell_of_[i] = static_cast<std::uint32_t>(at.row * columns_ + at.column);
        ++begin_[cell_of_[i] + 1];
    }
    for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
    for (std::size_t i = x.size(); i-- > 0;) disks_[--begin_[cell_of_[i] + 1]] = static_cast<std::uint32_t>(i);
    // begin_[c + 1] is now the beginning of cell c.
    for (std::size_t c = 0; c + 1 < begin_.size(); ++c) begin_[c] = begin_[c + 1];
    begin_.back() = static_cast<std::uint32_t>(x.size());
}

Cells::Cell Cells::cell_of(Vector point) const {
    const auto index = [this](double offset) {
        return static_cast<std::int32_t>(std::floor(std::clamp(offset * per_size_, -1e9, 1e9)));
    };
    return {index(point.x - corner_.x), index(point.y - corner_.y)};
}

std::span<const std::uint32_t> Cells::disks_in(Cell at) const {
    if (at.column < 0 || at.row < 0 || at.column >= columns_ || at.row >= rows_) return {};
    const auto index =
        static_cast<std::size_t>(at.row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(at.column);
    return std::span(disks_).subspan(begin_[index], begin_[index + 1] - begin_[index]);
}

}  // namespace robochart::simulation
