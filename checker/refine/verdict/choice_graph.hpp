// SPDX-License-Identifier: Apache-2.0
// Explores a specification so that an external choice whose operands have taus is a single state. The operands resolve
// their taus independently of each other. So the taus of n operands with d states each lead to d^n states. However, the
// operands alone determine everything that refinement needs to know about these states (UCS 9.2, the rules of [];
// Roscoe, The Theory and Practice of Concurrency, 1998, 8.2 to 8.4, for the resulting equations in T, N and F):
//
//   1. The states that taus reach from P1 [] ... [] Pn are the choices Q1 [] ... [] Qn in which taus lead from each Pi
//      to Qi, because a tau of one operand changes only this operand.
//   2. Such a state performs a visible event or tick iff some Qi does, and then continues as Qi does. So after an event
//      the choice is in the states in which the operands are after it.
//   3. It has the acceptance {tick} if some Qi can tick (stability.hpp). Otherwise it is stable iff all Qi are stable,
//      and it accepts the union of their acceptances. So the acceptances of the choice are {tick}, if an operand has
//      it, and the unions of one other acceptance of each operand. A union grows with its parts, so the minimal
//      acceptances of the operands, and whether they can tick, suffice to compute the minimal ones of the choice.
//   4. An infinite sequence of taus contains infinitely many taus of one operand. So the choice diverges iff an operand
//      diverges.
//
// The argument is about the transitions of states and not about a model. So it also applies to choices whose operands
// contain prioritise or hiding. A choice inside such an operator is part of that operator's state and is not split.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "checker/refine/verdict/lazy_graph.hpp"

namespace robochart::refine {

/// Returns the sets that contain no other of the given sets, sorted by size, then by events. Polls the budget.
[[nodiscard]] std::vector<process::EventSet> minimal_sets(std::vector<process::EventSet> sets, Budget& budget);

/// A graph that has fewer states than a LazyGraph, but the same traces, and the same minimal acceptances and
/// divergences after each trace.
class ChoiceGraph {
public:
    using Edge = LazyGraph::Edge;

    ChoiceGraph(lts::TransitionSystem& system, Budget& budget) : graph_(system, budget), budget_(budget) {}

    lts::StateIndex initial() { return graph_.initial(); }
    /// Returns the transitions of the state, ascending by event. For a whole choice, these are the visible events and
    /// ticks of all states that its operands reach by taus. The result is valid until the next call.
    std::span<const Edge> edges(lts::StateIndex state);
    /// Returns the transitions with one event. The result is valid until the next call.
    std::span<const Edge> edges(lts::StateIndex state, process::Event event);
    /// Returns the minimal acceptances of the state. For a whole choice, these are the minimal acceptances of all
    /// states that its taus reach. The result is empty if none of these states is stable.
    std::vector<process::EventSet> acceptances(lts::StateIndex state);
    /// Returns the taus of the state; for a whole choice, returns taus to its operands. The state diverges iff an
    /// infinite path of these transitions begins in it. The result is valid until the next call.
    std::span<const Edge> taus_or_operands(lts::StateIndex state);
    /// Returns the number of states known so far.
    [[nodiscard]] std::size_t size() const { return graph_.size(); }
    /// Returns the packed state with this number.
    [[nodiscard]] lts::StateView state(lts::StateIndex index) const { return graph_.state(index); }

private:
    /// A whole choice is a choice that is a single state, because its taus are not followed.
    struct Whole {
        /// By operand: the operand and the states that its taus reach.
        std::vector<std::vector<lts::StateIndex>> reached;
        std::vector<Edge> operands;  ///< taus to the operands
        std::vector<Edge> edges;     ///< sorted, without duplicates
        std::optional<std::vector<process::EventSet>> acceptances;
        int nesting = 1;  ///< maximal nesting depth of whole choices, including this one
    };
    enum class Form : std::uint8_t { unknown, being_examined, resolved, whole };
    class Depth;

    Form& form_of(lts::StateIndex state);
    Whole* whole_choice(lts::StateIndex state);
    void examine(lts::StateIndex state);
    std::vector<lts::StateIndex> tau_closure(lts::StateIndex operand);
    std::vector<process::EventSet> choice_acceptances(const Whole& whole);

    LazyGraph graph_;
    Budget& budget_;
    std::vector<Form> forms_;                            // by state
    std::unordered_map<lts::StateIndex, Whole> wholes_;  // looked up only, so its order has no effect
    int depth_ = 0;                                      // number of choices that are being examined
};

}  // namespace robochart::refine
