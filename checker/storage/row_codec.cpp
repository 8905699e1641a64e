// SPDX-License-Identifier: Apache-2.0
#include "checker/storage/row_codec.hpp"

#include <cassert>
#include <limits>
#include <stdexcept>

namespace robochart::storage {
namespace {

void put_number(std::uint64_t number, std::string& out) {
    for (; number >= 0x80U; number >>= 7U) out.push_back(static_cast<char>(number | 0x80U));
    out.push_back(static_cast<char>(number));
}

/// Reads varints. `failed` returns true after an invalid varint.
class Numbers {
public:
    explicit Numbers(std::string_view bytes) : at_(bytes.data()), end_(bytes.data() + bytes.size()) {}
    std::uint64_t read_number() {
        std::uint64_t number = 0;
        for (unsigned shift = 0; at_ != end_ && shift < 63; shift += 7) {
            const auto byte = static_cast<unsigned char>(*at_++);
            number |= std::uint64_t{byte & 0x7FU} << shift;
            if ((byte & 0x80U) == 0) return number;
        }
        failed_ = true;
        return 0;
    }
    Word next_word() {
        const std::uint64_t number = read_number();
        if (number > std::numeric_limits<Word>::max()) failed_ = true;
        return static_cast<Word>(number);
    }
    [[nodiscard]] bool has_failed() const { return failed_; }
    [[nodiscard]] const char* position() const { return at_; }

private:
    const char* at_;
    const char* end_;
    bool failed_ = false;
};

}  // namespace

void encode_rows(std::span<const Word> rows, std::size_t width, std::string& out) {
    if (width == 0) return;
    assert(rows.size() % width == 0);
    for (std::size_t i = 0; i < width && i < rows.size(); ++i) put_number(rows[i], out);
    for (std::size_t at = width; at < rows.size(); at += width) {
        const Word* const row = &rows[at];
        const Word* const before = row - width;
        std::size_t k = 0;
        while (k < width && row[k] == before[k]) ++k;
        if (k == width) throw std::logic_error("a row is there twice");
        assert(row[k] > before[k]);  // rows are ascending
        put_number(std::uint64_t{row[k] - before[k] - 1} * width + (width - 1 - k), out);
        for (std::size_t i = k + 1; i < width; ++i) put_number(row[i] ^ before[i], out);
    }
}

bool decode_rows(std::string_view bytes, std::size_t width, std::size_t count, std::vector<Word>& rows) {
    if (width == 0) return bytes.empty() && count <= 1;
    RowDecoder decoder(bytes, width);
    return decoder.decode(count, rows) && decoder.at_end();
}

bool RowDecoder::decode(std::size_t count, std::vector<Word>& rows) {
    if (count > static_cast<std::size_t>(end_ - at_)) return false;  // each row has at least one byte
    if (count == 0) return true;
    assert(width_ > 0 && (last_.empty() || last_.size() == width_));
    const std::size_t begin = rows.size();
    rows.resize(begin + count * width_);
    Word* row = &rows[begin];
    if (last_.empty()) {
        Numbers numbers({at_, static_cast<std::size_t>(end_ - at_)});
        for (std::size_t i = 0; i < width_; ++i) row[i] = numbers.next_word();
        at_ = numbers.position();
        if (numbers.has_failed()) return false;
        last_.assign(row, row + width_);
        row += width_;
        --count;
    }
    bool good = false;
    switch (width_) {
        case 1:
            good = decode_after<1>(count, row);
            break;
        case 2:
            good = decode_after<2>(count, row);
            break;
        case 3:
            good = decode_after<3>(count, row);
            break;
        default:
            good = decode_after<0>(count, row);
    }
    last_.assign(rows.end() - static_cast<std::ptrdiff_t>(width_), rows.end());
    return good;
}

/// Decodes the rows that follow `last_`. `fixed` is their width as a constant, which makes divisions by the width fast;
/// 0 stands for any width.
template <std::size_t fixed>
bool RowDecoder::decode_after(std::size_t count, Word* row) {
    const std::size_t width = fixed == 0 ? width_ : fixed;
    Numbers numbers({at_, static_cast<std::size_t>(end_ - at_)});
    const Word* before = last_.data();
    for (; count > 0 && !numbers.has_failed(); --count) {
        const std::uint64_t first = numbers.read_number();
        const std::size_t k = width - 1 - first % width;
        const std::uint64_t changed = before[k] + first / width + 1;
        if (changed > std::numeric_limits<Word>::max()) return false;
        for (std::size_t i = 0; i < k; ++i) row[i] = before[i];
        row[k] = static_cast<Word>(changed);
        for (std::size_t i = k + 1; i < width; ++i) row[i] = numbers.next_word() ^ before[i];
        before = row;
        row += width;
    }
    at_ = numbers.position();
    return !numbers.has_failed();
}

}  // namespace robochart::storage
