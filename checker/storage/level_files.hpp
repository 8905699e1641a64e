// The levels of one rank of a search in files of a folder: written one after the other, read in any order. A checkpoint
// makes them last.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "checker/storage/checkpoint.hpp"
#include "checker/storage/row_file.hpp"

namespace robochart::storage {

/// Where a rank keeps what.
struct FolderOf {
    std::string folder;  ///< exists
    RowKind kind;
    Place place;
};

class LevelFiles {
public:
    explicit LevelFiles(FolderOf where) : where_(std::move(where)) {}

    /// Takes over the levels of a checkpoint of this rank; all its files are read and checked. How many levels it has
    /// is for the caller to bound. Throws BadFile.
    void adopt(const Checkpoint& checkpoint, const std::function<void()>& poll);

    [[nodiscard]] std::uint32_t levels() const { return static_cast<std::uint32_t>(levels_.size()); }
    [[nodiscard]] std::uint64_t rows(std::uint32_t level) const { return levels_[level].rows; }
    [[nodiscard]] std::uint64_t rows() const { return rows_; }

    /// Appends the next level. `rows`: ascending, none twice; there may be none. Throws CannotWrite; all is then as
    /// before.
    void add_level(std::span<const Word> rows);
    /// Appends the next level, whose rows `give` gives piece by piece: ascending, none twice, in pieces of
    /// RowFile::rows_of_block rows but for the last. Throws what `give` throws, too.
    void add_level(const std::function<void(const TakeRows&)>& give);
    /// Gives up the last levels, at most `count`, so that there is space for others: those above the number of levels
    /// of the last checkpoint. Gives how many.
    std::uint32_t give_up(std::uint32_t count);
    /// From now on this level and later ones are not there. What they take on the disk is free, but in files that a
    /// checkpoint names.
    void forget_from(std::uint32_t level);

    /// Appends the rows of a level from number `first` on, at most `most`, to `rows`; gives how many. Throws BadFile.
    std::size_t read(std::uint32_t level, std::uint64_t first, std::size_t most, std::vector<Word>& rows);
    /// Calls with the rows of each block of a level, ascending. Throws BadFile.
    void each_block(std::uint32_t level, const TakeRows& visit);

    /// Calls with each block of a level that `wants` says, ascending: what it takes is the block's first row, and that
    /// of the next block of the level (of the last one: nothing). Throws BadFile.
    using WantsBlock = std::function<bool(std::span<const Word> first, std::span<const Word> next)>;
    void each_block_if(std::uint32_t level, const WantsBlock& wants, const TakeRows& visit);

    /// Files that are finished are not open until they are read again. Without it one of them is.
    void rest();

    /// Gives rows piece by piece: those of each are ascending, none twice.
    using GivePieces = std::function<void(const TakeRows&)>;
    /// What a checkpoint has beside the levels.
    struct Beside {
        std::vector<Word> marks;  ///< ascending
        GivePieces unsure;        ///< rows with their levels behind, a word more; may be empty
        std::vector<SavedFigures> expanded;
    };
    /// Writes a checkpoint of all levels. Those of this rank that are older than the newest complete one are removed.
    /// Throws CannotWrite; then the one before counts, and this can be tried again.
    void checkpoint(const Beside& beside);
    /// The number of the last checkpoint; 0: none.
    [[nodiscard]] std::uint64_t number() const { return number_; }
    /// The next checkpoint has a number above this one.
    void number_from(std::uint64_t number) { number_ = number; }

    /// Reads the rows of a file of a checkpoint beside the levels: of rows with their levels if `levels`. Throws
    /// BadFile.
    static void read_beside(const FolderOf& where, const SavedFile& file, bool levels,
                            const std::function<void()>& poll, const TakeRows& visit);
    /// In memory.
    [[nodiscard]] std::uint64_t bytes() const;

private:
    struct File {
        std::unique_ptr<RowFile> file;
        std::string name;
        std::uint64_t used = 0;  ///< blocks
        bool named = false;      ///< by a checkpoint, so that it stays as it is
    };
    struct Level {
        std::uint32_t file = 0;
        std::uint32_t first = 0;  ///< block
        std::uint32_t count = 0;  ///< of blocks
        std::uint64_t rows = 0;
    };
    [[nodiscard]] const RowFile& to_read(std::uint32_t file);
    RowFile& growing();
    File new_file(const RowKind& kind);
    void finish_last();
    SavedFile save(const RowKind& kind, const GivePieces& give);
    void note_written(const Checkpoint& made);

    FolderOf where_;
    std::vector<File> files_;
    std::vector<Level> levels_;
    std::uint64_t rows_ = 0;
    std::uint64_t number_ = 0;
    std::uint32_t saved_levels_ = 0;  ///< of the last checkpoint
    std::uint64_t next_name_ = 0;
    std::uint32_t open_file_ = 0xFFFFFFFFU;  ///< of those that are finished: the only one that may be open
    // the block that was read last
    std::uint32_t cached_file_ = 0xFFFFFFFFU;
    std::uint32_t cached_block_ = 0;
    std::vector<Word> cached_;
};

}  // namespace robochart::storage
