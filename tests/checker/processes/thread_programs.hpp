// SPDX-License-Identifier: Apache-2.0
// Simulates programs that share a search, each with several threads, by threads of one program. docs/scale.md describes
// the version with MPI.
#pragma once

#include <functional>

#include "checker/refine/verdict/level_strategy.hpp"

namespace robochart::refine {

/// Calls `work` as a rank in this many programs with this many threads each.
void as_programs(unsigned programs, unsigned threads, const std::function<void(Exchange&)>& work);

/// Rows are in memory. A system that supports only one thread is searched by one thread.
class ThreadPrograms final : public LevelStrategy {
public:
    ThreadPrograms(unsigned programs, unsigned threads) : programs_(programs), threads_(threads) {}
    std::optional<Violation> search(lts::TransitionSystem& system, const LevelQuestion& question, Budget& budget,
                                    Statistics& statistics) override;

private:
    unsigned programs_, threads_;
};

}  // namespace robochart::refine
