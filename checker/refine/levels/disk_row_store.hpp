// More rows than memory holds (docs/search.md, "Out of core"). All closed levels are in sorted files. In memory are
// rows of the open level, which are written as sorted runs when they take too much, and a filter over all closed
// levels. A row that the filter does not have is new. One that it has is almost surely old: it is put aside, in
// files too where these rows are many. From time to time, and before any verdict, the levels are read through for the
// rows put aside. One that is in none after all was taken for an old one in error: it joins the open level, or the
// search goes back to its level.
#pragma once

#include <memory>
#include <vector>

#include "checker/refine/levels/kept_levels.hpp"
#include "checker/refine/levels/row_filter.hpp"
#include "checker/refine/levels/rows_aside.hpp"
#include "checker/storage/sorted_runs.hpp"

namespace robochart::refine {

class DiskRowStore final : public RowStore {
public:
    /// What has happened, for those who measure.
    struct Figures {
        std::uint64_t settled = 0;       ///< times that the levels were read through for rows put aside
        std::uint64_t put_aside = 0;     ///< rows that were put aside when they were read through, together
        std::uint64_t rolled_back = 0;   ///< times that the search went back
        std::uint64_t in_error = 0;      ///< rows that were taken for old ones
        std::uint64_t runs_written = 0;  ///< times that rows of an open level were written before it was complete
        std::uint64_t peak_bytes = 0;
    };
    struct Bounds {
        std::uint64_t most_bytes = 0;  ///< that all should take in memory, but for a block of each run that is merged
        unsigned filter_bits = 32;     ///< of each row, at most
        /// In the time of one row that the search meets, so many rows of the files are read; 0: nothing is settled
        /// before it must be.
        unsigned reads_a_step = 10;
        std::function<void(const Figures&)> report;  ///< called at the end; may be empty
    };
    /// Goes on from the newest checkpoint in the folder, if there is one. Throws storage::BadFile.
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
    Found enter(lts::StateView row, std::uint64_t hash) override;
    void close_level() override;
    std::size_t read(Level level, std::uint64_t first, std::size_t most, std::vector<lts::Word>& rows) override {
        return kept_.files().read(level, first, most, rows);
    }
    [[nodiscard]] bool wants_to_settle() const override;
    [[nodiscard]] std::optional<Level> settle() override;
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
    std::uint64_t most_open_;  ///< rows
    Store open_;
    storage::SortedRuns runs_;  ///< other rows of the open level, perhaps some of `open_` too
    RowsAside aside_;
    Level late_level_ = 0;   ///< the least that lacks rows
    Store late_;             ///< these rows
    std::uint64_t met_ = 0;  ///< rows since the last settling
    std::uint64_t new_ = 0;  ///< of these, entered
    Figures figures_;
};

}  // namespace robochart::refine
