// SPDX-License-Identifier: Apache-2.0
// A file of rows, level by level, in blocks that can be read in any order. All numbers are little-endian.
//
//   head    8 bytes "RVROWS\r\n", format (4 bytes), words in a row (4), digest of what the rows belong to (32),
//           check of these (16)
//   block   level (4), rows (4), bytes of the code (4), the code (row_codec.hpp), check (16)
//   ...     the blocks of a level follow each other; each row is less than those after it, also in the next block
//   end     0xffffffff (4), 0 (4), 16 (4), blocks (8), rows (8), check (16)
//
// Checks are the first 16 bytes of a BLAKE2b digest. A block's check covers the head's check, the number of the block,
// level, rows and code; the end's check covers the head's check, the numbers, and the checks of all blocks. So blocks
// that are missing, damaged, in another place or from another file are detected.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/cache/digest.hpp"
#include "base/diagnostics/descriptor.hpp"
#include "base/diagnostics/pollable.hpp"
#include "checker/storage/row_codec.hpp"
#include "checker/storage/storage_error.hpp"

namespace robochart::storage {

/// Identifies the rows of a file by their width and a digest of the search that has found them.
struct RowKind {
    std::size_t width = 0;
    diagnostics::Digest search{};
};

/// Returns the kind of rows that consist of a row of this kind and its level as an additional word.
[[nodiscard]] RowKind with_level(RowKind kind);

/// A function that receives some rows.
using TakeRows = std::function<void(std::span<const Word>)>;

class RowFile {
public:
    struct Block {
        std::uint32_t level;
        std::uint32_t rows;
        std::uint32_t bytes;   ///< bytes of the code
        std::uint64_t offset;  ///< offset of the block in the file
    };
    using Check = std::array<std::uint8_t, 16>;
    static constexpr std::size_t rows_of_block = 8192;

    /// Creates a new file, which must not exist. Throws CannotWrite.
    static RowFile create(const std::string& path, const RowKind& kind);
    /// Opens an existing file, and reads and checks all of it. Polls the budget for each block. Throws BadFile.
    static RowFile open(const std::string& path, const RowKind& kind, diagnostics::Pollable& budget);

    /// Appends rows to the last level or to a new one. The rows must be ascending, without duplicates, and greater than
    /// the rows of this level in the file. Throws CannotWrite. After any exception the file is unchanged.
    void append(std::uint32_t level, std::span<const Word> rows);
    /// Removes all blocks from number `blocks` on. This object must have created the file, and nothing may refer to the
    /// removed blocks. The file is then no longer finished.
    void remove_blocks_from(std::size_t blocks);
    /// Completes the file: writes its end and waits until its contents are on the disk. Afterwards no rows can be
    /// appended. If this throws CannotWrite, the file is unchanged. If the system could not write the contents to the
    /// disk, the file can still be read, but can neither be finished nor extended.
    void finish();
    [[nodiscard]] bool finished() const { return finished_; }
    /// Closes a finished file until it is read again. The number of open files is limited.
    void close_until_read();

    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }
    [[nodiscard]] std::uint64_t rows() const { return rows_; }
    /// Returns the current size of the file in bytes.
    [[nodiscard]] std::uint64_t size() const { return size_; }
    /// Returns the first row of a block, which is stored in memory.
    [[nodiscard]] std::span<const Word> first_row(std::size_t block) const {
        return std::span(firsts_).subspan(block * kind_.width, kind_.width);
    }
    /// Reads the rows of a block and appends them to `rows`. Throws BadFile if they differ from what was written.
    void read(std::size_t block, std::vector<Word>& rows) const;
    /// Reads the encoded rows of a block (row_codec.hpp) into `code`. Returns the check of the block.
    Check read_code(std::size_t block, std::string& code) const;
    /// Returns the memory in bytes for the offset, first row and check of each block.
    [[nodiscard]] std::uint64_t bytes() const {
        return blocks_.capacity() * sizeof(Block) + checks_.capacity() * sizeof(Check) +
               firsts_.capacity() * sizeof(Word);
    }
    /// Returns the check at the end of a finished file. This check identifies the file.
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
    [[noreturn]] void throw_bad_file(std::uint64_t offset, const std::string& cause) const;
    Check read_checked(std::size_t block, std::vector<Word>& rows) const;
    void read_bytes(std::uint64_t offset, std::size_t count, std::string& bytes) const;
    void read_head();
    void read_blocks(diagnostics::Pollable& budget);

    std::string path_;
    RowKind kind_;
    mutable diagnostics::Descriptor file_;  ///< closed while the file is not in use
    std::vector<Block> blocks_;
    std::vector<Word> firsts_;   ///< first rows of the blocks
    std::vector<Check> checks_;  ///< checks of the blocks, for a created file and while one is opened
    std::uint64_t rows_ = 0;
    std::uint64_t size_ = 0;
    bool finished_ = false;
    std::string lost_;  ///< the reason why the file could not be finished; "" if the file can still grow
    Check head_check_{};
    Check end_check_{};
    mutable std::string buffer_;
};

}  // namespace robochart::storage
