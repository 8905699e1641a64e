// SPDX-License-Identifier: Apache-2.0
#include "checker/ranks/served_ranks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "checker/ranks/job.hpp"
#include "checker/refine/levels/shared_work.hpp"
#include "checker/refine/levels/thread_exchange.hpp"
#include "checker/refine/search/poll_guard.hpp"
#include "checker/storage/storage_error.hpp"

namespace robochart::ranks {

using refine::Exchange;

ServedRanks::~ServedRanks() {
    try {
        end();
    } catch (const std::exception&) {
        // Errors are ignored: ranks that are lost need no message, and a destructor cannot report a lack of memory.
    }
}

void ServedRanks::end() {
    if (ended_ || others_wait_) return;
    ended_ = true;
    std::string nothing;
    exchange_.broadcast(nothing);
}

std::optional<refine::Violation> ServedRanks::search(lts::TransitionSystem& system,
                                                     const refine::LevelQuestion& question, refine::Budget& budget,
                                                     refine::Statistics& statistics) {
    if (others_wait_) throw refine::LimitReached("an error has parted the ranks in an earlier search");
    const unsigned threads = refine::threads_for(system, std::max(1U, budget.limits().threads));
    const std::optional<std::string> job = encode(system, question, budget.limits(), threads, program_);
    if (!job) return refine::ThreadRanks(1).search(system, question, budget, statistics);
    exchange_.begin_together();
    try {
        return search_together(system, question, *job, threads, budget, statistics);
    } catch (...) {
        others_wait_ = !exchange_.left_together();
        throw;
    }
}

std::optional<refine::Violation> ServedRanks::search_together(lts::TransitionSystem& system,
                                                              const refine::LevelQuestion& question,
                                                              const std::string& job, unsigned threads,
                                                              refine::Budget& budget, refine::Statistics& statistics) {
    std::string sent = job;
    exchange_.broadcast(sent);
    refine::run_together(exchange_, [] {});  // all ranks now know the search
    return refine::search_by_threads(exchange_, threads, system, question, budget, statistics);
}

namespace {

/// Takes part in one search. Ignores interrupts, because the first program handles them and informs all other
/// programs.
void take_part(Exchange& exchange, const std::string& bytes, const std::string& program) {
    process::EventTable events;
    process::TermStore terms(events);
    Job job;
    refine::run_together(exchange, [&] {
        if (sender_of(bytes) != program)
            throw storage::BadFile(
                fmt::format("program {} is of another build than program 0: all must be one robochart-verify-mpi",
                            exchange.rank()));
        job = decode(bytes, terms);
    });
    refine::Limits limits;
    limits.max_states = job.max_states;
    limits.memory_bytes = job.memory_bytes;
    limits.deadline = job.deadline;
    refine::Budget budget(limits);
    const refine::PollGuard guard({job.system.get()}, budget);
    refine::Statistics ignored;
    refine::search_by_threads(exchange, job.threads, *job.system, job.question, budget, ignored);
}

}  // namespace

void serve_searches(Exchange& exchange, const std::string& program) {
    for (;;) {
        exchange.begin_together();
        std::string job;
        exchange.broadcast(job);
        if (job.empty()) return;
        try {
            take_part(exchange, job, program);
        } catch (const refine::RankLost&) {
            throw;
        } catch (const std::exception&) {
            // If all ranks have left the search together, rank 0 reports why. Otherwise other ranks still wait for this
            // one, so this program must end.
            if (!exchange.left_together()) throw;
        }
    }
}

}  // namespace robochart::ranks
