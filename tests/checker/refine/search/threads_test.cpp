// SPDX-License-Identifier: Apache-2.0
// Tests that verdicts, counterexamples and figures are the same for any number of threads. Here every level counts as
// wide, so all threads take part in small systems too.
#include <gtest/gtest.h>

#include <random>

#include "checker/lts/graph.hpp"
#include "checker/refine/verdict/check.hpp"

namespace robochart::refine {
namespace {

using lts::Edge;
using lts::Graph;
using process::Event;

constexpr Event events = 5;  // in addition to tau and tick

/// Returns a graph that is mostly wide and shallow. Of a thousand states, `stuck` have no transitions.
Graph random_graph(std::mt19937& random, std::size_t states, unsigned taus, unsigned stuck) {
    Graph graph;
    for (std::size_t state = 0; state < states; ++state) {
        const std::size_t edges = state != 0 && random() % 1000 < stuck ? 0 : 2 + random() % 6;
        for (std::size_t i = 0; i < edges; ++i) {
            const bool by_tau = random() % 100 < taus;
            // Most taus lead forward, so that tau cycles are rare and long.
            const std::size_t ahead = state + 1 < states && random() % 500 != 0
                                          ? state + 1 + random() % (states - state - 1)
                                          : random() % states;
            graph.add_edge({by_tau ? process::tau : static_cast<Event>(process::first_visible + random() % events),
                            static_cast<lts::StateIndex>(by_tau ? ahead : random() % states)});
        }
        graph.finish_state();
    }
    return graph;
}

std::string report_text(const Verdict& verdict) {
    std::string text = std::to_string(static_cast<int>(verdict.outcome)) + " states " +
                       std::to_string(verdict.statistics.states) + " transitions " +
                       std::to_string(verdict.statistics.transitions) + " depth " +
                       std::to_string(verdict.statistics.depth);
    if (!verdict.counterexample) return text;
    const auto add = [&text](const std::vector<Step>& steps) {
        for (const Step& step : steps) text += ", " + std::to_string(step.event) + " to " + step.state;
    };
    text += " kind " + std::to_string(static_cast<int>(verdict.counterexample->kind));
    add(verdict.counterexample->steps);
    text += " loop";
    add(verdict.counterexample->loop);
    return text;
}

class Threads : public testing::Test {
protected:
    void compare(const Graph& specification, const Graph& implementation) {
        lts::GraphSystem first(specification, table);
        lts::GraphSystem second(implementation, table);
        std::vector<std::string> expected;
        for (const unsigned threads : {1U, 2U, 4U}) {
            Limits limits;
            limits.threads = threads;
            limits.wide_level = 1;
            std::vector<std::string> answers;
            for (const Model model : {Model::traces, Model::failures, Model::failures_divergences})
                answers.push_back(report_text(refines(first, second, model, limits)));
            answers.push_back(report_text(deadlock_free(second, Model::failures, limits)));
            answers.push_back(report_text(divergence_free(second, limits)));
            answers.push_back(report_text(deterministic(second, Model::failures_divergences, limits)));
            if (expected.empty()) expected = answers;
            ASSERT_EQ(answers, expected) << threads << " threads";
        }
        for (const std::string& answer : expected) ++(answer.front() == '0' ? holds : fails);
    }
    process::EventTable table;
    int holds = 0;
    int fails = 0;
};

TEST_F(Threads, ChangeNothing) {
    std::mt19937 random(5);
    for (int round = 0; round < 12; ++round) {
        const std::size_t size = 20 + random() % 4000;
        Graph specification;  // allows everything but, in some states, one event
        const Event allowed = events - (round % 3 == 0 ? 1 : 0);
        for (Event event = 0; event < allowed; ++event) specification.add_edge({process::first_visible + event, 0});
        specification.finish_state();
        compare(specification, random_graph(random, size, round % 2 == 0 ? 0 : 30, round % 4 == 0 ? 0 : 2));
    }
    EXPECT_GT(holds, 20);
    EXPECT_GT(fails, 20);
}

}  // namespace
}  // namespace robochart::refine
