// SPDX-License-Identifier: Apache-2.0
// Encodes numbers as bytes. Each byte contains seven bits of the number, the lowest bits first. The highest bit of a
// byte is set if further bytes of the number follow.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace robochart::cspm {

using Bytes = std::vector<std::uint8_t>;

inline void put_number(std::uint64_t number, Bytes& out) {
    while (number >= 0x80U) {
        out.push_back(static_cast<std::uint8_t>(number | 0x80U));
        number >>= 7U;
    }
    out.push_back(static_cast<std::uint8_t>(number));
}

/// Writes a signed number. A negative number needs as few bytes as a positive one of similar size.
inline void put_signed(std::int64_t number, Bytes& out) {
    const auto bits = static_cast<std::uint64_t>(number);
    put_number((bits << 1U) ^ (number < 0 ? ~std::uint64_t{0} : 0), out);
}

/// Reads numbers and bytes from a buffer. The buffer may contain further data after them.
class ByteReader {
public:
    explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    [[nodiscard]] std::uint8_t read_byte() {
        assert(at_ < bytes_.size());
        return bytes_[at_++];
    }
    [[nodiscard]] std::uint8_t peek() const {
        assert(at_ < bytes_.size());
        return bytes_[at_];
    }
    [[nodiscard]] std::uint64_t read_number() {
        std::uint64_t result = 0;
        for (unsigned shift = 0;; shift += 7) {
            assert(shift < 64);
            const std::uint8_t next = read_byte();
            result |= std::uint64_t{next & 0x7FU} << shift;
            if (next < 0x80U) return result;
        }
    }
    [[nodiscard]] std::int64_t signed_number() {
        const std::uint64_t bits = read_number();
        return static_cast<std::int64_t>((bits >> 1U) ^ (~(bits & 1U) + 1U));
    }
    [[nodiscard]] std::size_t position() const { return at_; }
    [[nodiscard]] std::span<const std::uint8_t> bytes_since(std::size_t begin) const {
        assert(begin <= at_);
        return bytes_.subspan(begin, at_ - begin);
    }

private:
    std::span<const std::uint8_t> bytes_;
    std::size_t at_ = 0;
};

}  // namespace robochart::cspm
