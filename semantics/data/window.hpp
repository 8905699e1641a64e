// SPDX-License-Identifier: Apache-2.0
// A number of a sequence that conditions read: the least or greatest one at some places.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

namespace robochart::ir {

struct SequenceWindow {
    std::vector<std::int64_t> places;  ///< from 1 on, ascending, without duplicates
    bool greatest = false;
    friend auto operator<=>(const SequenceWindow&, const SequenceWindow&) = default;
};

}  // namespace robochart::ir
