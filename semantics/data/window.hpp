// SPDX-License-Identifier: Apache-2.0
// Describes a number that a condition reads from a sequence: the least or the greatest number in a window. A window
// contains some places of the sequence, or all of them.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace robochart::ir {

/// Represents this place and all places after it. Only the window of all places contains it.
inline constexpr std::int64_t last_place = 4096;

struct SequenceWindow {
    std::vector<std::int64_t> places;  ///< counted from 1, ascending, without duplicates; all up to last_place: all
    bool greatest = false;
    friend auto operator<=>(const SequenceWindow&, const SequenceWindow&) = default;
};

/// Calls `visit` with the indices, from 0 on and ascending, of the items that a sequence of this length has in the
/// window.
template <class Visit>
void visit_items(const SequenceWindow& window, std::size_t length, Visit visit) {
    for (const std::int64_t place : window.places) {
        if (static_cast<std::size_t>(place) > length) return;
        visit(static_cast<std::size_t>(place - 1));
    }
    if (window.places.empty() || window.places.back() != last_place) return;
    for (auto index = static_cast<std::size_t>(last_place); index < length; ++index) visit(index);
}

/// Returns the least (or greatest) number in the window. `number_at` gives the number of each item. Returns no value if
/// the sequence has no item in the window.
template <class NumberAt>
[[nodiscard]] auto extremum_in(const SequenceWindow& window, bool greatest, std::size_t length, NumberAt number_at) {
    std::optional<decltype(number_at(length))> result;
    visit_items(window, length, [&](std::size_t index) {
        const auto number = number_at(index);
        if (!result || (greatest ? number > *result : number < *result)) result = number;
    });
    return result;
}

}  // namespace robochart::ir
