// SPDX-License-Identifier: Apache-2.0
// Stores the levels of one rank of a search in files of a folder. Levels are written in order and read in any order. A
// checkpoint makes them permanent.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/storage/checkpoint.hpp"
#include "checker/storage/row_file.hpp"

namespace robochart::storage {

/// Where a rank stores its files.
struct FolderOf {
    std::string folder;  ///< must exist
    RowKind kind;
    Place place;
};

class LevelFiles {
public:
    explicit LevelFiles(FolderOf where) : where_(std::move(where)) {}

    /// Takes over the levels of a checkpoint of this rank. Reads and checks all its files. The caller must limit the
    /// number of levels. Polls the budget for each block. Throws BadFile.
    void adopt(const Checkpoint& checkpoint, diagnostics::Pollable& budget);

    [[nodiscard]] std::uint32_t levels() const { return static_cast<std::uint32_t>(levels_.size()); }
    [[nodiscard]] std::uint64_t rows(std::uint32_t level) const { return levels_[level].rows; }
    [[nodiscard]] std::uint64_t rows() const { return rows_; }

    /// Appends the next level. `rows` must be ascending and without duplicates; it may be empty. Throws CannotWrite and
    /// then leaves everything unchanged.
    void add_level(std::span<const Word> rows);
    /// Appends the next level. `give` passes its rows piece by piece, ascending and without duplicates. Each piece
    /// except the last has RowFile::rows_of_block rows. Also throws the exceptions of `give`.
    void add_level(const std::function<void(const TakeRows&)>& give);
    /// Drops at most `count` of the last levels to free space, but no level of the last checkpoint. Returns the number
    /// of dropped levels.
    std::uint32_t give_up(std::uint32_t count);
    /// Removes this level and all later levels. Frees their disk space, except in files that a checkpoint names.
    void forget_from(std::uint32_t level);

    /// Appends at most `most` rows of a level to `rows`, beginning with row number `first`. Returns the number of
    /// appended rows. Throws BadFile.
    std::size_t read(std::uint32_t level, std::uint64_t first, std::size_t most, std::vector<Word>& rows);
    /// Calls `visit` with the rows of each block of a level; blocks and rows are ascending. Throws BadFile.
    void each_block(std::uint32_t level, const TakeRows& visit);

    /// Calls `visit` with each block of a level for which `wants` returns true, ascending. The arguments of `wants` are
    /// the first row of the block and the first row of the next block (empty for the last block). Throws BadFile.
    using WantsBlock = std::function<bool(std::span<const Word> first, std::span<const Word> next)>;
    void each_block_if(std::uint32_t level, const WantsBlock& wants, const TakeRows& visit);

    /// Closes the finished file that is open, if there is one. The next access opens it again.
    void close_finished_files();

    /// A function that passes rows piece by piece. The rows of each piece are ascending, without duplicates.
    using GivePieces = std::function<void(const TakeRows&)>;
    /// The contents of a checkpoint besides the levels.
    struct Beside {
        std::vector<Word> marks;  ///< rows of level 0, ascending
        GivePieces unsure;        ///< rows followed by their levels as another word; may be empty
        std::vector<SavedFigures> expanded;
    };
    /// Writes a checkpoint of all levels. Removes this rank's checkpoints that are older than the newest complete one.
    /// If it throws CannotWrite, the previous checkpoint stays valid and the call can be repeated.
    void checkpoint(const Beside& beside);
    /// Gives later checkpoints numbers that are greater than this one.
    void number_from(std::uint64_t number) { number_ = number; }

    /// Reads the rows of a file that a checkpoint names besides the levels. `levels`: each row is followed by its
    /// level. Polls the budget for each block. Throws BadFile.
    static void read_beside(const FolderOf& where, const SavedFile& file, bool levels, diagnostics::Pollable& budget,
                            const TakeRows& visit);
    /// Returns the memory use in bytes.
    [[nodiscard]] std::uint64_t bytes() const;

private:
    struct File {
        std::unique_ptr<RowFile> file;
        std::string name;
        std::uint64_t used = 0;  ///< number of valid blocks
        bool named = false;      ///< named by a checkpoint, so it must not change
    };
    struct Level {
        std::uint32_t file = 0;
        std::uint32_t first = 0;  ///< first block
        std::uint32_t count = 0;  ///< number of blocks
        std::uint64_t rows = 0;
    };
    [[nodiscard]] const RowFile& to_read(std::uint32_t file);
    RowFile& growing_file();
    File new_file(const RowKind& kind);
    void finish_last();
    SavedFile save(const RowKind& kind, const GivePieces& give);
    void note_written(const Checkpoint& made);

    FolderOf where_;
    std::vector<File> files_;
    std::vector<Level> levels_;
    std::uint64_t rows_ = 0;
    std::uint64_t number_ = 0;
    std::uint32_t saved_levels_ = 0;  ///< levels in the last checkpoint
    std::uint64_t next_name_ = 0;
    std::uint32_t open_file_ = 0xFFFFFFFFU;  ///< the only finished file that may be open
    // The block that was read last, and its file.
    std::uint32_t cached_file_ = 0xFFFFFFFFU;
    std::uint32_t cached_block_ = 0;
    std::vector<Word> cached_;
};

}  // namespace robochart::storage
