// SPDX-License-Identifier: Apache-2.0
// Runs searches with rows on disk and with a minimum of memory.
#pragma once

#include <cstdint>

#include "checker/refine/verdict/level_strategy.hpp"

namespace robochart::refine {

/// Stores rows on disk in a new folder, with 2 KiB of memory for each rank and filters of one bit. Rows are settled
/// only when this is unavoidable. So rows of open levels are written to files, filters overflow, and many searches roll
/// back.
class OnDisk final : public LevelStrategy {
public:
    explicit OnDisk(unsigned ranks) : ranks_(ranks) {}
    std::optional<Violation> search(lts::TransitionSystem& system, const LevelQuestion& question, Budget& budget,
                                    Statistics& statistics) override;
    /// Returns how often searches rolled back to the start of a level, over all searches.
    [[nodiscard]] std::uint64_t rolled_back() const { return rolled_back_; }

private:
    unsigned ranks_;
    std::uint64_t rolled_back_ = 0;
};

}  // namespace robochart::refine
