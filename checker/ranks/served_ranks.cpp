#include "checker/ranks/served_ranks.hpp"

#include "checker/ranks/job.hpp"
#include "checker/refine/levels/thread_exchange.hpp"
#include "checker/refine/search/poll_guard.hpp"

namespace robochart::ranks {

using refine::Exchange;
using refine::RowStore;

ServedRanks::~ServedRanks() {
    try {
        std::string nothing;
        exchange_.broadcast(nothing);
    } catch (const refine::RankLost&) {
        // It needs no end any more.
    }
}

std::optional<refine::Violation> ServedRanks::search(lts::TransitionSystem& system,
                                                     const refine::LevelQuestion& question, refine::Budget& budget,
                                                     refine::Statistics& statistics) {
    std::optional<std::string> job = encode(system, question, budget.limits());
    if (!job) return refine::OneRank(make_store_).search(system, question, budget, statistics);
    exchange_.broadcast(*job);
    refine::SharedWork ready(exchange_);
    std::unique_ptr<RowStore> store;
    ready.attempt([&] { store = make_store_(question, system, exchange_); });
    ready.sum({});
    return refine::search_as_rank(system, question, *store, exchange_, budget, statistics);
}

namespace {

/// One search. Its own budget has no deadline and no interrupt: those are rank 0's, of which all ranks hear.
void take_part(Exchange& exchange, const std::string& bytes, const refine::MakeRowStore& make_store) {
    process::EventTable events;
    process::TermStore terms(events);
    Job job;
    std::unique_ptr<RowStore> store;
    refine::SharedWork ready(exchange);
    ready.attempt([&] {
        job = decode(bytes, terms);
        store = make_store(job.question, *job.system, exchange);
    });
    ready.sum({});
    refine::Limits limits;
    limits.max_states = job.max_states;
    limits.memory_bytes = job.memory_bytes;
    refine::Budget budget(limits);
    const refine::PollGuard guard({job.system.get()}, budget);
    refine::Statistics ignored;
    refine::search_as_rank(*job.system, job.question, *store, exchange, budget, ignored);
}

}  // namespace

void serve(Exchange& exchange, const refine::MakeRowStore& make_store) {
    for (;;) {
        exchange.begin_together();
        std::string job;
        exchange.broadcast(job);
        if (job.empty()) return;
        try {
            take_part(exchange, job, make_store);
        } catch (const refine::RankLost&) {
            throw;
        } catch (const std::exception&) {
            // If all ranks have left the search together, rank 0 says why. Else others wait for this one.
            if (!exchange.left_together()) throw;
        }
    }
}

}  // namespace robochart::ranks
