// SPDX-License-Identifier: Apache-2.0
// Stores all rows of a rank in memory.
#pragma once

#include "checker/refine/levels/row_store.hpp"

namespace robochart::refine {

class MemoryRowStore final : public RowStore {
public:
    explicit MemoryRowStore(std::size_t width) : RowStore(width), rows_(width) {}

    [[nodiscard]] Level levels() const override { return static_cast<Level>(ends_.size()); }
    [[nodiscard]] std::uint64_t rows(Level level) const override { return end(level) - begin(level); }
    [[nodiscard]] std::uint64_t size() const override { return rows_.size(); }
    void prefetch(std::uint64_t hash) const override { rows_.prefetch(hash); }
    Found enter_row(lts::StateView row, std::uint64_t hash) override;
    void close_level() override { ends_.push_back(rows_.size()); }
    std::size_t read(Level level, std::uint64_t first, std::size_t most, std::vector<lts::Word>& rows) override;
    [[nodiscard]] std::uint64_t bytes() const override;
    [[nodiscard]] bool contains_row(lts::StateView row) const { return rows_.find(row) != lts::no_state; }

private:
    [[nodiscard]] std::uint64_t begin(Level level) const { return level == 0 ? 0 : ends_[level - 1]; }
    [[nodiscard]] std::uint64_t end(Level level) const { return level < ends_.size() ? ends_[level] : rows_.size(); }

    lts::StateStore rows_;             // in the order of levels
    std::vector<std::uint64_t> ends_;  // ends of the closed levels in rows_
};

}  // namespace robochart::refine
