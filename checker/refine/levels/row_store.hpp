// What one rank of a level-synchronous search has found: rows (the monitor's node, if it has nodes, and the words of a
// state), each once, level by level. Implementations keep them in memory or in files, and may continue an earlier run.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "checker/lts/state_store.hpp"

namespace robochart::refine {

/// The length of the shortest run to a row, in steps; the initial row has 0.
using Level = std::uint32_t;

/// What expanding a level has given at one rank.
struct LevelFigures {
    std::uint64_t transitions = 0;
    std::uint64_t chased = 0;  ///< states that these were led on from (lts::TransitionSystem::chased)
};

/// What a search keeps beside rows. It is part of every checkpoint.
struct SearchRecord {
    explicit SearchRecord(std::size_t width) : marks(width) {}
    std::vector<LevelFigures> expanded;  ///< by level: those expanded so far, by this rank
    /// Rows of this rank that a tau leads to from a row of the same level or a later one; perhaps some more.
    lts::StateStore marks;
};

/// Levels 0 to levels()-1 are closed: their rows are known. The next level, of number levels(), is open: rows are
/// entered into it. Not thread-safe.
///
/// A store that does not have all earlier rows at hand may answer `unsure`: the row is perhaps one of a closed level.
/// It keeps such a row aside, with the number of the open level, until `settle` finds out. The search takes it for an
/// earlier one until then.
class RowStore {
public:
    enum class Found : std::uint8_t {
        fresh,    ///< it is now in the open level
        again,    ///< it was in the open level already
        earlier,  ///< it is in a closed level
        unsure    ///< perhaps in a closed level; else it belongs to the open level
    };

    /// `width`: words of a row.
    explicit RowStore(std::size_t width) : record_(width), width_(width) {}
    RowStore(const RowStore&) = delete;
    RowStore& operator=(const RowStore&) = delete;
    virtual ~RowStore() = default;

    [[nodiscard]] std::size_t width() const { return width_; }
    /// How many levels are closed. More than none at the beginning: the store continues an earlier run, of which the
    /// last closed level has not been expanded yet.
    [[nodiscard]] virtual Level levels() const = 0;
    /// How many rows a closed level has, or the open one so far.
    [[nodiscard]] virtual std::uint64_t rows(Level level) const = 0;
    /// How many rows all levels have.
    [[nodiscard]] virtual std::uint64_t size() const = 0;

    /// Where the store continues a run of another number of ranks: how many rows that had, at all ranks. All ranks now
    /// have as many together.
    [[nodiscard]] virtual std::optional<std::uint64_t> rows_before() const { return std::nullopt; }

    /// Asks memory for what `enter` will look at.
    virtual void prefetch(std::uint64_t /*hash*/) const {}
    /// Enters a row into the open level, if it is new. `hash` is lts::StateStore::hash(row). May throw LimitReached
    /// (disk full, too many rows); closed levels are then as they were.
    virtual Found enter(lts::StateView row, std::uint64_t hash) = 0;
    /// The open level is complete: the next one is open from now on, and empty.
    virtual void close_level() = 0;
    /// Rows of a closed level in the store's own order, the same each time until it rolls back: copies those from
    /// number `first` on, at most `most`, to the end of `rows`. Gives how many; 0 past the end. Meant to be read in
    /// order; rows may be entered in between.
    virtual std::size_t read(Level level, std::uint64_t first, std::size_t most, std::vector<lts::Word>& rows) = 0;

    /// Whether enough rows are unsure for `settle` to be worth it.
    [[nodiscard]] virtual bool wants_to_settle() const { return false; }
    /// Decides about all unsure rows, by comparison with the closed levels. The least level that one of them should
    /// have been entered into; none if all were found in a level before their own. Called by the search where a rank
    /// wants it, and before any verdict.
    [[nodiscard]] virtual std::optional<Level> settle() { return std::nullopt; }
    /// Forgets what came after: `level`, at most the open one, is open from now on, with its rows and those that
    /// `settle` has found to belong to it; later levels are forgotten, with what was unsure. What has once been unsure
    /// in error is known exactly from then on. Called at all ranks with the least level of all.
    virtual void roll_back_to(Level /*level*/) {}

    /// Whether it is time to write a checkpoint.
    [[nodiscard]] virtual bool wants_checkpoint() const { return false; }
    /// Writes all closed levels and the record, so that another run can continue from there. Called after close_level
    /// at all ranks where one wants it, and, on a limit or an interrupt, in the midst of a level: then the open level
    /// is left out, and record().expanded has no figures of the last closed one.
    virtual void checkpoint() {}

    /// In memory, all together.
    [[nodiscard]] virtual std::uint64_t bytes() const = 0;

    /// Written by the search, kept by the store.
    [[nodiscard]] SearchRecord& record() { return record_; }
    [[nodiscard]] const SearchRecord& record() const { return record_; }

private:
    SearchRecord record_;
    std::size_t width_;
};

}  // namespace robochart::refine
