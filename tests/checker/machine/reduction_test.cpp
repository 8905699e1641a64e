// What is left of a compiled process when confluent taus are followed is equal to all of it, by branching bisimilarity
// with explicit divergence, on random processes and random rules. Every condition of the proof is needed: without it
// some of these differ.
#include <gtest/gtest.h>

#include <iostream>

#include "checker/machine/compiler.hpp"
#include "checker/machine/reduced_system.hpp"
#include "tests/checker/lts/bisimilar.hpp"
#include "tests/checker/machine/random_rules.hpp"
#include "tests/checker/processes/random_cases.hpp"
#include "tests/checker/processes/translate.hpp"

namespace robochart::machine {
namespace {

using lts::Equivalence;
using lts::Graph;
using process::Op;
using process::Scripted;

constexpr std::size_t most_states = 100'000;

/// What the comparisons have seen, so that they cannot become empty.
struct Seen {
    int smaller = 0;    ///< systems of which states were left out
    int diverging = 0;  ///< of these, those with a cycle of taus
    std::uint64_t states = 0, kept = 0;
};

bool loops_by_tau(const Graph& quotient) {
    for (lts::StateIndex state = 0; state < quotient.size(); ++state)
        for (const lts::Edge& edge : quotient.edges(state))
            if (edge.event == process::tau && edge.target == state) return true;
    return false;
}

/// Whether the reduced system is equal to the whole.
bool keeps_everything(lts::TransitionSystem& whole, Seen& seen) {
    const auto reduced = whole.reduced({});
    if (!reduced) return false;
    const Graph all = lts::graph_of(whole, most_states);
    const Graph kept = lts::graph_of(*reduced, most_states);
    const Graph quotient = lts::minimise(all, Equivalence::branching_with_divergence).graph;
    const Graph quotient_of_kept = lts::minimise(kept, Equivalence::branching_with_divergence).graph;
    seen.states += all.size();
    seen.kept += kept.size();
    if (kept.size() < all.size()) {
        ++seen.smaller;
        if (loops_by_tau(quotient)) ++seen.diverging;
    }
    return kept.size() <= all.size() && quotient.size() == quotient_of_kept.size() &&
           quotient.edge_count() == quotient_of_kept.edge_count() &&
           lts::bisimilar(all, kept, Equivalence::branching_with_divergence);
}

TEST(Reduction, KeepsRandomRules) {
    const int wanted = refine::wanted_checks(4'000);
    Scripted s;
    for (Event i = 0; i < RandomRules::visible; ++i) s.event("e" + std::to_string(i));
    RandomRules rules(2022);
    Seen seen;
    for (int round = 0; round < wanted; ++round) {
        SupercombinatorSystem whole(rules.next(s.stop()), s.store);
        ASSERT_TRUE(keeps_everything(whole, seen)) << "round " << round;
    }
    std::cout << seen.smaller << " of " << wanted << " with fewer states, " << seen.diverging
              << " of them divergent; states " << seen.states << ", kept " << seen.kept << "\n";
    EXPECT_GT(seen.smaller * 5, wanted);
    EXPECT_GT(seen.diverging * 20, wanted);
}

TEST(Reduction, KeepsRandomProcesses) {
    const int wanted = refine::wanted_checks(1'000);
    refine::RandomCases cases(22);
    Seen seen;
    int compared = 0;
    while (compared < wanted) {
        const refine::RandomCases::Explored each = cases.next();
        for (const refine::naive::Process& main : each.asked.script.mains) {
            refine::Translation translation(each.asked.script);
            Compiler compiler(translation.semantics());
            const auto whole = compiler.compile(translation.term(main), {});
            if (!whole) continue;
            ++compared;
            ASSERT_TRUE(keeps_everything(*whole, seen)) << show(each.asked.script);
        }
    }
    std::cout << seen.smaller << " of " << compared << " with fewer states, " << seen.diverging
              << " of them divergent; states " << seen.states << ", kept " << seen.kept << "\n";
    EXPECT_GT(seen.smaller * 10, compared);
}

}  // namespace
}  // namespace robochart::machine
