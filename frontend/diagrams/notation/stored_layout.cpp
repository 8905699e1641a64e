// SPDX-License-Identifier: Apache-2.0
// See stored_layout.hpp.
#include "frontend/diagrams/notation/stored_layout.hpp"

#include <algorithm>

namespace robochart::diagrams {

using frontend::Declaration;

namespace {

template <class Map, class Key>
auto find_value(const Map& map, const Key& key) {
    const auto at = map.find(key);
    return at == map.end() ? std::nullopt : std::optional(at->second);
}

}  // namespace

std::optional<layout::DrawnBox> StoredLayout::box_of(const Declaration* of) const {
    return find_value(boxes, of);
}

StoredArea StoredLayout::area_of(const Declaration* of) const {
    return find_value(areas, of).value_or(StoredArea());
}

std::optional<layout::DrawnEdge> StoredLayout::line_of(const Declaration* of) const {
    return find_value(lines, of);
}

std::optional<layout::DrawnPort> StoredLayout::port_of(const Declaration* owner, const Declaration* event) const {
    const auto at = squares.find(owner);
    return at == squares.end() ? std::nullopt : find_value(at->second, event);
}

layout::Size StoredLayout::size(const Declaration* of) const {
    const layout::DrawnBox own = box_of(of).value_or(layout::DrawnBox());
    const StoredArea inside = area_of(of);
    const double height = inside.size.height > 0 ? inside.above.value_or(0) + inside.size.height : 0;
    return {own.width.value_or(inside.size.width), own.height.value_or(height)};
}

}  // namespace robochart::diagrams
