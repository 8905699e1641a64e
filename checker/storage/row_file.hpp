// A file of rows, level by level, in blocks that can be read in any order. All numbers are little-endian.
//
//   head    8 bytes "RVROWS\r\n", format (4 bytes), words of a row (4), digest of what the rows belong to (32),
//           check of these (16)
//   block   level (4), rows (4), bytes of the code (4), the code (row_codec.hpp), check (16)
//   ...     the blocks of a level follow each other; each row is less than those after it, also in the next block
//   end     0xffffffff (4), 0 (4), 16 (4), blocks (8), rows (8), check (16)
//
// Checks are the first 16 bytes of a BLAKE2b digest: of a block, of the head's check, the number of the block, level,
// rows and code; of the end, of the head's check, the numbers, and the checks of all blocks. So no block can be
// missing, damaged, in another place, or from another file.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "checker/storage/row_codec.hpp"
#include "checker/storage/storage_error.hpp"
#include "diagnostics/cache/digest.hpp"
#include "diagnostics/descriptor.hpp"

namespace robochart::storage {

/// What the rows of a file are: their width, and a digest of the search that has found them.
struct RowKind {
    std::size_t width = 0;
    diagnostics::Digest search{};
};

/// That of such rows with their levels behind, a word more.
[[nodiscard]] RowKind with_level(RowKind kind);

/// Takes some rows.
using TakeRows = std::function<void(std::span<const Word>)>;

class RowFile {
public:
    struct Block {
        std::uint32_t level;
        std::uint32_t rows;
        std::uint32_t bytes;   ///< of the code
        std::uint64_t offset;  ///< of the block in the file
    };
    using Check = std::array<std::uint8_t, 16>;
    static constexpr std::size_t rows_of_block = 8192;

    /// A new file, which must not be there yet. Throws CannotWrite.
    static RowFile create(const std::string& path, const RowKind& kind);
    /// An existing one, which is read and checked as a whole. `poll` is called now and then, and may throw. Throws
    /// BadFile.
    static RowFile open(const std::string& path, const RowKind& kind, const std::function<void()>& poll);

    /// Appends rows of one level, ascending, none twice, after those of this level that are there. Throws CannotWrite;
    /// the file is then as it was before, also after any other exception.
    void append(std::uint32_t level, std::span<const Word> rows);
    /// Takes the blocks from this number on back, of a file that was created and that nobody counts on; it is then not
    /// finished.
    void cut(std::size_t blocks);
    /// Nothing more is appended; what was is on the disk. Throws CannotWrite; the file is then as before. Where it has
    /// failed to reach the disk, nobody knows what of it has: it can be read, but neither be finished nor grow any
    /// more.
    void finish();
    [[nodiscard]] bool finished() const { return finished_; }
    /// A finished file is not kept open until it is read again: few may be open at a time.
    void rest();

    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }
    [[nodiscard]] std::uint64_t rows() const { return rows_; }
    /// Bytes of the file so far.
    [[nodiscard]] std::uint64_t size() const { return size_; }
    /// The first row of a block, which is in memory.
    [[nodiscard]] std::span<const Word> first(std::size_t block) const {
        return std::span(firsts_).subspan(block * kind_.width, kind_.width);
    }
    /// The rows of a block, at the end of `rows`. Throws BadFile where they are no longer what was written.
    void read(std::size_t block, std::vector<Word>& rows) const;
    /// The code of these rows (row_codec.hpp). Gives its check.
    Check read_code(std::size_t block, std::string& code) const;
    /// In memory: of each block where it is, its first row, and its check.
    [[nodiscard]] std::uint64_t bytes() const {
        return blocks_.capacity() * sizeof(Block) + checks_.capacity() * sizeof(Check) +
               firsts_.capacity() * sizeof(Word);
    }
    /// The check at the end of a finished file, which no other file has.
    [[nodiscard]] const Check& check() const { return end_check_; }

private:
    RowFile(std::string path, const RowKind& kind);
    [[nodiscard]] Check check_of(std::size_t block, std::uint32_t level, std::uint32_t rows,
                                 std::string_view code) const;
    void write(std::string_view bytes);
    void write_block(std::uint32_t level, std::span<const Word> rows);
    [[nodiscard]] std::string end_of() const;
    void reach_disk();
    void open_to_read() const;
    [[noreturn]] void bad(std::uint64_t offset, const std::string& cause) const;
    Check read_checked(std::size_t block, std::vector<Word>& rows) const;
    void read_bytes(std::uint64_t offset, std::size_t count, std::string& bytes) const;
    void read_head();
    void read_blocks(const std::function<void()>& poll);

    std::string path_;
    RowKind kind_;
    mutable diagnostics::Descriptor file_;  ///< not open while it rests
    std::vector<Block> blocks_;
    std::vector<Word> firsts_;   ///< rows, of the blocks
    std::vector<Check> checks_;  ///< of the blocks, of a file that was created, and while one is opened
    std::uint64_t rows_ = 0;
    std::uint64_t size_ = 0;
    bool finished_ = false;
    std::string lost_;  ///< why it could not be finished; "": it can still grow
    Check head_check_{};
    Check end_check_{};
    mutable std::string buffer_;
};

}  // namespace robochart::storage
