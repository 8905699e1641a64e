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

class KeptLevels {
public:
    explicit KeptLevels(KeptWhere where);

    /// Rows that an earlier run was unsure of, with the level that they belong to if they are none of an earlier one.
    using Unsure = std::vector<std::pair<Level, std::vector<lts::Word>>>;
    /// Goes on from the checkpoint, if there is one: the levels that all its ranks have closed are then in files(), and
    /// the record is that of these levels. Throws storage::BadFile.
    Unsure load(SearchRecord& record);

    [[nodiscard]] storage::LevelFiles& files() { return files_; }
    [[nodiscard]] const storage::LevelFiles& files() const { return files_; }
    [[nodiscard]] bool checkpoint_due() const;
    /// Writes one. `unsure` may have rows of levels that are not closed; they are left out. Throws
    /// storage::CannotWrite.
    void checkpoint(const SearchRecord& record, const Unsure& unsure);
    void poll() const {
        if (where_.poll) where_.poll();
    }

private:
    void check(const storage::Checkpoint& found) const;
    void redistribute(const std::vector<storage::Checkpoint>& found, Level levels);

    KeptWhere where_;
    storage::LevelFiles files_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace robochart::refine
