// SPDX-License-Identifier: Apache-2.0
// Defines the interface of row stores. A row store contains the rows that one rank of a search by levels has found,
// without duplicates, level by level. A row consists of the monitor's node, if the monitor has nodes, and the words of
// a state. Implementations store rows in memory or in files, and may continue an earlier run.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "checker/lts/state_store.hpp"

namespace robochart::refine {

/// The length of the shortest run to a row, in steps; 0 for the initial row.
using Level = std::uint32_t;

/// Statistics about the expansion of a level at one rank.
struct LevelFigures {
    std::uint64_t transitions = 0;
    std::uint64_t chased = 0;  ///< number of left-out states (lts::TransitionSystem::chased)
};

/// The data of a search that are not rows. Every checkpoint contains these data.
struct SearchRecord {
    explicit SearchRecord(std::size_t width) : marks(width) {}
    std::vector<LevelFigures> expanded;  ///< by level: statistics of the rows that this rank has expanded so far
    /// Rows of this rank: at least every row that is the target of a tau from a row of the same level or a later level.
    lts::StateStore marks;
};

/// Stores rows by levels. Levels 0 to levels()-1 are closed: their rows are complete. The next level, number levels(),
/// is open: rows are entered into it. Not thread-safe.
///
/// If a store does not have all earlier rows in memory, it may return `unsure` for a row that may be in a closed level.
/// The store remembers the row with the number of the open level until it settles its unsure rows. Until then, the
/// search treats the row as a duplicate.
class RowStore {
public:
    enum class Found : std::uint8_t {
        fresh,    ///< the row has been added to the open level
        again,    ///< the row was already in the open level
        earlier,  ///< the row is in a closed level
        unsure    ///< the row may be in a closed level; otherwise it belongs to the open level
    };

    /// `width`: the number of words in a row.
    explicit RowStore(std::size_t width) : record_(width), width_(width) {}
    RowStore(const RowStore&) = delete;
    RowStore& operator=(const RowStore&) = delete;
    virtual ~RowStore() = default;

    [[nodiscard]] std::size_t width() const { return width_; }
    /// Returns the number of closed levels. If the number is not 0 at the beginning, the store continues an earlier
    /// run. The last closed level has then not been expanded.
    [[nodiscard]] virtual Level levels() const = 0;
    /// Returns the number of rows in a closed level, or the number of rows in the open level so far.
    [[nodiscard]] virtual std::uint64_t rows(Level level) const = 0;
    /// Returns the number of rows in all levels.
    [[nodiscard]] virtual std::uint64_t size() const = 0;

    /// If the store continues a run with another number of ranks, returns the number of rows at all former ranks. All
    /// present ranks together have the same number of rows.
    [[nodiscard]] virtual std::optional<std::uint64_t> rows_before() const { return std::nullopt; }

    /// Prefetches the memory that entering the row will read.
    virtual void prefetch(std::uint64_t /*hash*/) const {}
    /// Enters a row into the open level if it is new. `hash` is lts::StateStore::hash(row). Throws LimitReached if the
    /// disk is full or there are too many rows; closed levels are then unchanged.
    virtual Found enter_row(lts::StateView row, std::uint64_t hash) = 0;
    /// Closes the open level and opens the next one, which is empty.
    virtual void close_level() = 0;
    /// Appends at most `most` rows of a closed level to `rows`, beginning with row number `first`. The store chooses
    /// the order of the rows. The order does not change until the store rolls back. Returns the number of appended
    /// rows; 0 means that there are no more rows. The function is intended for sequential reading. Rows may be entered
    /// between calls.
    virtual std::size_t read(Level level, std::uint64_t first, std::size_t most, std::vector<lts::Word>& rows) = 0;

    /// Returns true if there are so many unsure rows that the store should settle them now.
    [[nodiscard]] virtual bool wants_to_settle() const { return false; }
    /// Settles all unsure rows by comparing them with the closed levels. Returns no value if all unsure rows are
    /// duplicates, that is, if each row is in an earlier level. Otherwise returns the least level to which an unsure
    /// row that is not a duplicate belongs. The search calls this function if a rank wants to settle its rows, and
    /// before any verdict.
    [[nodiscard]] virtual std::optional<Level> settle_unsure_rows() { return std::nullopt; }
    /// Opens `level` again. `level` is at most the open level. The function does not remove the rows of this level. It
    /// adds the settled rows that belong to this level, and drops later levels and unsure rows. After this call, the
    /// store contains the rows that were mistaken for duplicates. All ranks call this function with the least level of
    /// all ranks.
    virtual void roll_back_to(Level /*level*/) {}

    /// Returns true if it is time to write a checkpoint.
    [[nodiscard]] virtual bool wants_checkpoint() const { return false; }
    /// Writes all closed levels and the record, so that another run can continue from them. If one rank requests a
    /// checkpoint, all ranks call this function after close_level. At a limit or an interrupt, they also call this
    /// function during a level. The checkpoint then does not contain the open level, and record().expanded has no entry
    /// for the last closed level.
    virtual void checkpoint() {}

    /// Returns the total memory use in bytes.
    [[nodiscard]] virtual std::uint64_t bytes() const = 0;

    /// Returns the record, which the search writes and the store saves.
    [[nodiscard]] SearchRecord& record() { return record_; }
    [[nodiscard]] const SearchRecord& record() const { return record_; }

private:
    SearchRecord record_;
    std::size_t width_;
};

}  // namespace robochart::refine
