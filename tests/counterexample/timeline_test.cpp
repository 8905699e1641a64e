// SPDX-License-Identifier: Apache-2.0
// Tests how runs are decomposed into processes: which component moves, under which name, and in which state each
// component is.
#include "counterexample/timeline.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/reader.hpp"

namespace robochart::runs {
namespace {

using ::testing::ElementsAre;

/// Returns the counterexample to the script's assertion: "NAME of COMPONENT, …" for each step, then the final states of
/// the components.
std::vector<std::string> reported(const std::string& text) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const auto source = sources.add("script.csp", text);
    cspm::Session session(cspm::read(sources, source, diagnostics));
    const auto result = session.check(*session.assertions().front(), {});
    std::vector<std::string> lines;
    if (!diagnostics.ok() || !result.verdict.counterexample) return {"no counterexample"};
    const auto behaviour = session.behaviour(*result.verdict.counterexample);
    if (!behaviour) return {"not taken apart"};
    const refine::Counterexample& found = *result.verdict.counterexample;
    const auto place = [&](const std::optional<process::TermId>& term) {
        return term ? process::describe(session.terms(), *term) : std::string("-");
    };
    for (const Moment& moment : timeline_of(*behaviour, found.steps.size() + found.loop.size()).moments) {
        std::string line = moment.shown ? "" : "inside: ";
        for (const Mover& mover : moment.movers)
            line += session.event_table().name(mover.event) + "/" + std::to_string(mover.leaf) + " ";
        line += "|";
        for (const auto& leaf : moment.leaves) line += " " + place(leaf);
        lines.push_back(line);
    }
    return lines;
}

TEST(Timeline, ARenamedAndPrioritisedEventKeepsTheNameThatItsComponentGivesIt) {
    const auto lines = reported(R"(
        external prioritise
        channel tock, tock', a
        A(0) = a -> STOP
        A(n) = tock -> A(n-1)
        B = tock -> B
        S = prioritise((A(2) [|{tock}|] B)[[tock <- tock, tock <- tock']], <{a, tock'}, {tock}>)
        assert RUN({tock'}) [T= S
    )");
    EXPECT_THAT(lines, ElementsAre("tock/0 tock/1 | A(1) B", "tock/0 tock/1 | A(0) B", "a/0 | STOP B"));
}

TEST(Timeline, AHiddenEventKeepsItsName) {
    EXPECT_THAT(reported("channel a, b\nP = a -> Q\nQ = b -> P\nassert STOP [T= P \\ {a}"),
                ElementsAre("a/0 | Q", "b/0 | P"));
}

TEST(Timeline, WhoTakesOverBeginsAndWhoIsLeftEnds) {
    EXPECT_THAT(reported(R"(
        channel a, b, stop
        P = a -> stop -> P
        Q = b -> Q
        R = stop -> STOP
        S = (P ||| R) [|{stop}|> Q
        assert RUN({a, stop}) [T= S
    )"),
                ElementsAre("stop/1 | - - Q", "b/2 | - - Q"));
}

TEST(Timeline, StepsInsideACompressionAreMomentsOfTheirOwn) {
    const auto lines = reported(R"(
        transparent dbisim
        channel a, b, hid
        P = hid -> P1
        P1 = a -> P2
        P2 = b -> STOP
        assert RUN({a}) [T= dbisim(P \ {hid}) ||| STOP
    )");
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[0], "inside: hid/0 | P1 STOP");
    EXPECT_EQ(lines[1], "a/0 | P2 STOP");
    EXPECT_EQ(lines[2], "b/0 | STOP STOP");
}

}  // namespace
}  // namespace robochart::runs
