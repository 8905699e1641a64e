#include "checker/refine/verdict/level_strategy.hpp"

#include <stdexcept>

#include "checker/refine/levels/memory_row_store.hpp"
#include "checker/refine/levels/shared_work.hpp"
#include "checker/refine/levels/thread_exchange.hpp"
#include "checker/refine/search/poll_guard.hpp"
#include "checker/refine/verdict/monitors.hpp"

namespace robochart::refine {
namespace {

/// Adds up what a search has seen, also when it is left by an exception.
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
        statistics_.chased += search_.chased();
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
        default:
            return std::make_unique<StateMonitor>(question.kind == LevelQuestion::Kind::deadlock);
    }
}

std::unique_ptr<RowStore> memory_row_store(const LevelQuestion& question, const lts::TransitionSystem& system,
                                           Exchange& /*exchange*/) {
    return std::make_unique<MemoryRowStore>(question.row_width(system.width()));
}

std::optional<Violation> search_as_rank(lts::TransitionSystem& system, const LevelQuestion& question, RowStore& store,
                                        Exchange& exchange, Budget& budget, Statistics& statistics) {
    const std::unique_ptr<Monitor> monitor = monitor_of(question);
    LevelSearch search(system, *monitor, store, exchange, budget, question.divergence);
    const LevelTally tally(search, exchange.ranks(), statistics);
    std::optional<LevelFinding> finding = search.first_violation(question.events_until);
    if (!finding && question.divergence) finding = search.first_divergence();
    if (!finding) return std::nullopt;
    return Violation{finding->kind, std::move(finding->run), std::move(finding->loop), {}};
}

std::optional<Violation> OneRank::search(lts::TransitionSystem& system, const LevelQuestion& question, Budget& budget,
                                         Statistics& statistics) {
    LoneExchange exchange;
    const std::unique_ptr<RowStore> store = make_store_(question, system, exchange);
    return search_as_rank(system, question, *store, exchange, budget, statistics);
}

unsigned threads_for(const lts::TransitionSystem& system, unsigned wanted) {
    return wanted > 1 && system.another() ? wanted : 1;
}

std::optional<Violation> search_by_threads(Exchange& programs, unsigned threads, lts::TransitionSystem& system,
                                           const LevelQuestion& question, const MakeRowStore& make_store,
                                           Budget& budget, Statistics& statistics) {
    Limits quiet = budget.limits();
    quiet.progress = {};
    std::optional<Violation> violation;
    as_ranks(programs, threads, [&](Exchange& exchange) {
        const bool first = exchange.rank() % threads == 0;
        std::unique_ptr<lts::TransitionSystem> another;
        std::unique_ptr<RowStore> store;
        SharedWork ready(exchange);
        ready.attempt([&] {
            if (!first) another = system.another();
            if (!first && !another) throw std::logic_error("the system serves one thread only");
            store = make_store(question, first ? system : *another, exchange);
        });
        ready.sum({});
        Budget own(quiet);
        const PollGuard guard({another.get()}, own);
        Statistics ignored;
        std::optional<Violation> found = search_as_rank(first ? system : *another, question, *store, exchange,
                                                        first ? budget : own, first ? statistics : ignored);
        if (first) violation = std::move(found);
    });
    return violation;
}

std::optional<Violation> ThreadRanks::search(lts::TransitionSystem& system, const LevelQuestion& question,
                                             Budget& budget, Statistics& statistics) {
    LoneExchange alone;
    return search_by_threads(alone, threads_for(system, ranks_), system, question, make_store_, budget, statistics);
}

}  // namespace robochart::refine
