// SPDX-License-Identifier: Apache-2.0
#include "checker/storage/row_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstring>

#include "base/diagnostics/escape.hpp"

namespace robochart::storage {
namespace {

using diagnostics::Hasher;
using Check = RowFile::Check;

constexpr std::string_view magic = "RVROWS\r\n";
constexpr std::uint32_t format = 1;
constexpr std::uint32_t no_level = 0xFFFFFFFFU;
constexpr std::size_t check_size = sizeof(Check);
constexpr std::size_t head_size = 8 + 4 + 4 + 32 + check_size;
constexpr std::size_t block_head = 12;

void write_number(std::string& out, std::uint64_t number, int bytes) {
    for (int i = 0; i < bytes; ++i) out.push_back(static_cast<char>(number >> (8 * i)));
}

std::uint64_t read_number(std::string_view bytes, std::size_t at, int count) {
    assert(at + static_cast<std::size_t>(count) <= bytes.size());
    std::uint64_t number = 0;
    for (int i = 0; i < count; ++i)
        number |= std::uint64_t{static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)])} << (8 * i);
    return number;
}

Check first_bytes(const diagnostics::Digest& digest) {
    Check check;
    std::copy_n(digest.begin(), check.size(), check.begin());
    return check;
}

std::string_view text_of(const Check& check) {
    return {reinterpret_cast<const char*>(check.data()), check.size()};
}

Check check_of_text(std::string_view text) {
    Hasher hasher;
    hasher.add(text);
    return first_bytes(hasher.finish());
}

std::string head_of(const RowKind& kind) {
    std::string head(magic);
    write_number(head, format, 4);
    write_number(head, kind.width, 4);
    head.append(reinterpret_cast<const char*>(kind.search.data()), kind.search.size());
    head += text_of(check_of_text(head));
    return head;
}

std::string cause_of_failure(const std::string& path, const char* cause) {
    return fmt::format("cannot write {}: {}", diagnostics::escape_for_display(path), cause);
}

[[noreturn]] void cannot_write(const std::string& path, const char* cause) {
    throw CannotWrite(cause_of_failure(path, cause));
}

}  // namespace

RowKind with_level(RowKind kind) {
    ++kind.width;
    return kind;
}

RowFile::RowFile(std::string path, const RowKind& kind) : path_(std::move(path)), kind_(kind) {}

RowFile RowFile::create(const std::string& path, const RowKind& kind) {
    RowFile made(path, kind);
    made.file_ =
        diagnostics::Descriptor(::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600));
    if (!made.file_.is_open()) cannot_write(path, std::strerror(errno));
    const std::string head = head_of(kind);
    std::copy_n(head.end() - check_size, check_size, made.head_check_.begin());
    try {
        made.write(head);
    } catch (const CannotWrite&) {
        ::unlink(path.c_str());
        throw;
    }
    return made;
}

void RowFile::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::pwrite(file_.get(), bytes.data(), bytes.size(), static_cast<off_t>(size_));
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) cannot_write(path_, written < 0 ? std::strerror(errno) : "nothing was written");
        size_ += static_cast<std::uint64_t>(written);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

RowFile::Check RowFile::check_of(std::size_t block, std::uint32_t level, std::uint32_t rows,
                                 std::string_view code) const {
    Hasher hasher;
    hasher.add(text_of(head_check_));
    hasher.add(block);
    hasher.add((std::uint64_t{level} << 32U) | rows);
    hasher.add(code);
    return first_bytes(hasher.finish());
}

void RowFile::append(std::uint32_t level, std::span<const Word> rows) {
    if (!lost_.empty()) throw CannotWrite(lost_);
    assert(!finished_ && (kind_.width == 0 || rows.size() % kind_.width == 0));
    const std::size_t blocks = blocks_.size();
    try {
        if (kind_.width == 0) return write_block(level, rows);
        const std::size_t words = rows_of_block * kind_.width;
        for (std::size_t at = 0; at < rows.size(); at += words)
            write_block(level, rows.subspan(at, std::min(words, rows.size() - at)));
    } catch (...) {
        remove_blocks_from(blocks);
        throw;
    }
}

/// Removes data after the last valid block, such as an incomplete block or the end mark. If the file is finished, it
/// may be closed or open only for reading, so it is opened again for writing.
void RowFile::remove_blocks_from(std::size_t blocks) {
    assert(blocks <= blocks_.size());
    if (finished_) {
        file_ = diagnostics::Descriptor(::open(path_.c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK));
        if (!file_.is_open()) lost_ = cause_of_failure(path_, std::strerror(errno));
    }
    finished_ = false;
    for (; blocks_.size() > blocks; blocks_.pop_back()) rows_ -= blocks_.back().rows;
    checks_.resize(blocks);
    firsts_.resize(blocks * kind_.width);
    size_ = blocks == 0 ? head_size : blocks_.back().offset + block_head + blocks_.back().bytes + check_size;
    (void)!::ftruncate(file_.get(), static_cast<off_t>(size_));
}

void RowFile::write_block(std::uint32_t level, std::span<const Word> rows) {
    const std::size_t count = kind_.width == 0 ? 1 : rows.size() / kind_.width;
    assert(count > 0 && count <= rows_of_block);
    assert(level != no_level && (blocks_.empty() || blocks_.back().level <= level));
    buffer_.assign(block_head, '\0');
    encode_rows(rows, kind_.width, buffer_);
    const std::string_view code = std::string_view(buffer_).substr(block_head);
    std::string head;
    write_number(head, level, 4);
    write_number(head, count, 4);
    write_number(head, code.size(), 4);
    checks_.push_back(check_of(blocks_.size(), level, static_cast<std::uint32_t>(count), code));
    blocks_.push_back({level, static_cast<std::uint32_t>(count), static_cast<std::uint32_t>(code.size()), size_});
    buffer_.replace(0, block_head, head);
    buffer_ += text_of(checks_.back());
    firsts_.insert(firsts_.end(), rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(kind_.width));
    rows_ += count;
    assert(checks_.size() == blocks_.size() && firsts_.size() == blocks_.size() * kind_.width);
    write(buffer_);
}

/// Returns the end of the file without its check.
std::string RowFile::end_of() const {
    std::string end;
    write_number(end, no_level, 4);
    write_number(end, 0, 4);
    write_number(end, 16, 4);
    write_number(end, blocks_.size(), 8);
    write_number(end, rows_, 8);
    return end;
}

namespace {

Check check_of_end(const Check& head, std::string_view end, const std::vector<Check>& blocks) {
    Hasher hasher;
    hasher.add(text_of(head));
    hasher.add(end);
    for (const Check& check : blocks) hasher.add(text_of(check));
    return first_bytes(hasher.finish());
}

}  // namespace

void RowFile::finish() {
    if (!lost_.empty()) throw CannotWrite(lost_);
    try {
        const std::string end = end_of();
        end_check_ = check_of_end(head_check_, end, checks_);
        write(end + std::string(text_of(end_check_)));
        reach_disk();
    } catch (...) {
        remove_blocks_from(blocks_.size());
        throw;
    }
    finished_ = true;
}

void RowFile::reach_disk() {
    if (::fsync(file_.get()) == 0) return;
    lost_ = cause_of_failure(path_, std::strerror(errno));
    throw CannotWrite(lost_);
}

void RowFile::throw_bad_file(std::uint64_t offset, const std::string& cause) const {
    throw BadFile(fmt::format("{}: byte {}: {}", diagnostics::escape_for_display(path_), offset, cause));
}

void RowFile::close_until_read() {
    if (finished_) file_ = diagnostics::Descriptor();
}

/// If another file has replaced this one, reading detects it, because the checks of the blocks do not match.
void RowFile::open_to_read() const {
    file_ = diagnostics::Descriptor(::open(path_.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK));
    if (!file_.is_open()) cannot_open(path_, errno);
}

void RowFile::read_bytes(std::uint64_t offset, std::size_t count, std::string& bytes) const {
    if (!file_.is_open()) open_to_read();
    bytes.resize(count);
    for (std::size_t have = 0; have < count;) {
        const ssize_t got = ::pread(file_.get(), bytes.data() + have, count - have, static_cast<off_t>(offset + have));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) throw_bad_file(offset, fmt::format("cannot be read: {}", std::strerror(errno)));
        if (got == 0) throw_bad_file(offset + have, "the file ends here; it was cut off");
        have += static_cast<std::size_t>(got);
    }
}

Check RowFile::read_code(std::size_t block, std::string& code) const {
    assert(block < blocks_.size());
    const Block& at = blocks_[block];
    read_bytes(at.offset + block_head, at.bytes + check_size, code);
    const Check check = check_of(block, at.level, at.rows, std::string_view(code).substr(0, at.bytes));
    if (std::string_view(code).substr(at.bytes) != text_of(check))
        throw_bad_file(at.offset, fmt::format("block {} is damaged", block));
    code.resize(at.bytes);
    return check;
}

void RowFile::read(std::size_t block, std::vector<Word>& rows) const {
    (void)read_checked(block, rows);
}

Check RowFile::read_checked(std::size_t block, std::vector<Word>& rows) const {
    const Check check = read_code(block, buffer_);
    const Block& at = blocks_[block];
    if (!decode_rows(buffer_, kind_.width, at.rows, rows))
        throw_bad_file(at.offset, fmt::format("block {} has no rows", block));
    return check;
}

RowFile RowFile::open(const std::string& path, const RowKind& kind, diagnostics::Pollable& budget) {
    RowFile opened(path, kind);
    opened.open_to_read();
    struct stat found {};
    if (fstat(opened.file_.get(), &found) != 0 || !S_ISREG(found.st_mode)) opened.throw_bad_file(0, "this is no file");
    opened.read_head();
    opened.read_blocks(budget);
    return opened;
}

void RowFile::read_head() {
    std::string head;
    read_bytes(0, head_size, head);
    if (!head.starts_with(magic)) throw_bad_file(0, "this is no file of rows");
    if (read_number(head, 8, 4) != format)
        throw_bad_file(8,
                       fmt::format("the file has format {}, this program reads {}", read_number(head, 8, 4), format));
    const Check check = check_of_text(std::string_view(head).substr(0, head_size - check_size));
    if (head.substr(head_size - check_size) != text_of(check)) throw_bad_file(0, "the head is damaged");
    if (head != head_of(kind_)) throw_bad_file(12, "the file belongs to another search");
    head_check_ = check;
    size_ = head_size;
}

void RowFile::read_blocks(diagnostics::Pollable& budget) {
    std::string head;
    std::vector<Word> rows;
    std::vector<Word> last;  // last row of the previous block
    std::uint32_t level = 0;
    for (;;) {
        budget.poll();
        read_bytes(size_, block_head, head);
        const Block block{static_cast<std::uint32_t>(read_number(head, 0, 4)),
                          static_cast<std::uint32_t>(read_number(head, 4, 4)),
                          static_cast<std::uint32_t>(read_number(head, 8, 4)), size_};
        if (block.level == no_level) break;
        const std::size_t longest = rows_of_block * 10 * std::max<std::size_t>(kind_.width, 1);  // varints
        if (block.rows == 0 || block.rows > rows_of_block || block.bytes > longest)
            throw_bad_file(size_, fmt::format("block {} is damaged", blocks_.size()));
        blocks_.push_back(block);
        rows.clear();
        checks_.push_back(read_checked(blocks_.size() - 1, rows));
        const auto width = static_cast<std::ptrdiff_t>(kind_.width);
        const bool same_level = blocks_.size() > 1 && block.level == level;
        if (block.level < level || (same_level && !(last < std::vector<Word>(rows.begin(), rows.begin() + width))))
            throw_bad_file(size_, fmt::format("block {} is out of order", blocks_.size() - 1));
        firsts_.insert(firsts_.end(), rows.begin(), rows.begin() + width);
        last.assign(rows.end() - width, rows.end());
        level = block.level;
        rows_ += block.rows;
        size_ += block_head + block.bytes + check_size;
    }
    const std::string end = end_of();
    std::string found;
    read_bytes(size_, end.size() + check_size, found);
    end_check_ = check_of_end(head_check_, end, checks_);
    if (found != end + std::string(text_of(end_check_))) throw_bad_file(size_, "the end is damaged");
    size_ += found.size();
    std::string more(1, '\0');
    if (::pread(file_.get(), more.data(), 1, static_cast<off_t>(size_)) != 0)
        throw_bad_file(size_, "more follows the end");
    finished_ = true;
    checks_ = {};
}

}  // namespace robochart::storage
