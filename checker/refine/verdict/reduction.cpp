// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/verdict/reduction.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>

#include "checker/lts/symmetric_system.hpp"
#include "checker/refine/search/poll_guard.hpp"
#include "checker/refine/verdict/unfolding.hpp"

namespace robochart::refine {
namespace {

/// Returns the limits for the search for a shortest run. They leave time to report the result that is already known.
Limits leaving_time(Limits limits) {
    const auto now = std::chrono::steady_clock::now();
    if (limits.deadline) *limits.deadline = now + (std::max(*limits.deadline, now) - now) / 2;
    return limits;
}

class ReducedSearch {
public:
    ReducedSearch(lts::TransitionSystem& system, Budget& budget, const SearchQuestion& question)
        : system_(system), budget_(budget), question_(question) {}

    std::optional<Violation> run(Statistics& statistics) {
        std::shared_ptr<lts::ReducedSystem> reduced = system_.make_reduced_system(question_.followed, budget_);
        find_symmetry();
        const std::optional<Violation> violation = search(reduced, budget_, statistics, nullptr);
        record_reduction(statistics);
        if (!violation || !followed_) return violation;
        return find_shortest(*violation);
    }

private:
    /// Finds the replicas that the assertion does not distinguish.
    void find_symmetry() {
        std::vector<lts::ReplicaSet> replicas;
        for (lts::ReplicaSet set : system_.replicas(budget_)) {
            const std::size_t all = set.size();
            std::erase_if(set, [&](const lts::Replica& replica) {
                return !replica.exchange.empty() && !question_.indifferent(replica.exchange);
            });
            if (set.size() < all) distinguished_ = std::max(distinguished_, all);
            if (set.size() > 1) replicas.push_back(std::move(set));
        }
        if (!replicas.empty()) symmetry_.emplace(std::move(replicas));
    }

    void record_reduction(Statistics& statistics) const {
        statistics.replicas = symmetry_ ? symmetry_->replicas() : 0;
        statistics.distinguished = distinguished_;
    }

    /// Searches the reduced form, or the system if `reduced` is null. Of several symmetric states, searches only one.
    std::optional<Violation> search(const std::shared_ptr<lts::ReducedSystem>& reduced, Budget& budget,
                                    Statistics& statistics, const Violation* known) {
        const PollGuard taus_guard({reduced.get()}, budget);
        std::unique_ptr<lts::TransitionSystem> folded;
        if (symmetry_) folded = std::make_unique<lts::SymmetricSystem>(clone_system(reduced), *symmetry_);
        const PollGuard guard({folded.get()}, budget);
        lts::TransitionSystem& unfolded = reduced ? *reduced : system_;
        lts::TransitionSystem& searched = folded ? *folded : unfolded;
        std::optional<Violation> violation = question_.search(searched, budget, statistics, known);
        followed_ = statistics.chased > 0 || searched.chased_state_count() > 0;
        if (!violation || &searched == &system_) return violation;
        return unfold_violation(system_, {reduced.get(), symmetry_ ? &*symmetry_ : nullptr}, *violation);
    }

    [[nodiscard]] std::unique_ptr<lts::TransitionSystem> clone_system(
        const std::shared_ptr<lts::ReducedSystem>& reduced) const {
        return reduced ? reduced->clone_for_thread() : system_.clone_for_thread();
    }

    Violation find_shortest(Violation known) {
        if (!question_.shortest) {
            known.shortest = false;
            return known;
        }
        const Limits limits = leaving_time(budget_.limits());
        Budget own(limits);
        Statistics ignored;
        try {
            if (std::optional<Violation> found = search(nullptr, own, ignored, &known)) return std::move(*found);
        } catch (const process::Interrupted&) {
            if (limits.interrupted && limits.interrupted()) throw;
            known.shortest = false;
            return known;
        } catch (const std::bad_alloc&) {
            known.shortest = false;
            return known;
        }
        throw std::logic_error("the whole system does not have the violation of its reduced form");
    }

    lts::TransitionSystem& system_;
    Budget& budget_;
    const SearchQuestion& question_;
    std::optional<lts::Symmetry> symmetry_;
    std::size_t distinguished_ = 0;
    bool followed_ = false;  // whether the last search has followed confluent steps
};

/// Thrown to end a search after the symbolic stage has decided its question.
struct Decided {
    Findings findings;
};

/// Searches the system. When the search has taken some time, the symbolic stage tries to decide the question. If it
/// does not succeed, the search continues.
std::optional<Violation> search_with_stage(lts::TransitionSystem& system, Budget& budget, Statistics& statistics,
                                           const SearchQuestion& question) {
    SymbolicStage* const stage = budget.limits().symbolic;
    const auto search = [&] { return ReducedSearch(system, budget, question).run(statistics); };
    if (stage == nullptr || !question.symbolic || budget.limits().by_levels != nullptr) return search();
    const bool uses_specification = question.symbolic->specification != nullptr;
    const CallMoment moment = uses_specification ? CallMoment::between_states : CallMoment::any_poll;
    budget.call_after(stage->delay(), moment, [&] {
        if (std::optional<Findings> findings = stage->decide(system, *question.symbolic, budget))
            throw Decided{std::move(*findings)};
    });
    try {
        std::optional<Violation> violation = search();
        budget.cancel_call();
        return violation;
    } catch (const Decided& decided) {
        statistics = decided.findings.statistics;
        return decided.findings.violation;
    } catch (...) {
        budget.cancel_call();
        throw;
    }
}

}  // namespace

bool is_tau_acyclic(const lts::TransitionSystem& system, Budget& budget) {
    return budget.limits().reduction && system.excludes_tau_cycles(budget);
}

std::uint64_t events_until(const Violation* known) {
    const bool bounded = known != nullptr && known->kind == ViolationKind::divergence;
    return bounded ? known->run.steps.size() : std::numeric_limits<std::uint64_t>::max();
}

std::optional<Violation> search_reduced(lts::TransitionSystem& system, Budget& budget, Statistics& statistics,
                                        const SearchQuestion& question) {
    if (!budget.limits().reduction) return question.search(system, budget, statistics, nullptr);
    return search_with_stage(system, budget, statistics, question);
}

}  // namespace robochart::refine
