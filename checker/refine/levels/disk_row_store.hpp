// More rows than memory holds (docs/search.md, "Out of core"). All closed levels are in sorted files. In memory are the
// open level and the last closed ones, as many as there is space for, and a filter over all closed levels. A row that
// the filter does not have is new. One that it has, and the levels in memory have not, is almost surely old: it is put
// aside. When many have gathered, and before any verdict, the files are read through for them. One that is in no file
// after all was taken for an old one in error: the search goes back to its level.
#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "checker/refine/levels/kept_levels.hpp"
#include "checker/refine/levels/row_filter.hpp"

namespace robochart::refine {

class DiskRowStore final : public RowStore {
public:
    /// What has happened, for those who measure.
    struct Figures {
        std::uint64_t settled = 0;      ///< times that the files were read through for rows that were unsure
        std::uint64_t rolled_back = 0;  ///< times that the search went back
        std::uint64_t in_error = 0;     ///< rows that were taken for old ones
        std::uint64_t peak_bytes = 0;
    };
    struct Bounds {
        std::uint64_t most_bytes = 0;    ///< that all should take in memory
        unsigned filter_bits = 24;       ///< of each row
        std::uint64_t unsure_part = 10;  ///< of the rows one in so many may be unsure
        std::uint64_t fewest_unsure = 4096;
        std::function<void(const Figures&)> report;  ///< called at the end; may be empty
    };
    /// Goes on from the newest checkpoint in the folder, if there is one. Throws storage::BadFile.
    DiskRowStore(KeptWhere where, Bounds bounds);
    ~DiskRowStore() override;
    DiskRowStore(const DiskRowStore&) = delete;
    DiskRowStore& operator=(const DiskRowStore&) = delete;

    [[nodiscard]] Level levels() const override { return kept_.files().levels(); }
    [[nodiscard]] std::uint64_t rows(Level level) const override {
        return level < levels() ? kept_.files().rows(level) : open_->size();
    }
    [[nodiscard]] std::uint64_t size() const override { return kept_.files().rows() + open_->size(); }
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
    /// Some closed levels, one after the other, in memory.
    struct Segment {
        Level first;
        std::unique_ptr<lts::StateStore> rows;
    };
    using Store = std::unique_ptr<lts::StateStore>;

    [[nodiscard]] Store new_store() const { return std::make_unique<lts::StateStore>(width()); }
    [[nodiscard]] bool in_window(lts::StateView row, std::uint64_t hash) const;
    [[nodiscard]] Level window_begin() const { return window_.empty() ? levels() : window_.front().first; }
    Found put_aside(lts::StateView row, std::uint64_t hash);
    void add_to_window(Level level, Store rows);
    void make_space();
    void fill_filter();
    void fill_window(Level from);
    [[nodiscard]] Level level_of_aside(lts::StateIndex index) const;
    std::size_t mark_those_in(Level level, std::vector<bool>& found);
    void forget_aside();
    [[nodiscard]] KeptLevels::Unsure unsure() const;

    KeptLevels kept_;
    Bounds bounds_;
    RowFilter filter_;
    Store open_;
    std::deque<Segment> window_;  ///< levels window_begin() to levels()-1
    Store aside_;
    std::vector<std::pair<Level, lts::StateIndex>> aside_levels_;  ///< a level, and the first row put aside in it
    Level look_until_ = 0;       ///< those of levels before this one may have what was put aside in an earlier run
    lts::StateStore in_error_;   ///< rows that were taken for old ones once
    std::vector<bool> waiting_;  ///< of these: it is in no level yet
    KeptLevels::Unsure late_;    ///< what the last settling has found missing, until the search has gone back
    Figures figures_;
};

}  // namespace robochart::refine
