// SPDX-License-Identifier: Apache-2.0
// A store for more rows than fit into memory (docs/search.md, "Out of core"). Sorted files contain all closed
// levels. Memory contains a filter over all closed levels, and rows of the open level. Rows of the open level are
// written as sorted runs when they need too much memory. A row that the filter rejects is new. A row that the filter
// accepts is almost certainly a duplicate. The store puts an accepted row aside. If it puts many rows aside, it
// writes them to files. From time to time, and before any verdict, the store settles the rows that it has put aside:
// it reads all levels and looks for these rows. If no level contains a row, the row is not a duplicate. The store
// adds such a row to the open level, if the row belongs to this level. Otherwise the search rolls back to the level
// of the row.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "checker/refine/levels/kept_levels.hpp"
#include "checker/refine/levels/row_filter.hpp"
#include "checker/refine/levels/rows_aside.hpp"
#include "checker/storage/sorted_runs.hpp"

namespace robochart::refine {

class DiskRowStore final : public RowStore {
public:
    /// Statistics about the work of the store.
    struct Figures {
        std::uint64_t settled = 0;       ///< number of passes through all levels to settle rows put aside
        std::uint64_t put_aside = 0;     ///< total number of rows put aside in these passes
        std::uint64_t rolled_back = 0;   ///< number of times that the search rolled back
        std::uint64_t in_error = 0;      ///< number of rows taken for duplicates by mistake
        std::uint64_t runs_written = 0;  ///< number of times that a part of an open level was written
        std::uint64_t peak_bytes = 0;
    };
    struct Bounds {
        std::uint64_t most_bytes = 0;  ///< limit on the total memory, without the blocks of runs in a merge
        unsigned filter_bits = 32;     ///< maximal number of bits for each row
        /// An estimate of how many rows the store can read from files while the search handles one row. If this is 0,
        /// the store settles rows only when it must.
        unsigned reads_a_step = 10;
        std::function<void(const Figures&)> report;  ///< receives the statistics at the end; may be empty
    };
    /// Creates a store. If the folder contains a checkpoint, continues from the newest one. Throws
    /// storage::BadFile.
    DiskRowStore(KeptWhere where, Bounds bounds);
    ~DiskRowStore() override;
    DiskRowStore(const DiskRowStore&) = delete;
    DiskRowStore& operator=(const DiskRowStore&) = delete;

    [[nodiscard]] Level levels() const override { return kept_.files().levels(); }
    [[nodiscard]] std::optional<std::uint64_t> rows_before() const override { return kept_.rows_before(); }
    [[nodiscard]] std::uint64_t rows(Level level) const override;
    [[nodiscard]] std::uint64_t size() const override { return kept_.files().rows() + rows(levels()); }
    void prefetch(std::uint64_t hash) const override {
        open_->prefetch(hash);
        filter_.prefetch(hash);
    }
    Found enter_row(lts::StateView row, std::uint64_t hash) override;
    void close_level() override;
    std::size_t read(Level level, std::uint64_t first, std::size_t most, std::vector<lts::Word>& rows) override {
        return kept_.files().read(level, first, most, rows);
    }
    [[nodiscard]] bool wants_to_settle() const override;
    [[nodiscard]] std::optional<Level> settle_unsure_rows() override;
    void roll_back_to(Level level) override;
    [[nodiscard]] bool wants_checkpoint() const override { return kept_.checkpoint_due(); }
    void checkpoint() override;
    [[nodiscard]] std::uint64_t bytes() const override;

    [[nodiscard]] const Figures& figures() const { return figures_; }

private:
    using Store = std::unique_ptr<lts::StateStore>;

    [[nodiscard]] Store new_store() const { return std::make_unique<lts::StateStore>(width()); }
    void renew_open();
    void add_to_open(lts::StateView row, std::uint64_t hash);
    [[nodiscard]] std::uint64_t rows_sorted_at_once() const;
    void write_open();
    void empty_open();
    bool settle_aside(bool going_on);
    void remove_those_in(Level level, bool polled, std::vector<lts::Word>& rows);
    bool take_missing(std::span<const lts::Word> rows, bool going_on);
    void forget_aside();
    void fill_filter();
    void give_unsure(const storage::TakeRows& take) const;
    void add_to_filter(std::span<const lts::Word> rows);
    void note_peak() { figures_.peak_bytes = std::max(figures_.peak_bytes, bytes()); }

    KeptLevels kept_;
    Bounds bounds_;
    RowFilter filter_;
    std::uint64_t most_open_;  ///< maximal number of rows in `open_`
    Store open_;
    storage::SortedRuns runs_;  ///< further rows of the open level; `open_` may contain some of them again
    RowsAside aside_;
    Level late_level_ = 0;   ///< the least level with missing rows
    Store late_;             ///< the missing rows
    std::uint64_t met_ = 0;  ///< number of rows that were entered since the last settling
    std::uint64_t new_ = 0;  ///< number of these rows that were new
    Figures figures_;
};

}  // namespace robochart::refine
