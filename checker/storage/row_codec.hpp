// Rows in ascending order as few bytes: each as its difference from the row before it.
//
// A row is a fixed number of words; rows are ordered by the first word, then the second, and so on. Where row r follows
// row q and the first word that differs is that of number k, the code is the number
// (r[k] - q[k] - 1) * width + (width - 1 - k), and then, for each word i > k, the number r[i] xor q[i]. Of the first
// row each word is a number. Numbers are varints: seven bits a byte, the lowest first, the top bit set in all bytes but
// the last.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace robochart::storage {

using Word = std::uint32_t;

/// Appends the code of rows, ascending and without duplicates. `rows`: a multiple of `width` words.
void encode_rows(std::span<const Word> rows, std::size_t width, std::string& out);
/// Appends `count` rows of such a code. False where the bytes are no code of so many rows: then the words appended so
/// far are without meaning. Rows that it gives are ascending and without duplicates.
[[nodiscard]] bool decode_rows(std::string_view bytes, std::size_t width, std::size_t count, std::vector<Word>& rows);

/// Decodes such a code piece by piece.
class RowDecoder {
public:
    /// `bytes` outlive it. `width`: words of a row, not 0.
    RowDecoder(std::string_view bytes, std::size_t width)
        : at_(bytes.data()), end_(bytes.data() + bytes.size()), width_(width) {}
    /// Appends the next `count` rows. False where the bytes that are left are no code of so many rows.
    [[nodiscard]] bool decode(std::size_t count, std::vector<Word>& rows);
    [[nodiscard]] bool at_end() const { return at_ == end_; }

private:
    template <std::size_t fixed>
    bool decode_after(std::size_t count, Word* row);

    const char* at_;
    const char* end_;
    std::size_t width_;
    std::vector<Word> last_;  ///< the row that was decoded last; empty: none was
};

}  // namespace robochart::storage
