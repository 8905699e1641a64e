// Searches whose rows are on disk, with as little memory as can be.
#pragma once

#include <cstdint>

#include "checker/refine/verdict/level_strategy.hpp"

namespace robochart::refine {

/// Rows on disk in a fresh folder, 2 KiB for all in memory, filters of four bits and few settlings, so that rows of
/// open levels are written, filters overflow, and many searches roll back.
class OnDisk final : public LevelStrategy {
public:
    explicit OnDisk(unsigned ranks) : ranks_(ranks) {}
    std::optional<Violation> search(lts::TransitionSystem& system, const LevelQuestion& question, Budget& budget,
                                    Statistics& statistics) override;
    /// How often a search has gone back to the begin of a level, of all searches.
    [[nodiscard]] std::uint64_t rolled_back() const { return rolled_back_; }

private:
    unsigned ranks_;
    std::uint64_t rolled_back_ = 0;
};

}  // namespace robochart::refine
