// SPDX-License-Identifier: Apache-2.0
// Stores rows in memory and writes checkpoints to files.
#pragma once

#include <algorithm>
#include <memory>

#include "checker/refine/levels/kept_levels.hpp"
#include "checker/refine/levels/memory_row_store.hpp"

namespace robochart::refine {

class SavedRowStore final : public RowStore {
public:
    /// Creates a store. If the folder contains checkpoints, the store continues from the newest one. Throws
    /// storage::BadFile.
    explicit SavedRowStore(KeptWhere where);

    /// Returns the number of closed levels. During a rollback, the files contain more levels than the memory, so the
    /// result is the maximum of both numbers.
    [[nodiscard]] Level levels() const override { return std::max(rows_->levels(), kept_.files().levels()); }
    [[nodiscard]] std::optional<std::uint64_t> rows_before() const override { return kept_.rows_before(); }
    [[nodiscard]] std::uint64_t rows(Level level) const override { return rows_->rows(level); }
    [[nodiscard]] std::uint64_t size() const override { return rows_->size(); }
    void prefetch(std::uint64_t hash) const override { rows_->prefetch(hash); }
    Found enter_row(lts::StateView row, std::uint64_t hash) override { return rows_->enter_row(row, hash); }
    void close_level() override { rows_->close_level(); }
    std::size_t read(Level level, std::uint64_t first, std::size_t most, std::vector<lts::Word>& rows) override {
        return rows_->read(level, first, most, rows);
    }
    [[nodiscard]] bool wants_to_settle() const override { return !late_.empty(); }
    [[nodiscard]] std::optional<Level> settle_unsure_rows() override;
    void roll_back_to(Level level) override;
    [[nodiscard]] bool wants_checkpoint() const override { return kept_.checkpoint_due(); }
    void checkpoint() override;
    [[nodiscard]] std::uint64_t bytes() const override { return rows_->bytes() + kept_.files().bytes(); }

private:
    void load_until(Level level);
    void save_levels(bool polled);

    KeptLevels kept_;
    std::unique_ptr<MemoryRowStore> rows_;
    /// Rows that an earlier run has missed because it did not have all rows in memory. Each row has its level. The rows
    /// are sorted by level.
    std::vector<std::pair<Level, std::vector<lts::Word>>> late_;
};

}  // namespace robochart::refine
