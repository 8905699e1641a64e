// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/verdict/level_strategy.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "checker/refine/levels/shared_work.hpp"
#include "checker/refine/levels/thread_exchange.hpp"
#include "checker/refine/levels/undisturbed_exchange.hpp"
#include "checker/refine/search/poll_guard.hpp"
#include "checker/refine/verdict/monitors.hpp"

namespace robochart::refine {
namespace {

/// Adds the statistics of a search when the search ends, even if it ends by an exception.
class LevelTally {
public:
    LevelTally(const LevelSearch& search, unsigned ranks, Statistics& statistics)
        : search_(search), ranks_(ranks), statistics_(statistics) {}
    LevelTally(const LevelTally&) = delete;
    LevelTally& operator=(const LevelTally&) = delete;
    ~LevelTally() {
        statistics_.states += search_.states();
        statistics_.transitions += search_.transitions();
        statistics_.depth = std::max(statistics_.depth, search_.depth());
        statistics_.chased += search_.chased_state_count();
        statistics_.ranks = ranks_;
    }

private:
    const LevelSearch& search_;
    unsigned ranks_;
    Statistics& statistics_;
};

}  // namespace

std::unique_ptr<Monitor> monitor_of(const LevelQuestion& question) {
    switch (question.kind) {
        case LevelQuestion::Kind::choice:
            return std::make_unique<ChoiceMonitor>();
        case LevelQuestion::Kind::refinement:
            return std::make_unique<TableMonitor>(question.specification, question.model);
        case LevelQuestion::Kind::states:
        case LevelQuestion::Kind::deadlock:
            return std::make_unique<StateMonitor>(question.kind == LevelQuestion::Kind::deadlock);
    }
    throw std::logic_error("a question of no kind");
}

namespace {

/// Polls the budget of a check during work on stored rows. Each poll charges many units of work, because a block has
/// many rows.
class StorageBudget final : public diagnostics::Pollable {
public:
    explicit StorageBudget(Budget& budget) : budget_(budget) {}
    void poll() override {
        constexpr std::uint64_t pieces_a_poll = 256;
        budget_.charge(pieces_a_poll);
    }

private:
    Budget& budget_;
};

using StoreFigures = DiskRowStore::Figures;

/// Searches with a store that is created for this search. When the store is destroyed, `figures` receives its
/// statistics.
std::optional<Violation> search_with_store(lts::TransitionSystem& system, const LevelQuestion& question,
                                           Exchange& exchange, Budget& budget, Statistics& statistics,
                                           StoreFigures& figures) {
    StorageBudget storage_budget(budget);
    std::unique_ptr<RowStore> store;
    run_together(exchange, [&] {
        store = make_row_store(question.rows, question.row_width(system.width()), exchange, storage_budget,
                               [&figures](const StoreFigures& found) { figures = found; });
    });
    const std::unique_ptr<Monitor> monitor = monitor_of(question);
    LevelSearch search(system, *monitor, *store, exchange, budget, question.divergence);
    const LevelTally tally(search, exchange.ranks(), statistics);
    std::optional<LevelFinding> finding = search.first_violation(question.events_until);
    if (!finding && question.divergence) finding = search.first_divergence();
    if (!finding) return std::nullopt;
    return Violation{finding->kind, std::move(finding->run), std::move(finding->loop), {}};
}

/// Waits until no rank has open files. The folder may then be removed or used by the next search. Records the maximum
/// of the statistics over all ranks.
void end_of_stores(Exchange& exchange, const StoreFigures& figures, Statistics& statistics) {
    const auto word = [](std::uint64_t figure) {
        return static_cast<lts::Word>(std::min<std::uint64_t>(figure, std::numeric_limits<lts::Word>::max()));
    };
    lts::Word settled = 0, rolled_back = 0;
    for (const Words& of_rank : exchange.gather({word(figures.settled), word(figures.rolled_back)})) {
        settled = std::max(settled, of_rank[0]);
        rolled_back = std::max(rolled_back, of_rank[1]);
    }
    statistics.settled += settled;
    statistics.rolled_back += rolled_back;
}

std::optional<Violation> search_with_files(lts::TransitionSystem& system, const LevelQuestion& question,
                                           Exchange& exchange, Budget& budget, Statistics& statistics) {
    StoreFigures figures;
    std::optional<Violation> found;
    try {
        found = search_with_store(system, question, exchange, budget, statistics, figures);
    } catch (...) {
        if (!exchange.left_together()) throw;
        exchange.begin_together();
        end_of_stores(exchange, figures, statistics);
        exchange.leave_together();
        throw;
    }
    end_of_stores(exchange, figures, statistics);
    return found;
}

}  // namespace

std::optional<Violation> search_as_rank(lts::TransitionSystem& system, const LevelQuestion& question,
                                        Exchange& exchange, Budget& budget, Statistics& statistics) {
    StoreFigures none;
    if (question.rows.folder.empty()) return search_with_store(system, question, exchange, budget, statistics, none);
    const auto& undisturbed = budget.limits().undisturbed;
    if (exchange.rank() != 0 || !undisturbed) return search_with_files(system, question, exchange, budget, statistics);
    // Only the first rank holds Limits::undisturbed: only its program is killed if it continues after a limit.
    UndisturbedExchange waiting(exchange, undisturbed, [&budget] { return budget.limit_reached(); });
    return search_with_files(system, question, waiting, budget, statistics);
}

unsigned threads_for(const lts::TransitionSystem& system, unsigned limit) {
    return limit > 1 && system.clone_for_thread() ? limit : 1;
}

std::optional<Violation> search_by_threads(Exchange& programs, unsigned threads, lts::TransitionSystem& system,
                                           const LevelQuestion& question, Budget& budget, Statistics& statistics) {
    Limits quiet = budget.limits();
    quiet.progress = {};
    std::optional<Violation> violation;
    as_ranks(programs, threads, [&](Exchange& exchange) {
        const bool first = exchange.rank() % threads == 0;
        std::unique_ptr<lts::TransitionSystem> another;
        run_together(exchange, [&] {
            if (!first) another = system.clone_for_thread();
            if (!first && !another) throw std::logic_error("the system serves one thread only");
        });
        Budget own(quiet);
        const PollGuard guard({another.get()}, own);
        Statistics ignored;
        std::optional<Violation> found = search_as_rank(first ? system : *another, question, exchange,
                                                        first ? budget : own, first ? statistics : ignored);
        if (first) violation = std::move(found);
    });
    return violation;
}

std::optional<Violation> ThreadRanks::search(lts::TransitionSystem& system, const LevelQuestion& question,
                                             Budget& budget, Statistics& statistics) {
    LoneExchange alone;
    return search_by_threads(alone, threads_for(system, ranks_), system, question, budget, statistics);
}

}  // namespace robochart::refine
