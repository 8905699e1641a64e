#include "checker/storage/row_codec.hpp"

#include <limits>

namespace robochart::storage {
namespace {

void put(std::uint64_t number, std::string& out) {
    for (; number >= 0x80U; number >>= 7U) out.push_back(static_cast<char>(number | 0x80U));
    out.push_back(static_cast<char>(number));
}

/// Reads varints; `failed` once there was none.
class Numbers {
public:
    explicit Numbers(std::string_view bytes) : at_(bytes.data()), end_(bytes.data() + bytes.size()) {}
    std::uint64_t next() {
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
        const std::uint64_t number = next();
        if (number > std::numeric_limits<Word>::max()) failed_ = true;
        return static_cast<Word>(number);
    }
    [[nodiscard]] bool failed() const { return failed_; }
    [[nodiscard]] bool at_end() const { return at_ == end_; }

private:
    const char* at_;
    const char* end_;
    bool failed_ = false;
};

}  // namespace

void encode_rows(std::span<const Word> rows, std::size_t width, std::string& out) {
    if (width == 0) return;
    for (std::size_t i = 0; i < width && i < rows.size(); ++i) put(rows[i], out);
    for (std::size_t at = width; at < rows.size(); at += width) {
        const Word* const row = &rows[at];
        const Word* const before = row - width;
        std::size_t k = 0;
        while (row[k] == before[k]) ++k;
        put(std::uint64_t{row[k] - before[k] - 1} * width + (width - 1 - k), out);
        for (std::size_t i = k + 1; i < width; ++i) put(row[i] ^ before[i], out);
    }
}

bool decode_rows(std::string_view bytes, std::size_t width, std::size_t count, std::vector<Word>& rows) {
    if (width == 0) return bytes.empty() && count <= 1;
    if (count > bytes.size()) return false;  // each row has a byte at least
    Numbers numbers(bytes);
    std::size_t at = rows.size();
    rows.resize(at + count * width);
    for (std::size_t i = 0; i < width && count > 0; ++i) rows[at + i] = numbers.next_word();
    for (std::size_t number = 1; number < count && !numbers.failed(); ++number) {
        const Word* const before = &rows[at];
        at += width;
        Word* const row = &rows[at];
        const std::uint64_t first = numbers.next();
        const std::size_t k = width - 1 - first % width;
        const std::uint64_t changed = before[k] + first / width + 1;
        if (changed > std::numeric_limits<Word>::max()) return false;
        for (std::size_t i = 0; i < k; ++i) row[i] = before[i];
        row[k] = static_cast<Word>(changed);
        for (std::size_t i = k + 1; i < width; ++i) row[i] = numbers.next_word() ^ before[i];
    }
    return !numbers.failed() && numbers.at_end();
}

}  // namespace robochart::storage
