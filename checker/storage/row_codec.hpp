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

}  // namespace robochart::storage
