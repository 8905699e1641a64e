// SPDX-License-Identifier: Apache-2.0
// Tests that a limit may turn an answer into "inconclusive", but never into another answer. The tests vary the numbers
// of walks and threads and the amount of memory.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "conformance/check/conform.hpp"
#include "tests/conformance/bench.hpp"

namespace robochart::conformance {
namespace {

struct Subject {
    std::string folder;
    std::string machine;  ///< "" for the module, or the controller if there is no module
};

std::vector<Subject> test_subjects() {
    const std::string models = "tests/conformance/models/";
    std::vector<Subject> all{{"corpus/aggregation", ""}, {"corpus/aggregation", "AggregationFSM"}};
    for (const char* module : {"nested", "parcels", "team", "helpers", "wires"}) all.push_back({models + module, ""});
    for (const auto& [folder, machine] :
         {std::pair("tower", "Tower"), std::pair("timing", "Timing"), std::pair("words", "Words"),
          std::pair("outside", "Outside"), std::pair("blink", "Blink"), std::pair("missed", "Missed"),
          std::pair("reacts", "Reacts"), std::pair("due", "Due")})
        all.push_back({models + folder, machine});
    return all;
}

/// Judges the same compiled code repeatedly.
class Limited {
public:
    Limited(test::Model& model, const ir::ComponentRef& component, cpp_emit::Fault fault = cpp_emit::Fault::none,
            std::uint32_t site = 0)
        : model_(model), component_(component), bench_(model, component), code_(bench_.compile_fault(fault, site)) {
        EXPECT_TRUE(code_);
    }

    [[nodiscard]] Result judge(const Options& options) {
        return judge_code(bench_.script(), model_.system, model_.instantiation, component_, code_->interface(),
                          options);
    }

    void expect_the_same_or_nothing(const std::string& name) {
        const Result whole = judge({});
        ASSERT_NE(whole.outcome, Outcome::inconclusive) << name << ": " << whole.reason;
        for (const std::uint64_t states : {1U, 2U, 5U, 20U, 100U, 1000U})
            for (const std::uint64_t seed : {1U, 2U}) expect_consistent(name, whole, options_with(states, seed, 1));
        expect_consistent(name, whole, options_with(20, 1, 4));
        Options little_memory = options_with(1'000'000, 1, 1);
        little_memory.limits.memory_bytes = 1U << 20U;
        expect_consistent(name, whole, little_memory);
        Options no_walks = options_with(20, 1, 1);
        no_walks.walks.cycles = 0;
        expect_consistent(name, whole, no_walks);
    }

private:
    static Options options_with(std::uint64_t states, std::uint64_t seed, unsigned threads) {
        Options options;
        options.limits.max_states = states;
        options.limits.threads = threads;
        options.walks = {300, 5, seed};
        return options;
    }

    void expect_consistent(const std::string& name, const Result& whole, const Options& options) {
        const Result found = judge(options);
        const std::string limits = fmt::format("{}, {} states, seed {}: {}", name, options.limits.max_states,
                                               options.walks.seed, found.reason);
        if (found.outcome != Outcome::inconclusive) {
            EXPECT_EQ(found.outcome, whole.outcome) << limits;
        }
        if (found.register_cycles && whole.register_cycles) {
            EXPECT_EQ(found.register_cycles->holds, whole.register_cycles->holds) << limits;
        }
        if (found.deadlines && whole.deadlines) {
            EXPECT_EQ(found.deadlines->holds, whole.deadlines->holds) << limits;
        }
    }

    test::Model& model_;
    ir::ComponentRef component_;
    test::Bench bench_;
    std::unique_ptr<SharedObject> code_;
};

TEST(Limits, NeverTurnAnAnswerIntoAnother) {
    for (const Subject& subject : test_subjects()) {
        test::Model model(subject.folder);
        const ir::ComponentRef component =
            subject.machine.empty() ? model.first_module() : model.machine_named(subject.machine);
        Limited(model, component).expect_the_same_or_nothing(subject.folder + " " + subject.machine);
    }
}

/// With a limit, the check of faulty code must find the difference or be inconclusive.
TEST(Limits, NeverExcuseAFault) {
    test::Model model("corpus/aggregation");
    for (const cpp_emit::Fault fault : {cpp_emit::Fault::action_dropped, cpp_emit::Fault::entry_dropped})
        Limited(model, model.first_module(), fault).expect_the_same_or_nothing("aggregation with a fault");
}

Result unlimited_and_limited(const std::string& text, const std::string& machine) {
    const test::ModelFolder folder(text);
    test::Model model(folder.path());
    Limited limited(model, machine.empty() ? model.first_controller() : model.machine_named(machine));
    limited.expect_the_same_or_nothing(machine);
    return limited.judge({});
}

/// An unconnected trigger is always enabled, so the model of Spin diverges, and so does its code.
TEST(Limits, OfAModelThatDiverges) {
    const Result result = unlimited_and_limited(R"(
interface Passes { event given : nat event taken : nat }
controller Both {
    uses Passes
    stm Spin {
        event never
        initial i state Turning { }
        transition t0 { from i to Turning }
        transition t1 { from Turning to Turning trigger never }
    }
    stm Pass {
        uses Passes
        var held : nat
        initial i state Waiting { }
        transition t0 { from i to Waiting }
        transition t1 { from Waiting to Waiting trigger given?held action taken!held }
    }
    connection Both on given to Pass on given
    connection Pass on taken to Both on taken
})",
                                                "");
    EXPECT_EQ(result.outcome, Outcome::not_schedulable) << result.reason;
}

/// The model makes infinitely many visible outputs.
TEST(Limits, OfAModelThatSendsWithoutEnd) {
    const Result result = unlimited_and_limited(R"(
stm Sends {
    event go event x : nat
    initial i state A { } state B { entry x!1 }
    transition t0 { from i to A }
    transition t1 { from A to B trigger go }
    transition t2 { from B to B }
})",
                                                "Sends");
    EXPECT_EQ(result.outcome, Outcome::not_schedulable) << result.reason;
    EXPECT_NE(result.reason.find("without time passing"), std::string::npos);
    ASSERT_FALSE(result.cycles.empty());
    EXPECT_EQ(result.cycles.back().inputs, std::vector<std::string>{"go"});
}

/// A cycle with many outputs is not an endless loop. The log grows, and the code stays below its bound of steps.
TEST(Limits, OfACycleWithManyOutputs) {
    const test::ModelFolder folder(R"(
stm Counts {
    event go event x : nat
    var n : nat
    initial i state A { } state B { entry x!n ; n = n + 1 }
    transition t0 { from i to A }
    transition t1 { from A to B trigger go }
    transition t2 { from B to B condition n < 2500 }
    transition t3 { from B to A condition n >= 2500 action n = 0 }
})");
    ir::InstantiationOptions sizes;
    sizes.ranges["nat"] = {0, 2500};
    test::Model model(folder.path(), sizes);
    Limited limited(model, model.machine_named("Counts"));
    const Result result = limited.judge({});
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
    ASSERT_TRUE(result.register_cycles);
    EXPECT_FALSE(result.register_cycles->holds);
}

/// Actions with a deadline wait for inputs. The code conforms up to a missed deadline.
TEST(Limits, OfDeadlinesOnInputs) {
    const Result result = unlimited_and_limited(R"(
stm Asks {
    event ask event answer : nat event x : nat
    var v : nat
    initial i state A { } state B { entry x!1 ; (answer?v) <{1} ; x!v }
    transition t0 { from i to A }
    transition t1 { from A to B trigger ask }
    transition t2 { from B to A trigger ask }
})",
                                                "Asks");
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
    ASSERT_TRUE(result.deadlines && result.register_cycles);
    EXPECT_FALSE(result.register_cycles->holds);
    EXPECT_FALSE(result.deadlines->holds);
    // The answer may come in the cycle of the question, or at the latest in the next one.
    ASSERT_EQ(result.deadlines->cycles.size(), 2U);
}

}  // namespace
}  // namespace robochart::conformance
