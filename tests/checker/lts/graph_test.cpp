// SPDX-License-Identifier: Apache-2.0
// Tests the exploration of systems and the export of their graphs.
#include "checker/lts/graph.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "checker/process/term_system.hpp"
#include "tests/checker/process/scripted.hpp"

namespace robochart::lts {
namespace {

using process::Op;
using process::Scripted;
using process::TermId;
using process::TermSystem;

class Graphs : public testing::Test {
protected:
    Scripted s;
    process::OperationalSemantics semantics{s.store};

    Graph graph_of(TermId term) {
        TermSystem system(semantics, term);
        return explore(system, [](std::size_t) {}).graph;
    }
    /// Returns (a -> SKIP) |~| (say"hi" -> STOP).
    TermId example() { return s.op(Op::internal_choice, {s.prefix("a", s.skip()), s.prefix("say\"hi\"", s.stop())}); }
};

TEST_F(Graphs, ExploreBreadthFirst) {
    const Graph graph = graph_of(example());
    // State 0 is the choice, 1 and 2 are its operands, 3 is SKIP, 4 is STOP, and 5 is the state after tick.
    EXPECT_EQ(graph.size(), 6U);
    EXPECT_EQ(graph.edge_count(), 5U);
    ASSERT_EQ(graph.edges(0).size(), 2U);
    EXPECT_EQ(graph.edges(0)[0], (Edge{process::tau, 1}));
    EXPECT_EQ(graph.edges(3)[0], (Edge{process::tick, 5}));
    EXPECT_TRUE(graph.edges(4).empty());
}

TEST_F(Graphs, ExplorationStopsWhenItsCallbackThrows) {
    TermSystem system(semantics, example());
    const auto stop_at_three = [](std::size_t states) {
        if (states > 2) throw std::runtime_error("enough");
    };
    EXPECT_THROW((void)explore(system, stop_at_three), std::runtime_error);
}

TEST_F(Graphs, WriteAldebaran) {
    std::ostringstream out;
    write_aut(graph_of(example()), s.events, out);
    EXPECT_EQ(out.str(),
              "des (0,5,6)\n"
              "(0,\"tau\",1)\n"
              "(0,\"tau\",2)\n"
              "(1,\"a\",3)\n"
              "(2,\"say\\\"hi\\\"\",4)\n"
              "(3,\"tick\",5)\n");
}

/// The format's readers would treat some names of visible events as hidden steps, so the export changes these names.
TEST_F(Graphs, EventsNamedLikeHiddenStepsAreWrittenApart) {
    std::ostringstream out;
    write_aut(graph_of(s.prefix("tau", s.prefix("tau_", s.prefix("i", s.prefix("tick", s.stop()))))), s.events, out);
    EXPECT_EQ(out.str(),
              "des (0,4,5)\n"
              "(0,\"tau__\",1)\n"
              "(1,\"tau_\",2)\n"
              "(2,\"i_\",3)\n"
              "(3,\"tick_\",4)\n");
}

TEST_F(Graphs, WriteGraphviz) {
    std::ostringstream out;
    write_dot(graph_of(s.prefix("a", s.stop())), s.events, out);
    EXPECT_EQ(out.str(),
              "digraph lts {\n  node [shape=circle];\n  start [shape=point];\n  start -> 0;\n"
              "  0;\n  0 -> 1 [label=\"a\"];\n  1;\n}\n");
}

}  // namespace
}  // namespace robochart::lts
