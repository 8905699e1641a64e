// SPDX-License-Identifier: Apache-2.0
// Describes a number that conditions read from a sequence: the least or the greatest number at some of its places.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

namespace robochart::ir {

struct SequenceWindow {
    std::vector<std::int64_t> places;  ///< counted from 1, ascending, without duplicates
    bool greatest = false;
    friend auto operator<=>(const SequenceWindow&, const SequenceWindow&) = default;
};

}  // namespace robochart::ir
