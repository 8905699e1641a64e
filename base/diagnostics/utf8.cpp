// SPDX-License-Identifier: Apache-2.0
#include "base/diagnostics/utf8.hpp"

namespace robochart::diagnostics {

namespace {

/// Returns the length of the sequence that begins with this byte, or 0 if no sequence begins with it.
std::size_t sequence_length(unsigned lead) {
    if (lead < 0x80U) return 1;
    if (lead >= 0xC2U && lead <= 0xDFU) return 2;
    if ((lead & 0xF0U) == 0xE0U) return 3;
    if (lead >= 0xF0U && lead <= 0xF4U) return 4;
    return 0;
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
    if (text.empty()) return 0;
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    // The lengths of sequences and the allowed ranges of the second byte are those of Unicode 15, table 3-7.
    const std::size_t length = sequence_length(byte(0));
    if (length <= 1) return length;
    if (text.size() < length) return 0;
    unsigned low = 0x80U;
    if (byte(0) == 0xE0U) low = 0xA0U;
    if (byte(0) == 0xF0U) low = 0x90U;
    unsigned high = 0xBFU;
    if (byte(0) == 0xEDU) high = 0x9FU;
    if (byte(0) == 0xF4U) high = 0x8FU;
    if (byte(1) < low || byte(1) > high) return 0;
    for (std::size_t i = 2; i < length; ++i)
        if ((byte(i) & 0xC0U) != 0x80U) return 0;
    return length;
}

}  // namespace robochart::diagnostics
