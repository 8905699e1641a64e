// SPDX-License-Identifier: Apache-2.0
// Describes a number that conditions read from a sequence: the least or the greatest number at some of its places, or
// at all of them.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

namespace robochart::ir {

/// The last place of windows. It represents itself and all places after it, so only the window of all places has it.
inline constexpr std::int64_t last_place = 4096;

struct SequenceWindow {
    std::vector<std::int64_t> places;  ///< counted from 1, ascending, without duplicates; all up to last_place: all
    bool greatest = false;
    friend auto operator<=>(const SequenceWindow&, const SequenceWindow&) = default;
};

}  // namespace robochart::ir
