// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/levels/saved_row_store.hpp"

#include "base/diagnostics/containers.hpp"
#include "checker/storage/sort_rows.hpp"

namespace robochart::refine {

using lts::StateStore;
using lts::StateView;

SavedRowStore::SavedRowStore(KeptWhere where)
    : RowStore(where.kind.width), kept_(std::move(where)), rows_(std::make_unique<MemoryRowStore>(width())) {
    std::vector<std::pair<Level, std::vector<lts::Word>>> unsure;
    kept_.load_checkpoint(record(), [&](Level level, StateView row) {
        unsure.emplace_back(level, std::vector<lts::Word>(row.begin(), row.end()));
    });
    diagnostics::sort_unique(unsure);
    // An unsure row can only be looked up when memory contains its level and all earlier levels.
    auto next = unsure.begin();
    for (Level level = 0; level < kept_.files().levels(); ++level) {
        load_until(level + 1);
        for (; next != unsure.end() && next->first == level; ++next)
            if (!rows_->contains_row(next->second)) late_.push_back(std::move(*next));
    }
}

/// Loads the levels before this level from the files.
void SavedRowStore::load_until(Level level) {
    for (Level next = rows_->levels(); next < level; ++next) {
        kept_.files().each_block(next, [this](std::span<const lts::Word> rows) {
            kept_.poll();
            for (std::size_t at = 0; at < rows.size(); at += width()) {
                const StateView row = rows.subspan(at, width());
                rows_->enter_row(row, StateStore::hash(row));
            }
        });
        rows_->close_level();
    }
}

std::optional<Level> SavedRowStore::settle_unsure_rows() {
    if (late_.empty()) return std::nullopt;
    return late_.front().first;
}

/// Rolls back to a level. If memory does not contain it, first writes the levels in memory and then reads the earlier
/// ones again. Until that is done, the files contain all levels, so a checkpoint during the rollback is a checkpoint
/// from before the rollback.
void SavedRowStore::roll_back_to(Level level) {
    save_levels(true);
    auto rows = std::make_unique<MemoryRowStore>(width());
    rows_.swap(rows);
    rows.reset();
    load_until(level);
    if (level < kept_.files().levels())
        kept_.files().each_block(level, [this](std::span<const lts::Word> block) {
            kept_.poll();
            for (std::size_t at = 0; at < block.size(); at += width()) {
                const StateView row = block.subspan(at, width());
                rows_->enter_row(row, StateStore::hash(row));
            }
        });
    for (const auto& [own, row] : late_)
        if (own == level) rows_->enter_row(row, StateStore::hash(row));
    kept_.files().forget_from(level);
    late_.clear();  // rows of other levels are found again in the levels to which they belong
}

void SavedRowStore::save_levels(bool polled) {
    std::vector<lts::Word> rows;
    for (Level level = kept_.files().levels(); level < rows_->levels(); ++level) {
        if (polled) kept_.poll();
        rows.clear();
        rows_->read(level, 0, rows_->rows(level), rows);
        storage::sort_rows(rows, width());
        kept_.files().add_level(rows);
    }
}

/// Writes a checkpoint. If there is no space for all levels, it contains as many of the first levels as possible.
void SavedRowStore::checkpoint() {
    std::vector<lts::Word> late;
    for (const auto& [level, row] : late_) {
        late.insert(late.end(), row.begin(), row.end());
        late.push_back(level);
    }
    storage::sort_rows(late, width() + 1);
    const auto unsure = [&](const storage::TakeRows& take) { take(late); };
    try {
        save_levels(false);
        kept_.checkpoint(record(), unsure);
    } catch (const storage::CannotWrite&) {
        if (kept_.files().levels() > 0) kept_.checkpoint_of_fewer(record(), unsure);
        throw;
    }
}

}  // namespace robochart::refine
