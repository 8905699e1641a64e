#include "checker/refine/verdict/level_strategy.hpp"

#include <stdexcept>

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

std::optional<Violation> search_as_rank(lts::TransitionSystem& system, const LevelQuestion& question,
                                        Exchange& exchange, Budget& budget, Statistics& statistics) {
    constexpr std::uint64_t pieces_a_poll = 256;
    const auto report = [&statistics](const DiskRowStore::Figures& figures) {
        statistics.settled += figures.settled;
        statistics.rolled_back += figures.rolled_back;
    };
    SharedWork ready(exchange);
    std::unique_ptr<RowStore> store;
    ready.attempt([&] {
        store = make_row_store(
            question.rows, question.row_width(system.width()), exchange, [&budget] { budget.charge(pieces_a_poll); },
            report);
    });
    ready.sum({});
    const std::unique_ptr<Monitor> monitor = monitor_of(question);
    LevelSearch search(system, *monitor, *store, exchange, budget, question.divergence);
    const LevelTally tally(search, exchange.ranks(), statistics);
    std::optional<LevelFinding> finding = search.first_violation(question.events_until);
    if (!finding && question.divergence) finding = search.first_divergence();
    if (!finding) return std::nullopt;
    return Violation{finding->kind, std::move(finding->run), std::move(finding->loop), {}};
}

unsigned threads_for(const lts::TransitionSystem& system, unsigned wanted) {
    return wanted > 1 && system.another() ? wanted : 1;
}

std::optional<Violation> search_by_threads(Exchange& programs, unsigned threads, lts::TransitionSystem& system,
                                           const LevelQuestion& question, Budget& budget, Statistics& statistics) {
    Limits quiet = budget.limits();
    quiet.progress = {};
    std::optional<Violation> violation;
    as_ranks(programs, threads, [&](Exchange& exchange) {
        const bool first = exchange.rank() % threads == 0;
        std::unique_ptr<lts::TransitionSystem> another;
        SharedWork ready(exchange);
        ready.attempt([&] {
            if (!first) another = system.another();
            if (!first && !another) throw std::logic_error("the system serves one thread only");
        });
        ready.sum({});
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
