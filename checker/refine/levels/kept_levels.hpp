// SPDX-License-Identifier: Apache-2.0
// The common part of all row stores with files. Writes the levels of one rank to files, and decides when to
// write checkpoints. Also continues a search from a checkpoint, even if the earlier search had another number of
// ranks.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/diagnostics/descriptor.hpp"
#include "base/diagnostics/pollable.hpp"
#include "checker/refine/levels/row_store.hpp"
#include "checker/storage/level_files.hpp"
#include "checker/storage/sorted_runs.hpp"

namespace robochart::refine {

/// The folder and the settings with which a search stores rows in files.
struct KeptWhere {
    std::string folder;     ///< used only by this search; must exist
    storage::RowKind kind;  ///< identifies the search
    storage::Place place;   ///< the number of this rank and the number of ranks
    storage::Newest from;   ///< the checkpoint from which the search continues, the same at all ranks
    /// The time between checkpoints. If it has no value, checkpoints are written only on limits and interrupts.
    std::optional<std::chrono::milliseconds> every;
    /// Returns whether a row belongs to this rank. If the function is empty, all rows belong to this rank.
    std::function<bool(lts::StateView row)> mine;
    /// Polled during long work; it must outlive the store.
    diagnostics::Pollable* budget = &diagnostics::unlimited;
    /// The lock that this rank holds while it uses the folder, or null if the folder is not locked.
    std::shared_ptr<const diagnostics::Descriptor> lock;
};

/// Returns the path of a file for rows that are not in level files. `what` is the first part of the name.
[[nodiscard]] std::string path_of(const char* what, const KeptWhere& where);

class KeptLevels {
public:
    explicit KeptLevels(KeptWhere where);

    /// Receives an unsure row, that is, a possible duplicate. If the row is not a duplicate, it belongs to
    /// `level`.
    using TakeUnsure = std::function<void(Level level, lts::StateView row)>;
    /// Continues from the checkpoint, if there is one. Afterwards, files() contains the levels that all ranks of the
    /// checkpoint have closed, and the record describes these levels. Calls `unsure` after the levels have been loaded.
    /// Throws storage::BadFile, and the exceptions of `unsure`.
    void load_checkpoint(SearchRecord& record, const TakeUnsure& unsure);

    /// Returns the number of rows in the loaded levels of all former ranks. Returns no value if loading has not
    /// redistributed the rows.
    [[nodiscard]] std::optional<std::uint64_t> rows_before() const { return rows_before_; }

    [[nodiscard]] storage::LevelFiles& files() { return files_; }
    [[nodiscard]] const storage::LevelFiles& files() const { return files_; }
    [[nodiscard]] bool checkpoint_due() const;
    /// Writes a checkpoint. `unsure` passes unsure rows, each followed by its level. Rows of levels that are not closed
    /// are omitted. Throws storage::CannotWrite.
    void checkpoint(const SearchRecord& record, const storage::LevelFiles::GivePieces& unsure);
    /// Call this function after a checkpoint has failed with CannotWrite. The function writes a checkpoint with as many
    /// levels as there is space for, and drops the other levels. The search cannot continue afterwards. Throws
    /// storage::CannotWrite if the new checkpoint would not contain more levels than the previous one.
    void checkpoint_of_fewer(const SearchRecord& record, const storage::LevelFiles::GivePieces& unsure);
    void poll() const { where_.budget->poll(); }

private:
    void check(const storage::Checkpoint& found) const;
    void redistribute_rows(const std::vector<storage::Checkpoint>& found, Level levels);
    std::uint64_t add_mine(storage::LevelFiles& from, Level level, storage::SortedRuns& runs);

    KeptWhere where_;
    storage::LevelFiles files_;
    std::optional<std::uint64_t> rows_before_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace robochart::refine
