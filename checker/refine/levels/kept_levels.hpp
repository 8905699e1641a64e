// What row stores that use files have in common: the levels of one rank in files, when it is time for a checkpoint,
// what is in it, and how a search goes on from one, whatever number of ranks has written it.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "checker/refine/levels/row_store.hpp"
#include "checker/storage/level_files.hpp"
#include "checker/storage/sorted_runs.hpp"
#include "diagnostics/descriptor.hpp"

namespace robochart::refine {

/// Where and how a search keeps rows in files.
struct KeptWhere {
    std::string folder;     ///< of this search alone; exists
    storage::RowKind kind;  ///< says which search it is
    storage::Place place;   ///< which rank of it
    storage::Newest from;   ///< what is gone on from: the same at all ranks
    /// Between checkpoints; none: they are written on limits and interrupts alone.
    std::optional<std::chrono::milliseconds> every;
    /// Whether a row belongs to this rank; empty: all do.
    std::function<bool(lts::StateView row)> mine;
    /// Called during long work; may throw.
    std::function<void()> poll;
    /// Open as long as this rank uses the folder; null: nobody asks.
    std::shared_ptr<const diagnostics::Descriptor> lock;
};

/// Of a file beside the levels.
[[nodiscard]] std::string path_of(const char* what, const KeptWhere& where);

class KeptLevels {
public:
    explicit KeptLevels(KeptWhere where);

    /// Takes a row that a run was unsure of, with the level that it belongs to if it is none of an earlier one.
    using TakeUnsure = std::function<void(Level level, lts::StateView row)>;
    /// Goes on from the checkpoint, if there is one: the levels that all its ranks have closed are then in files(), and
    /// the record is that of these levels. `unsure` is called when the levels are there. Throws
    /// storage::BadFile, and what `unsure` throws.
    void load(SearchRecord& record, const TakeUnsure& unsure);

    /// How many rows those levels had at all ranks that there were; none where load has not divided them anew.
    [[nodiscard]] std::optional<std::uint64_t> rows_before() const { return rows_before_; }

    [[nodiscard]] storage::LevelFiles& files() { return files_; }
    [[nodiscard]] const storage::LevelFiles& files() const { return files_; }
    [[nodiscard]] bool checkpoint_due() const;
    /// Writes one. `unsure` gives rows with their levels behind; those of levels that are not closed are left out.
    /// Throws storage::CannotWrite.
    void checkpoint(const SearchRecord& record, const storage::LevelFiles::GivePieces& unsure);
    /// After CannotWrite: one of fewer levels, of as many as there is space for. The others are no longer there, so
    /// that the search is over. Throws storage::CannotWrite where no level is left that the checkpoint before has not.
    void checkpoint_of_fewer(const SearchRecord& record, const storage::LevelFiles::GivePieces& unsure);
    void poll() const {
        if (where_.poll) where_.poll();
    }

private:
    void check(const storage::Checkpoint& found) const;
    void redistribute(const std::vector<storage::Checkpoint>& found, Level levels);
    std::uint64_t add_mine(storage::LevelFiles& from, Level level, storage::SortedRuns& runs);

    KeptWhere where_;
    storage::LevelFiles files_;
    std::optional<std::uint64_t> rows_before_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace robochart::refine
