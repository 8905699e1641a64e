// SPDX-License-Identifier: Apache-2.0
// Searches pairs breadth first. A pair consists of a state of the system and a node of a monitor, which observes the
// runs of the system. States are expanded in the order of discovery. So the first violation that the search finds has a
// shortest run, and every search finds the same violation first.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "checker/lts/state_store.hpp"
#include "checker/refine/search/antichain.hpp"
#include "checker/refine/search/budget.hpp"
#include "checker/refine/search/expansion.hpp"
#include "checker/refine/search/monitor.hpp"
#include "checker/refine/search/parallel_level.hpp"
#include "checker/refine/search/parent_index.hpp"
#include "checker/refine/search/run.hpp"
#include "checker/refine/search/tau_cycle.hpp"

namespace robochart::refine {

/// A violation: the pair at the end of the run and, for a forbidden event, the event after this pair.
struct Finding {
    ViolationKind kind;
    lts::StateIndex pair;
    process::Event event = process::tau;
};

class Search {
public:
    /// The pairs that are stored: all pairs, or only those that no other pair covers (antichain.hpp).
    enum class Pairs { all, antichain };
    /// `note_taus` must be true if first_tau_cycle will be called.
    Search(lts::TransitionSystem& system, Monitor& monitor, Budget& budget, bool note_taus = false,
           Pairs pairs = Pairs::all);

    Search(const Search&) = delete;
    Search& operator=(const Search&) = delete;
    ~Search();

    /// Returns the violation with the shortest run, or no value if all pairs have been visited. Among runs of the same
    /// length, a state's fault comes before a forbidden event. Throws LimitReached. If the shortest run to a pair has
    /// `events_until` steps or more, the search follows only taus from this pair. This restriction is correct if the
    /// search looks for the first pair on a cycle of taus, and a run of `events_until` steps is known to lead to that
    /// pair.
    std::optional<Finding> first_violation(std::uint64_t events_until = std::numeric_limits<std::uint64_t>::max());
    /// Returns the first pair on a tau cycle. Call it after a search that noted taus and found no violation. After a
    /// search that reached the limit of states, returns the first pair on a cycle of visited pairs.
    std::optional<lts::StateIndex> first_tau_cycle();
    /// Returns a shortest cycle of taus through the pair as a list of pairs. The last pair of the list is the given
    /// pair.
    std::vector<lts::StateIndex> tau_cycle(lts::StateIndex pair);

    /// Returns the pairs on the run by which the pair was found.
    [[nodiscard]] std::vector<lts::StateIndex> path_to(lts::StateIndex pair) const;
    [[nodiscard]] Monitor::Node node(lts::StateIndex pair) const { return nodes_ ? pairs_[pair][0] : 0; }
    [[nodiscard]] lts::StateView state(lts::StateIndex pair) const {
        return nodes_ ? pairs_[pair].subspan(1) : pairs_[pair];
    }
    /// Returns the run along these pairs, which starts at the first pair.
    [[nodiscard]] Run run_along(const std::vector<lts::StateIndex>& pairs, bool by_taus_alone = false);

    [[nodiscard]] std::uint64_t states() const { return pairs_.size(); }
    [[nodiscard]] bool stores_all_pairs() const { return antichain_ == nullptr; }
    [[nodiscard]] std::uint64_t transitions() const { return transitions_; }
    [[nodiscard]] std::uint64_t depth() const { return depth_; }
    [[nodiscard]] std::uint64_t chased_state_count() const { return chased_; }

private:
    void begin();
    void follow_taus_alone();
    std::optional<Finding> search_level(lts::StateIndex first, lts::StateIndex end);
    std::optional<Finding> search_antichain_level(lts::StateIndex first, lts::StateIndex end);
    std::optional<Finding> enter_results(const Expansion& expansion, lts::StateIndex first);
    void insert(const Expansion& expansion, lts::StateIndex pair, std::size_t first, std::size_t end);
    std::optional<Finding> search_alone(lts::StateIndex first, lts::StateIndex end);
    std::optional<Finding> search_wide_level(lts::StateIndex first, lts::StateIndex end);
    bool several_threads();
    lts::StateStore::Insertion enter_pair(lts::StateView row, std::uint64_t hash);
    class TauRows;
    [[nodiscard]] std::optional<lts::StateIndex> tau_vertex(lts::StateIndex pair);
    void leave_out_acyclic_taus();
    [[nodiscard]] GraphView tau_graph();
    void tau_targets(lts::StateIndex pair, std::vector<lts::StateIndex>& targets);
    void record_block(const ParallelLevel::Block& block);

    lts::TransitionSystem& system_;
    // The system with only those taus that may lie on cycles. If it is null, all taus are followed.
    std::unique_ptr<lts::TransitionSystem> cycle_system_;
    Monitor& monitor_;
    Budget& budget_;
    const bool nodes_;  // pairs begin with the monitor's node
    lts::StateStore pairs_;
    ParentIndex parents_;
    bool note_taus_;
    BackTargets back_taus_;  // every cycle of taus contains one of them
    std::uint64_t expanded_ = 0;
    std::uint64_t transitions_ = 0;
    std::uint64_t depth_ = 0;
    std::uint64_t chased_ = 0;

    Expander expander_;
    Expansion expansion_;
    std::unique_ptr<Antichain> antichain_;  // with an antichain, the vertices of the tau graph are states
    std::unique_ptr<ParallelLevel> wide_;
    bool one_thread_ = false;
    bool taus_alone_ = false;
    bool ahead_ = false;                // whether several pairs may be expanded before any target is looked up
    std::optional<Finding> forbidden_;  // the first forbidden event, stored until its level is finished
};

}  // namespace robochart::refine
