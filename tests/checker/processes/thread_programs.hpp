// Threads of this program as programs that share a search, each with several threads: what docs/scale.md has by MPI.
#pragma once

#include <functional>

#include "checker/refine/verdict/level_strategy.hpp"

namespace robochart::refine {

/// Calls `work` in so many programs with so many threads each, as ranks.
void as_programs(unsigned programs, unsigned threads, const std::function<void(Exchange&)>& work);

/// Rows in memory. A system that serves one thread only is searched by one.
class ThreadPrograms final : public LevelStrategy {
public:
    ThreadPrograms(unsigned programs, unsigned threads) : programs_(programs), threads_(threads) {}
    std::optional<Violation> search(lts::TransitionSystem& system, const LevelQuestion& question, Budget& budget,
                                    Statistics& statistics) override;

private:
    unsigned programs_, threads_;
};

}  // namespace robochart::refine
