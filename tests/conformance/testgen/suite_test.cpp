// SPDX-License-Identifier: Apache-2.0
// Tests complete test suites. A suite kills every faulty controller of its fault domain, passes the correct one, and
// consists of runs of the model.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "conformance/code/cycle_log.hpp"
#include "conformance/testgen/test_suite.hpp"
#include "conformance/traces/trace_check.hpp"
#include "tests/conformance/bench.hpp"
#include "tests/conformance/support.hpp"
#include "tests/temporary_folder.hpp"

namespace robochart::conformance {
namespace {

using cpp_emit::Fault;
using ::testing::HasSubstr;

/// A deterministic model: in no state are two transitions enabled at the same time.
constexpr const char* pump = R"(
interface Ops { go(level : nat) halt() }
interface Events { event level : nat event stop }
stm M {
	requires Ops
	uses Events
	clock T
	var n : nat = 0
	initial i
	state Off { entry halt(); wait(1) }
	state Slow { entry go(n); wait(1) }
	state Fast { entry go(2); wait(1) }
	transition t0 { from i to Off }
	transition t1 { from Off to Slow trigger level?n #T condition n > 0 }
	transition t2 { from Slow to Off trigger stop condition since(T) < 3 }
	transition t3 { from Slow to Fast condition since(T) >= 3 }
	transition t4 { from Fast to Off trigger stop }
}
)";

/// Inputs and outputs are composite values. One operation has two composite arguments.
constexpr const char* store = R"(
enumeration Job { Fetch(boolean) Drop }
datatype Pose { x : real near : boolean }
interface Ops { put(job : Job, poses : Seq(Pose)) }
interface Events { event job : Job }
stm M {
	requires Ops
	uses Events
	var j : Job
	initial i
	state A { }
	transition t0 { from i to A }
	transition t1 { from A to A trigger job?j action put(j, <Pose (| x = 0.5, near = j == Job::Drop |)>) }
}
)";

class Suites {
public:
    explicit Suites(const std::string& folder)
        : project(folder),
          component(project.system.modules.empty() ? project.machine_named("M") : project.first_module()) {
        std::string error;
        model = CyclicModel::load(project.system, project.instantiation, component, 1, limits, project.sources,
                                  project.diagnostics, error);
        EXPECT_NE(model, nullptr) << error;
        machine = cycle_automaton(*model, limits);
    }

    /// Returns whether the compiled code makes the outputs of the model in every run of the suite.
    bool passes_suite(const rc_interface& code, const std::vector<TestWord>& suite) const {
        for (const TestWord& test : suite) {
            std::vector<unsigned char> image(code.state_size);
            code.initial(image.data());
            std::uint32_t state = 0;
            for (const std::uint32_t symbol : test) {
                std::vector<rc_register> registers;
                for (const std::uint32_t r : machine.inputs[symbol])
                    registers.push_back({r == 0 ? 0U : 1U, r == 0 ? 0U : r - 1});
                CycleLog log;
                const rc_result result = code.step(image.data(), registers.data(), &log);
                const CycleStep& step = machine.steps[state][symbol];
                const rc_result expected = step.target == CycleAutomaton::over ? RC_TERMINATED : RC_QUIESCENT;
                if (result != expected || log.overflow != 0 || logged_writes(log) != step.writes) return false;
                state = step.target;
            }
        }
        return true;
    }

    std::unique_ptr<SharedObject> compile_fault(Fault fault, std::uint32_t site) {
        cpp_emit::Options options;
        options.fault = fault;
        options.fault_site = site;
        const auto emission =
            cpp_emit::emit(project.system, project.instantiation, component, options, project.diagnostics);
        std::string error;
        auto object = test::compile_quietly(emission, error);
        EXPECT_NE(object, nullptr) << error;
        return object;
    }

    test::Model project;
    ir::ComponentRef component;
    refine::Limits limits;
    std::unique_ptr<CyclicModel> model;
    CycleAutomaton machine;

private:
    std::vector<process::Event> logged_writes(const rc_log& log) const {
        std::vector<process::Event> events;
        for (std::uint32_t r = 0; r < log.count; ++r)
            events.push_back(model->alphabet().write_event(
                log.record[r].output, {log.record[r].argument, log.record[r].argument + log.record[r].count}));
        return events;
    }
};

/// The numbers are counted by hand. Initially there was no output. Then the robot drives or turns. The robot drives in
/// the same way after the first cycle as after later ones, so only the initial state is additional. Two signals have
/// four valuations.
TEST(TestSuites, TheMachineOfAggregationIsSmall) {
    const Suites suites("corpus/aggregation");
    EXPECT_EQ(suites.machine.inputs.size(), 4U);
    EXPECT_GE(suites.machine.state_count(), 3U);
    EXPECT_LE(suites.machine.state_count(), 8U);
    const auto none = complete_suite(suites.machine, 0);
    const auto one = complete_suite(suites.machine, 1);
    EXPECT_LT(none.size(), one.size());
    EXPECT_THROW((void)complete_suite(suites.machine, 1, 10), std::length_error);
}

/// The suite is written as a log, in which every run must be a run of the model.
TEST(TestSuites, AreRunsOfTheModel) {
    const test::ModelFolder pumps(pump);
    const test::ModelFolder stores(store);
    for (const std::string& folder : {std::string("corpus/aggregation"), pumps.path(), stores.path()}) {
        const Suites suites(folder);
        const auto tests = complete_suite(suites.machine, 0);
        const std::string log = suite_log(suites.machine, tests, *suites.model, "M", 0);
        TraceChecker checker(*suites.model, {"M"}, suites.limits, suites.project.sources);
        std::istringstream in(log);
        std::string reported;
        const LogReport report = checker.check_log(in, {}, [&](const RunReport& run) { reported += run.what + "\n"; });
        EXPECT_FALSE(report.fault.has_value()) << report.fault->text;
        EXPECT_EQ(report.accepted, tests.size()) << reported;
        if (folder == stores.path()) {
            EXPECT_THAT(log, HasSubstr("\njob?Fetch(true) put!Fetch(true)!<(0.5,false)> tock\n"));
        }
    }
}

/// Kills every mutant that the exhaustive check distinguishes from the model and that has at most as many states as the
/// fault domain allows. The correct code and equivalent mutants pass.
void check_mutants(const std::string& folder, const std::vector<Fault>& faults) {
    Suites suites(folder);
    test::Bench bench(suites.project, suites.component);
    const std::uint32_t extra = 1;
    const auto suite = complete_suite(suites.machine, extra);
    EXPECT_TRUE(suites.passes_suite(suites.compile_fault(Fault::none, 0)->interface(), suite));
    std::size_t different = 0;
    std::size_t killed = 0;
    for (const Fault fault : faults)
        for (std::uint32_t site = 0; site < bench.site_count(fault); ++site) {
            const auto object = suites.compile_fault(fault, site);
            const Result oracle = bench.check_code(object->interface());
            const bool passed = suites.passes_suite(object->interface(), suite);
            if (oracle.outcome == Outcome::conforms) {
                EXPECT_TRUE(passed) << static_cast<int>(fault) << " at " << site;
                continue;
            }
            ASSERT_EQ(oracle.outcome, Outcome::differs);
            ++different;
            killed += passed ? 0 : 1;
            if (oracle.code_states <= suites.machine.state_count() + extra) {
                EXPECT_FALSE(passed) << static_cast<int>(fault) << " at " << site;
            }
        }
    fmt::print("{}: {} tests, {} of {} mutants killed\n", folder, suite.size(), killed, different);
    EXPECT_EQ(killed, different) << "larger mutants too, here";
}

TEST(TestSuites, KillTheMutantsOfAggregation) {
    check_mutants("corpus/aggregation",
                  {Fault::wrong_target, Fault::entry_dropped, Fault::argument_swapped, Fault::assignment_dropped,
                   Fault::event_kept, Fault::wait_dropped, Fault::single_transition_step});
}

TEST(TestSuites, KillTheMutantsOfAPump) {
    check_mutants(test::ModelFolder(pump).path(),
                  {Fault::guard_negated, Fault::guard_dropped, Fault::wrong_target, Fault::entry_dropped,
                   Fault::clock_not_reset, Fault::clock_off_by_one, Fault::wait_dropped, Fault::event_kept});
}

/// If two outputs may come in either order, the machine of cycles is not deterministic.
TEST(TestSuites, ModelsThatLeaveAChoiceAreRefused) {
    try {
        const Suites suites("tests/conformance/models/nested");
        FAIL() << "it has " << suites.machine.state_count() << " states";
    } catch (const std::length_error& refused) {
        EXPECT_THAT(refused.what(), HasSubstr("leaves a choice"));
    }
}

/// The generated GoogleTest is run with a correct and a faulty hand-written implementation.
TEST(TestSuites, TheSourcesReplayTheSuite) {
    const Suites suites("corpus/aggregation");
    auto files = suite_sources("Aggregation");
    const auto tests = complete_suite(suites.machine, 0);
    files.push_back({"Aggregation.trace", suite_log(suites.machine, tests, *suites.model, "Aggregation", 0)});
    files.push_back({"mine.cpp", R"(#include "implementation.hpp"
#include <algorithm>
class Mine : public Implementation {
public:
    void reset() override { state = 'i'; }
    std::vector<std::string> cycle(const std::vector<std::string>& inputs) override {
        const auto has = [&](const char* e) { return std::find(inputs.begin(), inputs.end(), e) != inputs.end(); };
        if (state == 'i' || (state == '2' && has("seeWall?"))) {
            state = '1';
            return {"angularSpeed!-0.750", "linearSpeed!-10.88"};
        }
        if (state == '1' && has("seeRobot?")) {
            state = '2';
            return {"angularSpeed!-5.02", FAULT};
        }
        return {};
    }
    char state = 'i';
};
std::unique_ptr<Implementation> make_implementation() { return std::make_unique<Mine>(); }

#include <gtest/gtest.h>
int main(int argc, char** argv) {
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
)"});
    const tests::TemporaryFolder folder;
    for (const auto& file : files) folder.write(file.path, file.text);
    for (const auto& [fault, exit] :
         {std::pair<const char*, int>{"\\\"linearSpeed!0\\\"", 0}, {"\\\"linearSpeed!1\\\"", 1}}) {
        const std::string build = fmt::format(
            "cd {} && c++ -std=c++17 -Wall -Wextra -Werror \"-DFAULT={}\" mine.cpp Aggregation_suite_test.cpp -o mine "
            "-lgtest -lpthread 2>build.log",
            folder.path(), fault);
        ASSERT_EQ(std::system(build.c_str()), 0) << build;
        const int status = std::system(fmt::format("cd {} && ./mine >/dev/null", folder.path()).c_str());
        EXPECT_EQ(WEXITSTATUS(status), exit) << fault;
    }
}

}  // namespace
}  // namespace robochart::conformance
