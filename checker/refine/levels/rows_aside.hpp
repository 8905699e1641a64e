// SPDX-License-Identifier: Apache-2.0
// Stores rows that may be duplicates, so that all these rows are decided together later ("delayed duplicate detection":
// Stern and Dill, Using magnetic disk instead of main memory in the Murphi verifier, CAV 1998). Each row is stored with
// a level, to which it belongs if it is not a duplicate. If there are many rows, they are stored as sorted runs in a
// file.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "checker/refine/levels/row_store.hpp"
#include "checker/storage/sorted_runs.hpp"

namespace robochart::refine {

class RowsAside {
public:
    /// Stores as many rows in memory as fit into `bytes`, but at least a few. `path` is the temporary path of the file
    /// during its creation.
    RowsAside(const std::string& path, const storage::RowKind& kind, std::uint64_t bytes);

    /// Adds a row that belongs to `level` if it is not a duplicate. If a row is added again, its level must not be less
    /// than before. `hash`: lts::StateStore::hash(row). If the function throws storage::CannotWrite, it has not added
    /// the row, and all other rows are unchanged.
    void add(lts::StateView row, std::uint64_t hash, Level level);
    [[nodiscard]] bool empty() const { return rows() == 0; }
    /// Returns the number of rows; duplicates may be counted several times.
    [[nodiscard]] std::uint64_t rows() const { return store_->size() + unwritten_row_count() + runs_.rows(); }
    [[nodiscard]] bool on_disk() const { return !runs_.empty(); }
    /// Passes all rows to `take` in pieces. A piece contains ascending rows without duplicates. The level of a row
    /// follows the row as another word. If several pieces contain a row, the first of these pieces has its least level.
    /// `take` may change the piece. Does not write to the disk. Throws the exceptions of `take`, and storage::BadFile.
    void each_piece(const std::function<void(std::vector<lts::Word>& rows)>& take) const;
    /// Removes all rows.
    void clear();
    [[nodiscard]] std::uint64_t bytes() const;

private:
    [[nodiscard]] std::size_t width() const { return store_->width(); }
    [[nodiscard]] std::uint64_t unwritten_row_count() const { return unwritten_.size() / (width() + 1); }
    [[nodiscard]] std::vector<lts::Word> with_levels(lts::StateIndex first, lts::StateIndex end) const;
    void write();
    void each_of_runs(const std::function<void(std::vector<lts::Word>& rows)>& take) const;

    std::uint64_t most_;                      ///< maximal number of rows in memory
    std::unique_ptr<lts::StateStore> store_;  ///< the rows added last
    /// Each level in the store, with the first row of the store that has this level.
    std::vector<std::pair<Level, lts::StateIndex>> levels_;
    std::vector<lts::Word> unwritten_;  ///< further rows with their levels, to be written as a run
    storage::SortedRuns runs_;          ///< the other rows
};

}  // namespace robochart::refine
