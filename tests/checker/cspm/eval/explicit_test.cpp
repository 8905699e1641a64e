// SPDX-License-Identifier: Apache-2.0
// Tests that graphs that are printed as CSPM parse to equal graphs. Random processes over all operators are explored,
// printed, parsed and explored again. Both graphs must refine each other in failures and divergences.
#include <gtest/gtest.h>

#include <sstream>

#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/build.hpp"
#include "checker/lts/graph.hpp"
#include "tests/checker/cspm/support.hpp"
#include "tests/checker/processes/random_cases.hpp"
#include "tests/checker/processes/translate.hpp"

namespace robochart::cspm::test {
namespace {

lts::Graph explored(lts::TransitionSystem& system) {
    return lts::explore(system, [](std::size_t) {}).graph;
}

/// Returns the graph with the event numbers of another table.
lts::Graph renumber_events(const lts::Graph& graph, const process::EventTable& from, process::EventTable& to) {
    lts::Graph result;
    for (lts::StateIndex state = 0; state < graph.size(); ++state) {
        for (const lts::Edge& edge : graph.edges(state))
            result.add_edge({to.intern(from.name(edge.event)), edge.target});
        result.finish_state();
    }
    return result;
}

lts::Graph read_back(const lts::Graph& graph, process::EventTable& events) {
    std::ostringstream text;
    text << "channel a, b, c\n";
    lts::write_csp(graph, events, "Explicit", text);
    const Reading reading(text.str());
    EXPECT_TRUE(reading.ok()) << reading.report() << text.str();
    Session session(reading.script);
    return renumber_events(explored(*session.system(build::name("Explicit"))), session.event_table(), events);
}

TEST(Explicit, RandomProcessesReadBackEqual) {
    refine::RandomCases cases(4711);
    for (int i = 0; i < 150; ++i) {
        const auto [test_case, graphs] = cases.next();
        refine::Translation translation(test_case.script);
        process::TermSystem system = translation.system(test_case.script.mains.front());
        const lts::Graph graph = explored(system);
        process::EventTable& events = translation.scripted().events;
        const lts::Graph again = read_back(graph, events);
        lts::GraphSystem left(graph, events);
        lts::GraphSystem right(again, events);
        const auto fd = refine::Model::failures_divergences;
        EXPECT_EQ(refine::refines(left, right, fd, {}).outcome, refine::Outcome::holds) << show(test_case.script);
        EXPECT_EQ(refine::refines(right, left, fd, {}).outcome, refine::Outcome::holds) << show(test_case.script);
    }
}

TEST(Explicit, FieldsBelowZeroAreInParentheses) {
    const Reading reading("channel c : { -2..0}.Bool\nP = c.(-2).true -> STOP\n");
    ASSERT_TRUE(reading.ok()) << reading.report();
    Session session(reading.script);
    const lts::Graph graph = explored(*session.system(build::name("P")));
    std::ostringstream text;
    lts::write_csp(graph, session.event_table(), "X", text);
    EXPECT_EQ(text.str(), "X = X0\nX0 = c.(-2).true -> X1\nX1 = STOP\n");
}

}  // namespace
}  // namespace robochart::cspm::test
