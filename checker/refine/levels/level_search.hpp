// SPDX-License-Identifier: Apache-2.0
// A level-synchronous search by several ranks. This search visits the same product of system and monitor as search.hpp,
// but the hash of a row determines the rank that owns the row, and no parents are stored. The ranks expand a level in
// rounds, exchange the rows that they find, and synchronise at the end of each level. To find a run afterwards, the
// search expands the earlier levels again.
//
// The result depends neither on the number of ranks nor on where rows are stored. If there are several violations at
// the least level, the search reports the fault of a state rather than a forbidden event. Among faults of states, it
// reports the fault of the least row. (Rows are compared by their words.) If a row has several predecessors, the run
// contains the least predecessor, compared by words, then by event, then by revealed event. If a violation is found,
// the statistics include the whole level of the violation.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "checker/refine/levels/exchange.hpp"
#include "checker/refine/levels/row_batches.hpp"
#include "checker/refine/levels/row_store.hpp"
#include "checker/refine/levels/sent_rows.hpp"
#include "checker/refine/levels/shared_work.hpp"
#include "checker/refine/search/budget.hpp"
#include "checker/refine/search/expansion.hpp"
#include "checker/refine/search/run.hpp"

namespace robochart::refine {

/// A violation with a shortest run, which includes the step of a forbidden event.
struct LevelFinding {
    ViolationKind kind = ViolationKind::trace;
    Run run;
    Run loop;  ///< divergence: taus from the run's last state back to this state
};

/// Represents one rank in a search. All functions except the statistics are collective, and all ranks get the same
/// results.
class LevelSearch {
public:
    /// `monitor` must number its nodes in the same way at each rank. The rows of `store` have the system's width, plus
    /// one word if the monitor has nodes. `note_taus` must be true if first_divergence will be called.
    LevelSearch(lts::TransitionSystem& system, Monitor& monitor, RowStore& store, Exchange& exchange, Budget& budget,
                bool note_taus);
    LevelSearch(const LevelSearch&) = delete;
    LevelSearch& operator=(const LevelSearch&) = delete;
    ~LevelSearch();

    /// Returns the first violation, or no value if the search has visited all rows. From level `events_until` on, the
    /// search follows only taus. If any rank reaches a limit, all ranks write a checkpoint and throw.
    std::optional<LevelFinding> first_violation(std::uint64_t events_until = std::numeric_limits<std::uint64_t>::max());
    /// Returns the first row on a cycle of taus. Rows are ordered by level, then by words. Call this function after a
    /// search that noted taus and found no violation.
    std::optional<LevelFinding> first_divergence();

    // The following statistics cover all ranks. If a violation was found, they cover all levels up to the level of the
    // violation.
    [[nodiscard]] std::uint64_t states() const { return states_; }
    [[nodiscard]] std::uint64_t transitions() const { return transitions_; }
    [[nodiscard]] std::uint64_t chased_state_count() const { return chased_; }
    [[nodiscard]] std::uint64_t depth() const { return depth_; }

    // The following statistics cover only this rank. For each level, returns the processor time for expanding the level
    // and for entering its successors.
    [[nodiscard]] const std::vector<double>& level_seconds() const { return level_seconds_; }
    /// Returns the number of rows sent to other ranks.
    [[nodiscard]] std::uint64_t crossing_rows() const { return batches_.rows(); }
    /// Returns the maximal memory use in bytes of rows and messages at the end of a level.
    [[nodiscard]] std::uint64_t peak_bytes() const { return peak_bytes_; }

private:
    /// A row with a fault of its state, or with an event that is forbidden there.
    struct Fault {
        Words row;
        ViolationKind kind = ViolationKind::trace;
        process::Event event = process::tau;
    };
    /// The sums on which the ranks agree at the end of a round.
    struct Agreed {
        std::uint64_t waiting = 0;  ///< rows of the level that are still to be expanded
        std::uint64_t known = 0;    ///< rows of all levels
        std::uint64_t open = 0;     ///< rows of the open level
        std::uint64_t transitions = 0, chased = 0;
        std::uint64_t wants_to_settle = 0, wants_checkpoint = 0;
        std::uint64_t faults = 0, forbidden = 0;
    };
    struct Step;

    void begin();
    void write_last_checkpoint();
    void checkpoint(SharedWork& work);
    [[nodiscard]] std::shared_ptr<void> hold_undisturbed() const;
    void close_level_of_store();
    std::optional<LevelFinding> search();
    void expand_level(Level level);
    void expand_some(Level level, std::uint64_t& next);
    void distribute_rows();
    void expand(lts::StateView row);
    void use_expander(bool taus_alone);
    void enter_row(lts::StateView row, std::uint64_t hash, bool by_tau);
    void agree_on_totals(std::uint64_t waiting);
    std::optional<Level> settle_unsure_rows();
    void roll_back_to(Level level);
    void close_level();
    void count_levels(Level last);
    [[nodiscard]] std::uint64_t bytes() const;
    [[nodiscard]] LevelFigures figures_until(std::size_t levels) const;

    std::optional<Fault> least_fault();
    static void keep_least(std::optional<Fault>& least, Fault found);
    LevelFinding finding_of(const Fault& fault, Level level);
    Run run_to(const Words& row, Level level);
    Step last_step(const Words& row, Level level);
    void forbidden_step(const Fault& fault, Run& run);
    [[nodiscard]] lts::StateView state(lts::StateView row) const { return nodes_ ? row.subspan(1) : row; }

    lts::TransitionSystem& system_;
    Monitor& monitor_;
    RowStore& store_;
    Exchange& exchange_;
    Budget& budget_;
    const bool nodes_;
    const bool note_taus_;
    SharedWork work_;
    RowBatches batches_;
    SentRows sent_;
    lts::StateStore no_rows_;  // always empty; the expander needs a store, but the rows are in `store_`
    std::optional<Expander> expander_;
    Expansion expansion_;
    std::vector<lts::Word> block_;    // rows read from the store
    std::vector<std::uint32_t> own_;  // rows of the expansion that belong to this rank
    bool taus_alone_ = false;
    LevelFigures figures_;  // statistics of the level that is being expanded
    LevelFigures before_;   // statistics of the levels before it
    std::optional<Fault> fault_, forbidden_;
    Agreed agreed_;
    std::uint64_t states_ = 0, transitions_ = 0, chased_ = 0, depth_ = 0;
    std::vector<double> level_seconds_;
    std::uint64_t peak_bytes_ = 0;
};

}  // namespace robochart::refine
