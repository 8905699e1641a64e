// SPDX-License-Identifier: Apache-2.0
#include "tests/checker/processes/thread_programs.hpp"

#include "checker/refine/levels/thread_exchange.hpp"

namespace robochart::refine {

void as_programs(unsigned programs, unsigned threads, const std::function<void(Exchange&)>& work) {
    as_ranks(programs, [&](Exchange& exchange) { as_ranks(exchange, threads, work); });
}

std::optional<Violation> ThreadPrograms::search(lts::TransitionSystem& system, const LevelQuestion& question,
                                                Budget& budget, Statistics& statistics) {
    const unsigned threads = threads_for(system, threads_);
    std::vector<std::unique_ptr<lts::TransitionSystem>> others;
    for (unsigned program = 1; program < programs_; ++program) {
        others.push_back(system.clone_for_thread());
        if (!others.back()) return ThreadRanks(1).search(system, question, budget, statistics);
    }
    Limits quiet = budget.limits();
    quiet.progress = {};
    std::optional<Violation> found;
    as_ranks(programs_, [&](Exchange& exchange) {
        if (exchange.rank() == 0) {
            found = search_by_threads(exchange, threads, system, question, budget, statistics);
            return;
        }
        Budget own(quiet);
        Statistics ignored;
        search_by_threads(exchange, threads, *others[exchange.rank() - 1], question, own, ignored);
    });
    return found;
}

}  // namespace robochart::refine
