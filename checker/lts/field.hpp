// Values packed side by side in the words of a state.
#pragma once

#include <cstdint>
#include <span>

namespace robochart::lts {

/// Where a value lies in a packed state: in one word, `mask` wide from bit `shift` on.
struct Field {
    std::uint32_t word, shift, mask;
    [[nodiscard]] std::uint32_t get(std::span<const std::uint32_t> state) const {
        return (state[word] >> shift) & mask;
    }
    void put(std::span<std::uint32_t> state, std::uint32_t value) const {
        state[word] = (state[word] & ~(mask << shift)) | (value << shift);
    }
};

}  // namespace robochart::lts
