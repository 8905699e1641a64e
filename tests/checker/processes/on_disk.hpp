// Searches whose rows are on disk, with as little memory as can be.
#pragma once

#include "checker/refine/verdict/level_strategy.hpp"

namespace robochart::refine {

/// Rows on disk in a fresh folder, 2 KiB for all in memory, filters of four bits and few settlings, so that rows of
/// open levels are written, filters overflow, and many searches roll back.
class OnDisk final : public LevelStrategy {
public:
    explicit OnDisk(unsigned ranks) : ranks_(ranks) {}
    std::optional<Violation> search(lts::TransitionSystem& system, const LevelQuestion& question, Budget& budget,
                                    Statistics& statistics) override;

private:
    unsigned ranks_;
};

}  // namespace robochart::refine
