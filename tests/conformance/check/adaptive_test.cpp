// SPDX-License-Identifier: Apache-2.0
// Tests adaptive tests for models that leave a choice (cpp_emit/runtime/adaptive.hpp). Such tests adapt to the
// behaviour of the implementation. They must fail at a forbidden continuation if the exhaustive check finds a
// difference, and pass if it finds none.
#include "cpp_emit/runtime/adaptive.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <algorithm>

#include <functional>
#include <map>

#include "conformance/code/cycle_log.hpp"
#include "conformance/testgen/test_suite.hpp"
#include "tests/conformance/bench.hpp"
#include "tests/conformance/support.hpp"

namespace robochart::conformance {
namespace {

using cpp_emit::Fault;
using ::testing::HasSubstr;
using Verdict = AdaptiveVerdict::Kind;

/// Wraps generated code in the textual API of an implementation.
class Generated {
public:
    Generated(const rc_interface& code, const ChoiceAutomaton& machine, const AllowedCycles& graph,
              const CyclicModel& model)
        : code_(code), machine_(machine), graph_(graph), model_(model), image_(code.state_size) {
        for (std::size_t s = 0; s < machine.state_count(); ++s)
            for (std::size_t i = 0; i < machine.inputs.size(); ++i)
                for (std::size_t b = 0; b < machine.branches[s][i].size(); ++b)
                    for (std::size_t w = 0; w < machine.branches[s][i][b].writes.size(); ++w)
                        words_[machine.branches[s][i][b].writes[w]] = graph.states[s][i][b].writes[w];
    }

    void reset() { code_.initial(image_.data()); }
    std::vector<std::string> cycle(const std::vector<std::string>& inputs) {
        const auto symbol = std::ranges::find(graph_.inputs, inputs) - graph_.inputs.begin();
        std::vector<rc_register> registers;
        for (const std::uint32_t r : machine_.inputs[static_cast<std::size_t>(symbol)])
            registers.push_back({r == 0 ? 0U : 1U, r == 0 ? 0U : r - 1});
        CycleLog log;
        const rc_result result = code_.step(image_.data(), registers.data(), &log);
        std::vector<std::string> done;
        for (std::uint32_t r = 0; r < log.count; ++r) {
            const rc_record& record = log.record[r];
            const auto event =
                model_.alphabet().write_event(record.output, {record.argument, record.argument + record.count});
            const auto known = words_.find(event);
            done.push_back(known == words_.end() ? "unknown!" + std::to_string(event) : known->second);
        }
        if (result == RC_TERMINATED) done.emplace_back("terminate");
        if (result != RC_TERMINATED && result != RC_QUIESCENT) done.emplace_back("stopped");
        return done;
    }

private:
    const rc_interface& code_;
    const ChoiceAutomaton& machine_;
    const AllowedCycles& graph_;
    const CyclicModel& model_;
    std::vector<unsigned char> image_;
    std::map<process::Event, std::string> words_;
};

/// Checks every mutant at every place. The adaptive tests must fail if and only if the exhaustive check finds a
/// difference.
void check_mutants(const std::string& folder, const std::vector<Fault>& faults, bool choices) {
    test::Model project(folder);
    const ir::ComponentRef component =
        project.system.modules.empty() ? project.machine_named("M") : project.first_module();
    std::string error;
    const auto model = CyclicModel::load(project.system, project.instantiation, component, 1, {}, project.sources,
                                         project.diagnostics, error);
    ASSERT_NE(model, nullptr) << error;
    const ChoiceAutomaton machine = choice_automaton(*model, {});
    EXPECT_EQ(machine.is_deterministic(), !choices);
    AllowedCycles graph;
    std::istringstream text(choice_graph(machine, *model, "M", 1));
    ASSERT_TRUE(graph.read(text));
    ASSERT_EQ(graph.states.size(), machine.state_count());
    test::Bench bench(project, component);
    std::size_t killed = 0;
    std::size_t all = 0;
    for (const Fault fault : faults)
        for (std::uint32_t site = 0; site < (fault == Fault::none ? 1 : bench.site_count(fault)); ++site) {
            cpp_emit::Options options;
            options.fault = fault;
            options.fault_site = site;
            const auto emission =
                cpp_emit::emit(project.system, project.instantiation, component, options, project.diagnostics);
            const auto object = test::compile_quietly(emission, error);
            ASSERT_NE(object, nullptr) << error;
            Generated implementation(object->interface(), machine, graph, *model);
            const AdaptiveVerdict verdict = AdaptiveTest<Generated>(graph, implementation, 2'000'000).run();
            const bool differs = bench.check_code(object->interface()).outcome == Outcome::differs;
            EXPECT_EQ(verdict.kind, differs ? Verdict::failed : Verdict::passed)
                << static_cast<int>(fault) << " at " << site << ": " << verdict.reason;
            ++all;
            killed += differs ? 1 : 0;
        }
    fmt::print("{}: {} states, {} of {} killed\n", folder, machine.state_count(), killed, all);
    EXPECT_GT(killed, 0U);
}

TEST(AdaptiveTests, KillTheMutantsOfAChoice) {
    check_mutants("tests/conformance/models/either", {Fault::none, Fault::wrong_target, Fault::entry_dropped}, true);
}

TEST(AdaptiveTests, KillTheMutantsOfNested) {
    check_mutants("tests/conformance/models/nested",
                  {Fault::none, Fault::children_not_exited, Fault::exit_dropped, Fault::action_dropped}, true);
}

TEST(AdaptiveTests, KillTheMutantsOfAggregation) {
    check_mutants("corpus/aggregation", {Fault::none, Fault::assignment_dropped}, false);
}

// ------------------------------------------------------------ verdicts, by hand

/// Returns a model with one state and no inputs. Every cycle outputs a or b.
AllowedCycles a_or_b(std::size_t extra) {
    AllowedCycles graph;
    std::istringstream text(
        fmt::format("robochart-graph 1\ncomponent M\nextra {}\ninput 0\nstate 0\n0 0 a!\n0 0 b!0.5\n", extra));
    EXPECT_TRUE(graph.read(text));
    return graph;
}

struct ByHand {
    std::function<std::string(int cycle, int run)> what;
    int at = 0;
    int run = 0;
    void reset() { at = 0, ++run; }
    std::vector<std::string> cycle(const std::vector<std::string>&) { return {what(++at, run)}; }
};

AdaptiveVerdict adaptive_verdict(const AllowedCycles& graph, std::function<std::string(int, int)> what,
                                 std::size_t most = 10'000) {
    ByHand implementation{std::move(what)};
    return AdaptiveTest<ByHand>(graph, implementation, most).run();
}

TEST(AdaptiveTests, WhateverTheModelAllowsPasses) {
    const auto turns = adaptive_verdict(a_or_b(0), [](int cycle, int) { return cycle % 2 == 0 ? "a!" : "b!0.50"; });
    EXPECT_EQ(turns.kind, Verdict::passed) << turns.reason;
    EXPECT_EQ(turns.states, 2U);
}

/// The bound is exact. The implementation has five states but appears to have one, so the tests need four extra states
/// to find the fault.
TEST(AdaptiveTests, AFaultFarAwayNeedsMoreStates) {
    const auto fifth = [](int cycle, int) { return cycle == 5 ? "c!" : "a!"; };
    const auto few = adaptive_verdict(a_or_b(0), fifth);
    EXPECT_EQ(few.kind, Verdict::passed);
    EXPECT_EQ(few.states, 1U);
    const auto more = adaptive_verdict(a_or_b(4), fifth);
    EXPECT_EQ(more.kind, Verdict::failed);
    EXPECT_THAT(more.reason, HasSubstr("cycle 5: nothing\nit did c!; the model allows one of\n    a!\n    b!0.5"));
}

TEST(AdaptiveTests, WhatCannotBeDecidedIsInconclusive) {
    const auto moody =
        adaptive_verdict(a_or_b(2), [](int cycle, int run) { return cycle == 2 && run > 2 ? "b!0.5" : "a!"; });
    EXPECT_EQ(moody.kind, Verdict::inconclusive);
    EXPECT_THAT(moody.reason, HasSubstr("not deterministic"));
    // An implementation that counts has infinitely many states.
    const auto counter = [](int cycle, int) {
        for (int next = 1, step = 1; next <= cycle; next += ++step)
            if (next == cycle) return "b!0.5";
        return "a!";
    };
    const auto endless = adaptive_verdict(a_or_b(3), counter, 2'000);
    EXPECT_EQ(endless.kind, Verdict::inconclusive);
    EXPECT_THAT(endless.reason, HasSubstr("more than 2000 cycles"));
}

/// The model may terminate or continue, and so may an implementation.
TEST(AdaptiveTests, TerminationIsAChoiceToo) {
    AllowedCycles graph;
    std::istringstream text("robochart-graph 1\nextra 1\ninput 0\ninput 1 stop?\nstate 0\n0 0\n1 0\n1 over off!\n");
    ASSERT_TRUE(graph.read(text));
    struct Ends {
        bool ends;
        bool on_nothing = false;
        void reset() {}
        std::vector<std::string> cycle(const std::vector<std::string>& inputs) const {
            if (inputs.empty() == on_nothing && ends) return {"off!", "terminate"};
            return {};
        }
    };
    for (const bool ends : {false, true}) {
        Ends implementation{ends};
        const auto verdict = AdaptiveTest<Ends>(graph, implementation, 1000).run();
        EXPECT_EQ(verdict.kind, Verdict::passed) << verdict.reason;
        EXPECT_EQ(verdict.states, ends ? 2U : 1U);
    }
    Ends wrong{true, true};
    EXPECT_EQ(AdaptiveTest<Ends>(graph, wrong, 1000).run().kind, Verdict::failed);
}

TEST(AdaptiveTests, WhatIsNoGraphIsNotRead) {
    for (const char* text :
         {"", "robochart-graph 1\n", "state 0\n0 0\n", "input 0\nstate 0\n1 0\n", "input 0\nstate 0\n0 x\n"}) {
        AllowedCycles graph;
        std::istringstream in(text);
        EXPECT_FALSE(graph.read(in)) << text;
    }
}

}  // namespace
}  // namespace robochart::conformance
