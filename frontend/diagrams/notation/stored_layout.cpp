// SPDX-License-Identifier: Apache-2.0
// See stored_layout.hpp.
#include "frontend/diagrams/notation/stored_layout.hpp"

#include <algorithm>

namespace robochart::diagrams {

using frontend::Declaration;

namespace {

template <class Map, class Key>
auto found(const Map& map, const Key& key) {
    const auto at = map.find(key);
    return at == map.end() ? std::nullopt : std::optional(at->second);
}

}  // namespace

std::optional<layout::DrawnBox> StoredLayout::box(const Declaration* of) const {
    return found(boxes, of);
}

StoredArea StoredLayout::area(const Declaration* of) const {
    return found(areas, of).value_or(StoredArea());
}

std::optional<layout::DrawnEdge> StoredLayout::line(const Declaration* of) const {
    return found(lines, of);
}

std::optional<layout::DrawnPort> StoredLayout::square(const Declaration* owner, const Declaration* event) const {
    const auto at = squares.find(owner);
    return at == squares.end() ? std::nullopt : found(at->second, event);
}

layout::Size StoredLayout::size(const Declaration* of) const {
    const layout::DrawnBox own = box(of).value_or(layout::DrawnBox());
    const StoredArea inside = area(of);
    const double height = inside.size.height > 0 ? inside.above.value_or(0) + inside.size.height : 0;
    return {own.width.value_or(inside.size.width), own.height.value_or(height)};
}

}  // namespace robochart::diagrams
