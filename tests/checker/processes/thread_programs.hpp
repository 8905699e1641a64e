// SPDX-License-Identifier: Apache-2.0
// Simulates several programs with several threads each that share a search. The threads of one program play these
// programs. docs/scale.md describes the version with MPI.
#pragma once

#include <functional>

#include "checker/refine/verdict/level_strategy.hpp"

namespace robochart::refine {

/// Calls `work` as each rank of this many programs with this many threads each.
void as_programs(unsigned programs, unsigned threads, const std::function<void(Exchange&)>& work);

/// Searches with rows in memory. If a system supports only one thread, one thread searches it.
class ThreadPrograms final : public LevelStrategy {
public:
    ThreadPrograms(unsigned programs, unsigned threads) : programs_(programs), threads_(threads) {}
    std::optional<Violation> search(lts::TransitionSystem& system, const LevelQuestion& question, Budget& budget,
                                    Statistics& statistics) override;

private:
    unsigned programs_, threads_;
};

}  // namespace robochart::refine
