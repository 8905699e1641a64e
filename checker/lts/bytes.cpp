// SPDX-License-Identifier: Apache-2.0
#include "checker/lts/bytes.hpp"

#include <cassert>

namespace robochart::lts {

void ByteWriter::write_number(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7U) bytes_.push_back(static_cast<char>(value | 0x80U));
    bytes_.push_back(static_cast<char>(value));
}

std::uint64_t ByteReader::read_number() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; !bytes_.empty(); shift += 7) {
        const auto byte = static_cast<std::uint8_t>(bytes_.front());
        bytes_.remove_prefix(1);
        assert(shift <= 63);  // at most ten bytes: the tenth is 0 or 1, otherwise the number is too large
        if (shift == 63 && byte > 1) break;
        value |= std::uint64_t{byte & 0x7FU} << shift;
        if (byte < 0x80) return value;
    }
    throw BadBytes("a number is cut off or too large");
}

std::uint32_t ByteReader::read_below(std::uint64_t end) {
    assert(end <= std::uint64_t{1} << 32U);
    const std::uint64_t value = read_number();
    if (value >= end) throw BadBytes("a number is out of its range");
    return static_cast<std::uint32_t>(value);
}

std::size_t ByteReader::read_count() {
    const std::uint64_t value = read_number();
    if (value > bytes_.size()) throw BadBytes("more is announced than there is");
    return value;
}

void ByteReader::expect_end() const {
    if (!bytes_.empty()) throw BadBytes("something follows the end");
}

}  // namespace robochart::lts
