// SPDX-License-Identifier: Apache-2.0
// Encodes ascending rows compactly: each row is stored as its difference from the previous row.
//
// A row is a fixed number of words. Rows are ordered by the first word, then the second, and so on. If row r follows
// row q and k is the index of the first word that differs, the code is the number (r[k] - q[k] - 1) * width + (width -
// 1 - k), followed, for each word i > k, by the number r[i] xor q[i]. For the first row each word is a number. Numbers
// are varints: seven bits in each byte, the lowest first, the top bit set in all bytes except the last.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace robochart::storage {

using Word = std::uint32_t;

/// Appends the code of ascending rows without duplicates. The size of `rows` is a multiple of `width` words.
void encode_rows(std::span<const Word> rows, std::size_t width, std::string& out);
/// Decodes `count` rows and appends them to `rows`. Returns false if the bytes do not encode this many rows; the words
/// appended so far are then invalid. Decoded rows are ascending and without duplicates.
[[nodiscard]] bool decode_rows(std::string_view bytes, std::size_t width, std::size_t count, std::vector<Word>& rows);

/// Decodes rows piece by piece.
class RowDecoder {
public:
    /// `bytes` must outlive the object. `width` is the number of words in a row, and not 0.
    RowDecoder(std::string_view bytes, std::size_t width)
        : at_(bytes.data()), end_(bytes.data() + bytes.size()), width_(width) {}
    /// Decodes the next `count` rows and appends them to `rows`. Returns false if the remaining bytes do not encode
    /// this many rows.
    [[nodiscard]] bool decode(std::size_t count, std::vector<Word>& rows);
    [[nodiscard]] bool at_end() const { return at_ == end_; }

private:
    template <std::size_t fixed>
    bool decode_after(std::size_t count, Word* row);

    const char* at_;
    const char* end_;
    std::size_t width_;
    std::vector<Word> last_;  ///< the last decoded row; empty before the first one
};

}  // namespace robochart::storage
