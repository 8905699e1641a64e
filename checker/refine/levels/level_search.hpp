// Level-synchronous search by several ranks: the same product of system and monitor as search.hpp, but each row belongs
// to the rank that its hash says, and no parents are kept. The ranks expand a level in rounds, send each other the rows
// found, and agree at the end of each level. Runs are found afterwards, by expanding the levels before once more.
//
// What is found does not depend on the number of ranks, nor on where rows are kept: of several violations at the least
// level, a state's fault comes before a forbidden event, then the least row, by its words; of several predecessors of a
// row, the least by words, then by event and revealed event. Where a violation is found, its whole level is counted.
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

/// A violation with a shortest run; the last step of a forbidden event is part of it.
struct LevelFinding {
    ViolationKind kind = ViolationKind::trace;
    Run run;
    Run loop;  ///< divergence: taus from the run's last state back to it
};

/// One rank's part of a search; all functions but the figures are collective. What a rank finds all know.
class LevelSearch {
public:
    /// `monitor` numbers its nodes in the same way at each rank. `store` has rows of the system's width, and one word
    /// more if the monitor has nodes. `note_taus`: cycles of taus will be asked for.
    LevelSearch(lts::TransitionSystem& system, Monitor& monitor, RowStore& store, Exchange& exchange, Budget& budget,
                bool note_taus);
    LevelSearch(const LevelSearch&) = delete;
    LevelSearch& operator=(const LevelSearch&) = delete;
    ~LevelSearch();

    /// The first violation, none when all rows have been seen. Rows of level `events_until` and later are followed by
    /// taus alone. At a limit, which any rank may reach, all write a checkpoint and throw.
    std::optional<LevelFinding> first_violation(std::uint64_t events_until = std::numeric_limits<std::uint64_t>::max());
    /// After a search without violation that noted taus: the least row, by level and words, on a cycle of taus.
    std::optional<LevelFinding> first_divergence();

    // Of all ranks. Where a violation was found: of the levels up to its own.
    [[nodiscard]] std::uint64_t states() const { return states_; }
    [[nodiscard]] std::uint64_t transitions() const { return transitions_; }
    [[nodiscard]] std::uint64_t chased() const { return chased_; }
    [[nodiscard]] std::uint64_t depth() const { return depth_; }

    // Of this rank.
    /// By level, the processor time of expanding it and entering what it gave.
    [[nodiscard]] const std::vector<double>& level_seconds() const { return level_seconds_; }
    /// Rows sent to others.
    [[nodiscard]] std::uint64_t crossing_rows() const { return batches_.rows(); }
    /// The most that rows and messages have taken in memory at the end of a level.
    [[nodiscard]] std::uint64_t peak_bytes() const { return peak_bytes_; }

private:
    /// A fault at the end of a row's runs, or an event that is forbidden after them.
    struct Fault {
        Words row;
        ViolationKind kind = ViolationKind::trace;
        process::Event event = process::tau;
    };
    /// What the ranks know together at the end of a round.
    struct Agreed {
        std::uint64_t waiting = 0;  ///< rows of the level that have not been expanded
        std::uint64_t known = 0;    ///< rows of all levels
        std::uint64_t open = 0;     ///< rows of the open level
        std::uint64_t transitions = 0, chased = 0;
        std::uint64_t wants_to_settle = 0, wants_checkpoint = 0;
        std::uint64_t faults = 0, forbidden = 0;
    };
    struct Step;

    void begin();
    void keep();
    void checkpoint(SharedWork& work);
    [[nodiscard]] std::shared_ptr<void> undisturbed() const;
    void close_level_of_store();
    std::optional<LevelFinding> search();
    void expand_level(Level level);
    void expand_some(Level level, std::uint64_t& next);
    void take();
    void expand(lts::StateView row);
    void use_expander(bool taus_alone);
    void enter(lts::StateView row, std::uint64_t hash, bool by_tau);
    void agree(std::uint64_t waiting);
    std::optional<Level> settle();
    void roll_back_to(Level level);
    void close_level();
    void count(Level last);
    [[nodiscard]] std::uint64_t bytes() const;
    [[nodiscard]] LevelFigures figures_until(std::size_t levels) const;

    std::optional<Fault> least_fault();
    static void keep_least(std::optional<Fault>& kept, Fault found);
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
    lts::StateStore no_rows_;  // what an expander of rows that lie elsewhere is given
    std::optional<Expander> expander_;
    Expansion expansion_;
    std::vector<lts::Word> block_;    // rows read from the store
    std::vector<std::uint32_t> own_;  // of the expansion's rows, this rank's
    bool taus_alone_ = false;
    LevelFigures figures_;  // of the level that is being expanded
    LevelFigures before_;   // of those before it
    std::optional<Fault> fault_, forbidden_;
    Agreed agreed_;
    std::uint64_t states_ = 0, transitions_ = 0, chased_ = 0, depth_ = 0;
    std::vector<double> level_seconds_;
    std::uint64_t peak_bytes_ = 0;
};

}  // namespace robochart::refine
