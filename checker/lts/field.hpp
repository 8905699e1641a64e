// SPDX-License-Identifier: Apache-2.0
// Reads and writes values that share the words of a state.
#pragma once

#include <cassert>
#include <cstdint>
#include <span>

namespace robochart::lts {

/// The position of a value in a packed state. The value is in one word. The value begins at bit `shift`, and `mask` has
/// a one for each bit of the value.
struct Field {
    std::uint32_t word, shift, mask;
    [[nodiscard]] std::uint32_t get(std::span<const std::uint32_t> state) const {
        assert(word < state.size() && shift < 32);
        return (state[word] >> shift) & mask;
    }
    void put(std::span<std::uint32_t> state, std::uint32_t value) const {
        assert(word < state.size() && shift < 32);
        assert((value & ~mask) == 0);  // a larger value would change its neighbours
        state[word] = (state[word] & ~(mask << shift)) | (value << shift);
    }
};

}  // namespace robochart::lts
