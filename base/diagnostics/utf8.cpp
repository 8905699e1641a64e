// SPDX-License-Identifier: Apache-2.0
#include "base/diagnostics/utf8.hpp"

namespace robochart::diagnostics {

std::size_t utf8_length(std::string_view text) {
    if (text.empty()) return 0;
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (byte(0) < 0x80U) return 1;
    // Unicode 15, table 3-7: the lengths of sequences and the allowed ranges of the second byte.
    const std::size_t length = byte(0) >= 0xC2U && byte(0) <= 0xDFU   ? 2
                               : (byte(0) & 0xF0U) == 0xE0U           ? 3
                               : byte(0) >= 0xF0U && byte(0) <= 0xF4U ? 4
                                                                      : 0;
    if (length == 0 || text.size() < length) return 0;
    const unsigned low = byte(0) == 0xE0U ? 0xA0U : byte(0) == 0xF0U ? 0x90U : 0x80U;
    const unsigned high = byte(0) == 0xEDU ? 0x9FU : byte(0) == 0xF4U ? 0x8FU : 0xBFU;
    if (byte(1) < low || byte(1) > high) return 0;
    for (std::size_t i = 2; i < length; ++i)
        if ((byte(i) & 0xC0U) != 0x80U) return 0;
    return length;
}

}  // namespace robochart::diagnostics
