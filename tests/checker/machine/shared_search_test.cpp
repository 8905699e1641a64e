// SPDX-License-Identifier: Apache-2.0
// Tests searches of compiled processes by several threads. Each thread has its own copy of the system.
#include <gtest/gtest.h>

#include "checker/machine/compiler.hpp"
#include "checker/refine/verdict/check.hpp"
#include "tests/checker/process/scripted.hpp"

namespace robochart::machine {
namespace {

using process::Op;
using process::Scripted;

class SharedSearch : public testing::Test {
protected:
    std::unique_ptr<SupercombinatorSystem> compiled(TermId term) {
        auto system = compiler.compile(term, diagnostics::unlimited);
        EXPECT_NE(system, nullptr);
        return system;
    }
    static refine::Limits limits_for(unsigned threads, std::size_t wide_level) {
        refine::Limits limits;
        limits.threads = threads;
        limits.wide_level = wide_level;
        return limits;
    }

    Scripted s;
    process::OperationalSemantics semantics{s.store};
    Compiler compiler{semantics};
};

/// Nine cells of four states have 4^9 states with nine transitions each, enough that all threads resize the table.
TEST_F(SharedSearch, CountsAllStatesOfIndependentCells) {
    std::vector<TermId> cells;
    for (char cell = '1'; cell <= '9'; ++cell) {
        const std::string name(1, cell);
        cells.push_back(s.cycle("C" + name, {"a" + name, "b" + name, "c" + name, "d" + name}));
    }
    const auto system = compiled(s.over(Op::parallel, cells, {}));
    for (const unsigned threads : {1U, 2U, 3U}) {
        const refine::Verdict verdict =
            refine::deadlock_free(*system, refine::Model::failures_divergences, limits_for(threads, 2048));
        EXPECT_EQ(verdict.outcome, refine::Outcome::holds);
        EXPECT_EQ(verdict.statistics.states, 262'144U);
        EXPECT_EQ(verdict.statistics.transitions, 9 * 262'144U);
        EXPECT_EQ(verdict.statistics.depth, 27U);
    }
}

/// The system has hidden steps, an inner region with priorities, and a specification that one event violates.
TEST_F(SharedSearch, FindsTheSameViolations) {
    const TermId inside = s.prioritise(
        s.over(Op::parallel, {s.cycle("P", {"a", "b", "x"}), s.cycle("Q", {"c", "b", "y"})}, {"b"}), {{"a"}, {"c"}});
    const TermId with_r = s.over(Op::parallel, {inside, s.cycle("R", {"x", "u", "v"})}, {"x"});
    const TermId with_s = s.over(Op::parallel, {with_r, s.cycle("S", {"y", "w", "z"})}, {"y"});
    const TermId term = s.over(Op::hide, {with_s}, {"b", "u", "w"});
    const auto system = compiled(term);
    for (const std::string missing : {"v", "z", ""}) {
        std::vector<std::pair<std::string, TermId>> menu;
        const TermId most = s.name("SPEC" + missing);
        for (const std::string event : {"a", "c", "v", "x", "y", "z"})
            if (event != missing) menu.emplace_back(event, most);
        s.bind(most, s.menu(menu));
        const auto specification = compiled(s.over(Op::parallel, {most, s.stop()}, {}));
        std::vector<std::string> answers;
        for (const unsigned threads : {1U, 2U, 3U}) {
            const refine::Verdict verdict =
                refine::refines(*specification, *system, refine::Model::traces, limits_for(threads, 1));
            EXPECT_EQ(verdict.outcome, missing.empty() ? refine::Outcome::holds : refine::Outcome::fails);
            std::string answer =
                std::to_string(verdict.statistics.states) + "/" + std::to_string(verdict.statistics.transitions);
            if (verdict.counterexample)
                for (const refine::Step& step : verdict.counterexample->steps)
                    answer += " " + s.events.name(step.event) + " to " + step.state;
            answers.push_back(answer);
        }
        EXPECT_EQ(answers[1], answers[0]);
        EXPECT_EQ(answers[2], answers[0]);
    }
}

}  // namespace
}  // namespace robochart::machine
