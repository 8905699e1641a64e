// SPDX-License-Identifier: Apache-2.0
// The rows that one rank of a level-synchronous search has found, without duplicates, level by level. A row is the
// monitor's node, if it has nodes, and the words of a state. Implementations store rows in memory or in files, and may
// continue an earlier run.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "checker/lts/state_store.hpp"

namespace robochart::refine {

/// The length of the shortest run to a row, in steps; 0 for the initial row.
using Level = std::uint32_t;

/// The statistics of expanding a level at one rank.
struct LevelFigures {
    std::uint64_t transitions = 0;
    std::uint64_t chased = 0;  ///< number of left-out states (lts::TransitionSystem::chased)
};

/// The data of a search in addition to rows. It is part of every checkpoint.
struct SearchRecord {
    explicit SearchRecord(std::size_t width) : marks(width) {}
    std::vector<LevelFigures> expanded;  ///< by level: figures of the rows that this rank has expanded so far
    /// Rows of this rank, including at least those to which a tau leads from a row of the same level or a later one.
    lts::StateStore marks;
};

/// Levels 0 to levels()-1 are closed: their rows are known. The next level, number levels(), is open: rows are entered
/// into it. Not thread-safe.
///
/// A store that does not have all earlier rows in memory may return `unsure`, which means that the row may be in a
/// closed level. The store keeps such a row, with the number of the open level, until it settles its unsure rows. Until
/// then the search treats the row as a duplicate.
class RowStore {
public:
    enum class Found : std::uint8_t {
        fresh,    ///< it has been added to the open level
        again,    ///< it was already in the open level
        earlier,  ///< it is in a closed level
        unsure    ///< it may be in a closed level; otherwise it belongs to the open level
    };

    /// `width`: words in a row.
    explicit RowStore(std::size_t width) : record_(width), width_(width) {}
    RowStore(const RowStore&) = delete;
    RowStore& operator=(const RowStore&) = delete;
    virtual ~RowStore() = default;

    [[nodiscard]] std::size_t width() const { return width_; }
    /// The number of closed levels. If it is not 0 at the beginning, the store continues an earlier run, in which the
    /// last closed level has not been expanded.
    [[nodiscard]] virtual Level levels() const = 0;
    /// The number of rows in a closed level, or the number of rows in the open level so far.
    [[nodiscard]] virtual std::uint64_t rows(Level level) const = 0;
    /// The number of rows in all levels.
    [[nodiscard]] virtual std::uint64_t size() const = 0;

    /// If the store continues a run with another number of ranks, returns the number of rows at all former ranks. All
    /// ranks together now have the same number.
    [[nodiscard]] virtual std::optional<std::uint64_t> rows_before() const { return std::nullopt; }

    /// Prefetches the memory that entering the row will read.
    virtual void prefetch(std::uint64_t /*hash*/) const {}
    /// Enters a row into the open level if it is new. `hash` is lts::StateStore::hash(row). Throws LimitReached if the
    /// disk is full or there are too many rows; closed levels are then unchanged.
    virtual Found enter_row(lts::StateView row, std::uint64_t hash) = 0;
    /// Closes the open level and opens the next one, which is empty.
    virtual void close_level() = 0;
    /// Appends rows of a closed level to `rows`: those from number `first` on, at most `most`. The order is the store's
    /// own, and is the same each time until the store rolls back. Returns the number of rows; 0 after the end. Intended
    /// for sequential reading. Rows may be entered between calls.
    virtual std::size_t read(Level level, std::uint64_t first, std::size_t most, std::vector<lts::Word>& rows) = 0;

    /// Whether there are so many unsure rows that the store should settle them now.
    [[nodiscard]] virtual bool wants_to_settle() const { return false; }
    /// Settles all unsure rows: compares them with the closed levels. Returns the least level into which one of them
    /// should have been entered. Returns no value if each of them is in an earlier level than its own and so is a
    /// duplicate. The search calls this function if a rank wants to settle its rows, and before any verdict.
    [[nodiscard]] virtual std::optional<Level> settle_unsure_rows() { return std::nullopt; }
    /// Opens `level` again, which is at most the open level, with its rows and with the settled rows that belong to it.
    /// Later levels and unsure rows are dropped. Rows that were unsure by mistake are stored exactly afterwards. Called
    /// at all ranks with the least level of all ranks.
    virtual void roll_back_to(Level /*level*/) {}

    /// Whether it is time to write a checkpoint.
    [[nodiscard]] virtual bool wants_checkpoint() const { return false; }
    /// Writes all closed levels and the record, so that another run can continue from there. Called at all ranks after
    /// close_level if one of them requests it. It is also called during a level on a limit or an interrupt; then the
    /// open level is left out, and record().expanded has no entry for the last closed level.
    virtual void checkpoint() {}

    /// Total memory use.
    [[nodiscard]] virtual std::uint64_t bytes() const = 0;

    /// The search writes the record, and the store saves it.
    [[nodiscard]] SearchRecord& record() { return record_; }
    [[nodiscard]] const SearchRecord& record() const { return record_; }

private:
    SearchRecord record_;
    std::size_t width_;
};

}  // namespace robochart::refine
