// SPDX-License-Identifier: Apache-2.0
// Finds cycles of taus among the rows of all ranks. Every cycle contains a marked row (SearchRecord::marks). The
// algorithm follows taus from the marked rows. Then it repeatedly removes rows to which no tau of a remaining row
// leads. If some rows remain, there is a cycle, because a tau of a remaining row leads to each remaining row. (The
// algorithm is OWCTY without fairness: Cerna and Pelanek, SPIN 2003; Barnat et al. 2009.) Rank 0 examines the remaining
// rows.
#pragma once

#include <optional>
#include <vector>

#include "checker/refine/levels/exchange.hpp"
#include "checker/refine/levels/row_batches.hpp"
#include "checker/refine/levels/row_store.hpp"
#include "checker/refine/levels/shared_work.hpp"
#include "checker/refine/search/budget.hpp"
#include "checker/refine/search/run.hpp"

namespace robochart::refine {

/// A row on a cycle of taus, and this cycle.
struct TauCycle {
    Words row;
    Level level = 0;
    Run loop;  ///< a shortest cycle back to the row's state
};

/// Represents one rank in the elimination. All ranks must call the same functions.
class TauElimination {
public:
    TauElimination(lts::TransitionSystem& system, RowStore& store, Exchange& exchange, Budget& budget, SharedWork& work,
                   bool nodes);

    /// Returns the first row on a cycle; rows are ordered by level, then by words.
    std::optional<TauCycle> least_cycle();

private:
    class Targets;
    using OnRow = std::function<void(lts::StateView row, std::uint64_t hash)>;
    using Waiting = std::function<std::optional<lts::StateIndex>()>;

    void repeat_rounds(const Waiting& waiting, const OnRow& on_target);
    void find_reached_rows();
    void eliminate();
    [[nodiscard]] std::uint64_t left_everywhere();
    std::vector<Words> at_first_rank();
    TauCycle decide(std::vector<Words> rows);
    [[nodiscard]] lts::StateView state(lts::StateView row) const { return nodes_ ? row.subspan(1) : row; }

    lts::TransitionSystem& system_;
    RowStore& store_;
    Exchange& exchange_;
    Budget& budget_;
    SharedWork& work_;
    const bool nodes_;
    RowBatches batches_;
    lts::StateStore reached_;
    std::vector<std::uint32_t> taus_to_;  // by reached row: the number of taus that lead to it from remaining rows
    std::vector<lts::StateIndex> dropped_;
};

}  // namespace robochart::refine
