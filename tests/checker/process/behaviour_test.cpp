// SPDX-License-Identifier: Apache-2.0
// Tests how runs are decomposed into the traces and offers of their components. The expected results were computed by
// hand.
#include "checker/process/behaviour.hpp"

#include <gtest/gtest.h>

#include "tests/checker/process/scripted.hpp"

namespace robochart::process {
namespace {

class Apart : public testing::Test {
protected:
    Scripted s;
    OperationalSemantics semantics{s.store};

    /// Returns the run with these actions. Takes the first matching transition in each step.
    Behaviour run(TermId initial, const std::vector<Event>& actions) {
        std::vector<Transition> steps;
        TermId now = initial;
        for (const Event action : actions) {
            for (const Transition& transition : semantics.successors(now))
                if (transition.event == action) {
                    steps.push_back(transition);
                    break;
                }
            now = steps.back().target;
        }
        EXPECT_EQ(steps.size(), actions.size());
        return behaviour(semantics, initial, steps);
    }
    std::string trace(const Behaviour& part) {
        std::string text;
        for (const Event event : part.trace) text += event == no_event ? "-" : s.events.name(event);
        return text;
    }
    std::string offer(const Behaviour& part) {
        std::string text;
        for (const Event event : part.offered) text += s.events.name(event);
        return text;
    }
};

// (a -> b -> STOP) [| {b} |] (c -> b -> d -> STOP): both operands perform b. The events a and c belong to one operand
// each.
TEST_F(Apart, ParallelOperandsHaveTheirOwnTraces) {
    const TermId left = s.prefix("a", s.prefix("b", s.stop()));
    const TermId right = s.prefix("c", s.prefix("b", s.prefix("d", s.stop())));
    const Behaviour whole = run(s.over(Op::parallel, {left, right}, {"b"}), {s.event("c"), s.event("a"), s.event("b")});
    ASSERT_EQ(whole.parts.size(), 2U);
    EXPECT_EQ(whole.op, "[|{b}|]");
    EXPECT_EQ(trace(whole), "cab");
    EXPECT_EQ(trace(whole.parts[0]), "-ab");
    EXPECT_EQ(offer(whole.parts[0]), "");
    EXPECT_EQ(trace(whole.parts[1]), "c-b");
    EXPECT_EQ(offer(whole.parts[1]), "d");
}

// ((a -> b -> STOP) ||| c -> STOP) [[b <- d]] \ {a}: below hiding and renaming, events have their original names.
TEST_F(Apart, HidingAndRenamingAreUndoneInside) {
    const TermId left = s.prefix("a", s.prefix("b", s.stop()));
    const TermId both = s.over(Op::parallel, {left, s.prefix("c", s.stop())}, {});
    const TermId whole = s.over(Op::hide, {s.rename(both, {{"b", "d"}})}, {"a"});
    const Behaviour hidden = run(whole, {tau, s.event("d")});
    EXPECT_EQ(trace(hidden), "τd");
    EXPECT_EQ(s.events.name(hidden.revealed[0]), "a");
    const Behaviour& renamed = hidden.parts.at(0);
    EXPECT_EQ(trace(renamed), "ad");
    const Behaviour& inside = renamed.parts.at(0);
    EXPECT_EQ(inside.op, "|||");
    EXPECT_EQ(trace(inside.parts.at(0)), "ab");
    EXPECT_EQ(trace(inside.parts.at(1)), "--");
    EXPECT_EQ(offer(inside.parts.at(1)), "c");
}

// (a -> SKIP ||| SKIP) ; b -> STOP: the first part terminates with ✓, which is a tau of the whole. Then the second part
// starts.
TEST_F(Apart, ASequenceHasPartsOneAfterTheOther) {
    const TermId first = s.over(Op::parallel, {s.prefix("a", s.skip()), s.skip()}, {});
    const Behaviour whole =
        run(s.op(Op::sequential, {first, s.prefix("b", s.stop())}), {s.event("a"), tau, s.event("b")});
    EXPECT_EQ(whole.op, "then");
    ASSERT_EQ(whole.parts.size(), 2U);
    EXPECT_EQ(trace(whole.parts[0].parts.at(0)), "a✓-");
    EXPECT_TRUE(whole.parts[0].left);
    EXPECT_TRUE(whole.parts[0].parts.at(0).left);
    EXPECT_EQ(trace(whole.parts[0].parts.at(0).parts.at(1)), "-✓-");
    EXPECT_EQ(trace(whole.parts[1]), "--b");
    EXPECT_TRUE(whole.parts[1].parts.empty());
}

// P = a -> (Q ||| R) is one component before a, and two after it.
TEST_F(Apart, AComponentMayBecomeSeveral) {
    const TermId later = s.over(Op::parallel, {s.prefix("b", s.stop()), s.prefix("c", s.stop())}, {});
    const Behaviour whole = run(s.prefix("a", later), {s.event("a"), s.event("c")});
    ASSERT_EQ(whole.parts.size(), 2U);
    EXPECT_EQ(trace(whole.parts[0]), "a-");
    EXPECT_EQ(trace(whole.parts[1].parts.at(1)), "-c");
    EXPECT_EQ(offer(whole.parts[1].parts.at(0)), "b");
}

// (a -> SKIP) ; P, repeated forever, is one sequential component: its trace is not split at each repetition.
TEST_F(Apart, SequentialProcessesStayWhole) {
    const TermId p = s.name("P");
    s.bind(p, s.op(Op::sequential, {s.prefix("a", s.skip()), p}));
    const Behaviour whole = run(p, {s.event("a"), tau, s.event("a"), tau});
    EXPECT_TRUE(whole.parts.empty());
    EXPECT_EQ(whole.name, "P");
    EXPECT_EQ(offer(whole), "a");
}

/// Compressed machines identify the states of their operand only by number, as a fast engine does.
class NumberingCompressor final : public Compressor {
public:
    std::optional<Machine> explore(TermId operand, Compression, diagnostics::Pollable&) override {
        return Machine{{{{2, 1}}, {{3, 0}}}, {operand, operand}};
    }
    Machine compress(const Machine& explored, Compression, diagnostics::Pollable&) override { return explored; }
};

TEST_F(Apart, CompressedPartsAreNamedWithTheirState) {
    const TermId p = s.name("P");
    ASSERT_EQ(s.event("a"), 2U);
    ASSERT_EQ(s.event("b"), 3U);
    s.bind(p, s.prefix("a", s.prefix("b", p)));
    NumberingCompressor compressor;
    OperationalSemantics compressing{s.store, &compressor};
    const TermId small = s.op(Op::compress, {p}, static_cast<std::uint32_t>(Compression::dbisim));
    const TermId whole = s.over(Op::parallel, {small, s.stop()}, {});
    const Transition first = compressing.successors(whole).front();
    const Behaviour apart = behaviour(compressing, whole, {first});
    EXPECT_EQ(apart.parts.at(0).name, "dbisim(P)");
    EXPECT_EQ(apart.parts.at(0).state, "dbisim(P) state 1");
    EXPECT_EQ(apart.parts.at(0).op, "dbisim");
    EXPECT_EQ(apart.parts.at(0).parts.at(0).name, "P");
}

// dbisim((h -> a -> b -> STOP ||| c -> STOP) \ {h}): the machine performs a. Its operand performed h before a.
TEST_F(Apart, InsideACompressionTheOperandHasARunOfItsOwn) {
    const TermId left = s.prefix("h", s.prefix("a", s.prefix("b", s.stop())));
    const TermId inside = s.over(Op::hide, {s.over(Op::parallel, {left, s.prefix("c", s.stop())}, {})}, {"h"});
    const Behaviour whole = [&] {
        class WithoutFirstTau final : public Compressor {
        public:
            Machine compress(const Machine& explored, Compression, diagnostics::Pollable&) override {
                Machine result = explored;  // the first state's tau is inert: the next state replaces it
                result.edges[0] = explored.edges[explored.edges[0].front().target];
                return result;
            }
        } compressor;
        OperationalSemantics compressing{s.store, &compressor};
        const TermId small = s.op(Op::compress, {inside}, static_cast<std::uint32_t>(Compression::dbisim));
        for (const Transition& transition : compressing.successors(small))
            if (transition.event == s.event("a")) return behaviour(compressing, small, {transition});
        return Behaviour{};
    }();
    EXPECT_EQ(trace(whole), "a");
    const Behaviour& hidden = whole.parts.at(0);
    EXPECT_EQ(trace(hidden), "τa");
    const Behaviour& parallel = hidden.parts.at(0);
    EXPECT_EQ(trace(parallel.parts.at(0)), "ha");
    EXPECT_EQ(offer(parallel.parts.at(0)), "b");
    EXPECT_EQ(trace(parallel.parts.at(1)), "--");
}

}  // namespace
}  // namespace robochart::process
