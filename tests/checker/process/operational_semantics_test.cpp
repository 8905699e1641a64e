// SPDX-License-Identifier: Apache-2.0
// Tests every firing rule on operands that are small enough to apply the rule by hand.
#include "checker/process/operational_semantics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "scripted.hpp"
#include "tests/rounds.hpp"

namespace robochart::process {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;
using Move = std::pair<std::string, TermId>;

class Rules : public testing::Test {
protected:
    Scripted s;
    OperationalSemantics semantics{s.store};
    TermId stop = s.stop();
    TermId skip = s.skip();
    TermId omega = s.op(Op::omega);
    TermId p1 = s.name("P1");
    TermId q1 = s.name("Q1");
    TermId p = s.prefix("a", p1);                         // a -> P1
    TermId q = s.prefix("b", q1);                         // b -> Q1
    TermId tau_p = s.op(Op::internal_choice, {p, stop});  // performs tau to P or STOP

    std::vector<Move> moves(TermId term) {
        std::vector<Move> list;
        for (const Transition& step : semantics.successors(term))
            list.emplace_back(s.events.name(step.event), step.target);
        return list;
    }
    /// Returns the visible traces up to a length, including ✓.
    std::set<std::vector<std::string>> traces(TermId term, std::size_t length) {
        std::set<std::vector<std::string>> found;
        std::set<std::pair<TermId, std::vector<std::string>>> seen;
        std::vector<std::pair<TermId, std::vector<std::string>>> work{{term, {}}};
        while (!work.empty()) {
            auto item = work.back();
            work.pop_back();
            if (!seen.insert(item).second) continue;
            found.insert(item.second);
            for (const Transition& step : semantics.successors(item.first)) {
                auto trace = item.second;
                if (step.event != tau) trace.push_back(s.events.name(step.event));
                if (trace.size() <= length) work.emplace_back(step.target, trace);
            }
        }
        return found;
    }
};

TEST_F(Rules, StopOmegaSkipDiv) {
    EXPECT_THAT(moves(stop), IsEmpty());
    EXPECT_THAT(moves(omega), IsEmpty());
    EXPECT_THAT(moves(skip), ElementsAre(Move{"✓", omega}));
    const TermId div = s.op(Op::div);
    EXPECT_THAT(moves(div), ElementsAre(Move{"τ", div}));
}

TEST_F(Rules, RunAndChaos) {
    const TermId run = s.over(Op::run, {}, {"a", "b"});
    EXPECT_THAT(moves(run), UnorderedElementsAre(Move{"a", run}, Move{"b", run}));
    const TermId chaos = s.over(Op::chaos, {}, {"a"});
    const std::vector<Move> choice = moves(chaos);
    ASSERT_EQ(choice.size(), 2U);
    EXPECT_EQ(choice[0], (Move{"τ", stop}));
    EXPECT_EQ(choice[1].first, "τ");
    EXPECT_THAT(moves(choice[1].second), ElementsAre(Move{"a", chaos}));
}

TEST_F(Rules, PrefixOffersItsBranchesInEventOrder) {
    s.event("a");
    const TermId menu = s.menu({{"b", stop}, {"a", skip}, {"b", skip}, {"b", stop}});
    EXPECT_THAT(moves(menu), ElementsAre(Move{"a", skip}, Move{"b", stop}, Move{"b", skip}));
}

TEST_F(Rules, CallIsItsBodyWithoutATau) {
    s.bind(p1, p);
    EXPECT_THAT(moves(p1), ElementsAre(Move{"a", p1}));
}

TEST_F(Rules, CallsAreUnfoldedSoManyTimesAtMost) {
    const TermId r1 = s.name("R1");
    s.bind(p1, q1);
    s.bind(q1, stop);
    s.bind(r1, r1);
    EXPECT_EQ(s.store.unfold_calls(p1, 5), stop);
    EXPECT_EQ(s.store.unfold_calls(p1, 1), q1);
    EXPECT_EQ(s.store.unfold_calls(r1, 5), r1);
    EXPECT_EQ(s.store.unfold_calls(stop, 5), stop);
}

TEST_F(Rules, ExternalChoiceIsResolvedByVisibleEventsAndTick) {
    EXPECT_THAT(moves(s.op(Op::external_choice, {p, q})), UnorderedElementsAre(Move{"a", p1}, Move{"b", q1}));
    EXPECT_THAT(moves(s.op(Op::external_choice, {p, skip})), UnorderedElementsAre(Move{"a", p1}, Move{"✓", omega}));
    EXPECT_THAT(moves(s.op(Op::external_choice, {tau_p, q})),
                UnorderedElementsAre(Move{"τ", s.op(Op::external_choice, {p, q})},
                                     Move{"τ", s.op(Op::external_choice, {stop, q})}, Move{"b", q1}));
}

TEST_F(Rules, InternalChoiceIsTwoTaus) {
    EXPECT_THAT(moves(s.op(Op::internal_choice, {p, q, p})), ElementsAre(Move{"τ", p}, Move{"τ", q}));
}

TEST_F(Rules, SlidingChoice) {
    EXPECT_THAT(moves(s.op(Op::sliding, {p, q})), UnorderedElementsAre(Move{"τ", q}, Move{"a", p1}));
    EXPECT_THAT(moves(s.op(Op::sliding, {skip, q})), UnorderedElementsAre(Move{"τ", q}, Move{"✓", omega}));
    EXPECT_THAT(
        moves(s.op(Op::sliding, {tau_p, q})),
        ElementsAre(Move{"τ", s.op(Op::sliding, {p, q})}, Move{"τ", s.op(Op::sliding, {stop, q})}, Move{"τ", q}));
}

TEST_F(Rules, SequentialTurnsTickIntoTau) {
    EXPECT_THAT(moves(s.op(Op::sequential, {p, q})), ElementsAre(Move{"a", s.op(Op::sequential, {p1, q})}));
    EXPECT_THAT(moves(s.op(Op::sequential, {skip, q})), ElementsAre(Move{"τ", q}));
}

TEST_F(Rules, Interrupt) {
    EXPECT_THAT(moves(s.op(Op::interrupt, {p, q})),
                UnorderedElementsAre(Move{"a", s.op(Op::interrupt, {p1, q})}, Move{"b", q1}));
    EXPECT_THAT(moves(s.op(Op::interrupt, {skip, q})), UnorderedElementsAre(Move{"✓", omega}, Move{"b", q1}));
    EXPECT_THAT(moves(s.op(Op::interrupt, {p, skip})),
                UnorderedElementsAre(Move{"✓", omega}, Move{"a", s.op(Op::interrupt, {p1, skip})}));
    EXPECT_THAT(moves(s.op(Op::interrupt, {stop, tau_p})),
                ElementsAre(Move{"τ", s.op(Op::interrupt, {stop, p})}, Move{"τ", s.op(Op::interrupt, {stop, stop})}));
}

TEST_F(Rules, Exception) {
    EXPECT_THAT(moves(s.over(Op::exception, {p, q}, {"a"})), ElementsAre(Move{"a", q}));
    EXPECT_THAT(moves(s.over(Op::exception, {p, q}, {"b"})),
                ElementsAre(Move{"a", s.over(Op::exception, {p1, q}, {"b"})}));
    EXPECT_THAT(moves(s.over(Op::exception, {skip, q}, {"a"})), ElementsAre(Move{"✓", omega}));
}

TEST_F(Rules, SynchronisingChoiceKeepsTheChoiceOnItsEvents) {
    const TermId left = s.menu({{"a", p1}, {"t", p}});
    const TermId right = s.menu({{"b", q1}, {"t", q}});
    EXPECT_THAT(moves(s.over(Op::sync_choice, {left, right}, {"t"})),
                UnorderedElementsAre(Move{"a", p1}, Move{"b", q1}, Move{"t", s.over(Op::sync_choice, {p, q}, {"t"})}));
    EXPECT_THAT(moves(s.over(Op::sync_choice, {left, q}, {"t"})), UnorderedElementsAre(Move{"a", p1}, Move{"b", q1}));
    EXPECT_THAT(moves(s.over(Op::sync_choice, {skip, q}, {"t"})),
                UnorderedElementsAre(Move{"✓", omega}, Move{"b", q1}));
    EXPECT_THAT(moves(s.over(Op::sync_choice, {tau_p, stop}, {"a"})),
                ElementsAre(Move{"τ", s.over(Op::sync_choice, {p, stop}, {"a"})},
                            Move{"τ", s.over(Op::sync_choice, {stop, stop}, {"a"})}));
}

TEST_F(Rules, SynchronisingInterrupt) {
    const TermId left = s.menu({{"a", p1}, {"t", p}});
    const TermId right = s.menu({{"b", q1}, {"t", q}});
    EXPECT_THAT(moves(s.over(Op::sync_interrupt, {left, right}, {"t"})),
                UnorderedElementsAre(Move{"a", s.over(Op::sync_interrupt, {p1, right}, {"t"})}, Move{"b", q1},
                                     Move{"t", s.over(Op::sync_interrupt, {p, q}, {"t"})}));
    EXPECT_THAT(moves(s.over(Op::sync_interrupt, {skip, right}, {"t"})),
                UnorderedElementsAre(Move{"✓", omega}, Move{"b", q1}));
    EXPECT_THAT(moves(s.over(Op::sync_interrupt, {left, skip}, {"t"})),
                UnorderedElementsAre(Move{"✓", omega}, Move{"a", s.over(Op::sync_interrupt, {p1, skip}, {"t"})}));
}

TEST_F(Rules, ParallelSynchronisesOnItsSet) {
    EXPECT_THAT(moves(s.over(Op::parallel, {p, q}, {})),
                UnorderedElementsAre(Move{"a", s.over(Op::parallel, {p1, q}, {})},
                                     Move{"b", s.over(Op::parallel, {p, q1}, {})}));
    EXPECT_THAT(moves(s.over(Op::parallel, {p, q}, {"a"})),
                ElementsAre(Move{"b", s.over(Op::parallel, {p, q1}, {"a"})}));
    const TermId many = s.menu({{"a", stop}, {"a", skip}});
    EXPECT_THAT(moves(s.over(Op::parallel, {many, many, p}, {"a"})),
                ElementsAre(Move{"a", s.over(Op::parallel, {stop, stop, p1}, {"a"})},
                            Move{"a", s.over(Op::parallel, {stop, skip, p1}, {"a"})},
                            Move{"a", s.over(Op::parallel, {skip, stop, p1}, {"a"})},
                            Move{"a", s.over(Op::parallel, {skip, skip, p1}, {"a"})}));
}

TEST_F(Rules, ParallelTerminatesOnlyTogether) {
    EXPECT_THAT(moves(s.over(Op::parallel, {skip, p}, {})),
                ElementsAre(Move{"a", s.over(Op::parallel, {skip, p1}, {})}));
    EXPECT_THAT(moves(s.over(Op::parallel, {skip, skip}, {})), ElementsAre(Move{"✓", omega}));
    EXPECT_THAT(moves(s.over(Op::parallel, {skip, stop}, {})), IsEmpty());
    EXPECT_THAT(moves(s.op(Op::parallel, {}, static_cast<std::uint32_t>(s.set({})))), ElementsAre(Move{"✓", omega}));
    EXPECT_THAT(moves(s.op(Op::alphabetised, {skip, skip}, 0, {s.set({"a"}), s.set({})})),
                ElementsAre(Move{"✓", omega}));
}

TEST_F(Rules, AlphabetisedParallel) {
    const auto both = [&](TermId l, TermId r) {
        return s.op(Op::alphabetised, {l, r}, 0, {s.set({"a", "c"}), s.set({"b", "c"})});
    };
    EXPECT_THAT(moves(both(p, q)), UnorderedElementsAre(Move{"a", both(p1, q)}, Move{"b", both(p, q1)}));
    EXPECT_THAT(moves(both(q, p)), IsEmpty());  // the events are outside the alphabets
    const TermId left = s.prefix("c", p1);
    const TermId right = s.prefix("c", q1);
    EXPECT_THAT(moves(both(left, right)), ElementsAre(Move{"c", both(p1, q1)}));
    EXPECT_THAT(moves(both(left, stop)), IsEmpty());
}

TEST_F(Rules, HidingRevealsWhatItHid) {
    const TermId hidden = s.over(Op::hide, {p}, {"a"});
    EXPECT_THAT(moves(hidden), ElementsAre(Move{"τ", s.over(Op::hide, {p1}, {"a"})}));
    EXPECT_EQ(s.events.name(semantics.successors(hidden)[0].revealed), "a");
    const TermId kept_through = s.op(Op::external_choice, {hidden, q});
    EXPECT_EQ(s.events.name(semantics.successors(kept_through)[0].revealed), "a");
    EXPECT_THAT(moves(s.over(Op::hide, {skip}, {"a"})), ElementsAre(Move{"✓", omega}));
}

TEST_F(Rules, RenamingIsRelationalAndSimultaneous) {
    EXPECT_THAT(moves(s.rename(p, {{"a", "b"}, {"a", "c"}})),
                UnorderedElementsAre(Move{"b", s.rename(p1, {{"a", "b"}, {"a", "c"}})},
                                     Move{"c", s.rename(p1, {{"a", "b"}, {"a", "c"}})}));
    EXPECT_THAT(moves(s.rename(q, {{"a", "b"}})), ElementsAre(Move{"b", s.rename(q1, {{"a", "b"}})}));
    const TermId ab = s.menu({{"a", p1}, {"b", q1}});
    EXPECT_THAT(moves(s.rename(ab, {{"a", "b"}, {"b", "a"}})),
                UnorderedElementsAre(Move{"b", s.rename(p1, {{"a", "b"}, {"b", "a"}})},
                                     Move{"a", s.rename(q1, {{"a", "b"}, {"b", "a"}})}));
    EXPECT_THAT(moves(s.rename(skip, {{"a", "b"}})), ElementsAre(Move{"✓", omega}));
}

TEST_F(Rules, PrioritiseCutsLowerLevels) {
    const TermId abc = s.menu({{"a", stop}, {"b", stop}, {"c", stop}});
    const auto events = [&](TermId term) {
        std::vector<std::string> names;
        for (const Move& move : moves(term)) names.push_back(move.first);
        return names;
    };
    EXPECT_THAT(events(s.prioritise(abc, {{"a"}, {"b"}})), UnorderedElementsAre("a", "c"));  // c is incomparable
    EXPECT_THAT(events(s.prioritise(abc, {{}, {"b"}, {"a"}})), UnorderedElementsAre("b", "c"));
    EXPECT_THAT(events(s.prioritise(abc, {{"a", "b"}, {"c"}})), UnorderedElementsAre("a", "b"));
    const TermId with_tau = s.op(Op::sliding, {abc, stop});
    EXPECT_THAT(events(s.prioritise(with_tau, {{"a"}, {"b"}})), UnorderedElementsAre("τ", "a", "c"));
    const TermId with_tick = s.op(Op::external_choice, {abc, skip});
    EXPECT_THAT(events(s.prioritise(with_tick, {{}, {"a"}})), UnorderedElementsAre("✓", "b", "c"));
}

TEST_F(Rules, ChaseFollowsTheFirstTau) {
    EXPECT_THAT(moves(s.op(Op::chase, {tau_p})), ElementsAre(Move{"a", s.op(Op::chase, {p1})}));
    const TermId hidden_twice = s.over(Op::hide, {s.prefix("h", s.prefix("h", p))}, {"h"});
    EXPECT_THAT(moves(s.op(Op::chase, {hidden_twice})),
                ElementsAre(Move{"a", s.op(Op::chase, {s.over(Op::hide, {p1}, {"h"})})}));
    const TermId div = s.op(Op::div);
    EXPECT_THAT(moves(s.op(Op::chase, {div})), ElementsAre(Move{"τ", s.op(Op::chase, {div})}));
    EXPECT_THAT(moves(s.op(Op::chase, {skip})), ElementsAre(Move{"✓", omega}));
}

TEST_F(Rules, CompressionsAreTheIdentityButDeter) {
    const auto compressed = [&](Compression kind) { return s.op(Op::compress, {p}, static_cast<std::uint32_t>(kind)); };
    EXPECT_EQ(moves(compressed(Compression::sbisim)), moves(p));
    EXPECT_EQ(moves(compressed(Compression::diamond)), moves(p));
    EXPECT_THROW(semantics.successors(compressed(Compression::deter)), SemanticsError);
}

TEST_F(Rules, RecursionWithoutAnEventIsReported) {
    s.bind(p1, s.op(Op::external_choice, {p1, q}));
    EXPECT_THROW(semantics.successors(p1), SemanticsError);
    EXPECT_THROW(semantics.successors(p1), SemanticsError) << "the same answer when asked again";
    s.bind(q1, s.op(Op::internal_choice, {q1, q}));  // guarded by a tau: a divergence, not an error
    EXPECT_THAT(moves(q1), ElementsAre(Move{"τ", q1}, Move{"τ", q}));
}

TEST_F(Rules, DeepTermsCostNoMachineStack) {
    TermId deep = p;
    for (std::size_t i = 0; i < tests::size_of_input(300'000); ++i) deep = s.over(Op::hide, {deep}, {"h"});
    EXPECT_EQ(moves(deep).size(), 1U);
    EXPECT_FALSE(describe(s.store, deep).empty());
}

// With FDR's synchronising termination, a terminated operand of a parallel composition does not block time. TSKIP =
// SKIP [] tock -> TSKIP and the other definitions follow the rewriting of timed sections (semantics 3.10).
TEST_F(Rules, TimeGoesOnAfterOneSideOfAnInterleavingHasEnded) {
    const TermId tskip = s.name("TSKIP");
    s.bind(tskip, s.op(Op::external_choice, {skip, s.prefix("tock", tskip)}));
    const auto timed = [&](const std::string& event, TermId after) {
        const TermId self = s.name(event + "->..");
        s.bind(self, s.menu({{event, after}, {"tock", self}}));
        return self;
    };
    const auto wait = [&](int units) {
        TermId rest = tskip;
        for (int i = 0; i < units; ++i) rest = s.prefix("tock", rest);
        return rest;
    };
    // Deadline(a -> SKIP, 2) = (a -> SKIP) /\ (WAIT(2); USTOP), whose operands synchronise on tock.
    const TermId deadline =
        s.over(Op::sync_interrupt, {timed("a", tskip), s.op(Op::sequential, {wait(2), stop})}, {"tock"});
    const TermId both = s.over(Op::parallel, {deadline, timed("c", tskip)}, {"tock"});
    const auto found = traces(s.prioritise(both, {{}, {"tock"}}), 5);
    EXPECT_TRUE(found.contains({"a", "tock", "tock"}));
    // The operand of the deadline has not terminated, because it waits for c, so the deadline still applies.
    EXPECT_FALSE(found.contains({"a", "tock", "tock", "tock"}));
    EXPECT_TRUE(found.contains({"a", "tock", "c", "✓"}));
    EXPECT_TRUE(found.contains({"tock", "tock", "a"}));
    EXPECT_FALSE(found.contains({"tock", "tock", "tock"}));  // the deadline passed: time stops
    EXPECT_FALSE(found.contains({"a", "c", "tock"}));        // both have terminated: tick comes before time
}

TEST_F(Rules, DescribeNamesTheActiveDefinitions) {
    const TermId system =
        s.over(Op::hide, {s.over(Op::parallel, {p1, s.op(Op::sequential, {q1, p1}), p}, {"a"})}, {"a"});
    semantics.successors(p);
    EXPECT_EQ(describe(s.store, system), "P1 ‖ Q1 ‖ a → …");
}

}  // namespace
}  // namespace robochart::process
