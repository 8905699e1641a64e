// SPDX-License-Identifier: Apache-2.0
// Tests compiled code in other ways than its check: comparison with other code, a watchdog for code that does not
// return, and the report of code that does not compile.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "conformance/check/conform.hpp"
#include "conformance/code/cycle_log.hpp"
#include "conformance/code/watchdog.hpp"
#include "tests/conformance/batches/code_batch.hpp"
#include "tests/conformance/batches/code_equality.hpp"
#include "tests/conformance/bench.hpp"
#include "tests/conformance/support.hpp"

namespace robochart::conformance {
namespace {

using cpp_emit::Fault;
using testing::HasSubstr;

/// In objects/turner.cpp, each of these faults is visible (known_bad_test.cpp).
constexpr int bad[] = {1, 2, 3, 4, 5, 6, 7, 11};

TEST(CodeEquality, TellsFaultsFromTheOriginalAndNothingFromItself) {
    process::EventTable events;
    const Alphabet alphabet(test::turner_interface(), events);
    std::string error;
    const auto right = test::hand_made("turner", 0, error);
    ASSERT_TRUE(right) << error;
    const CodeEquality itself = compare_code(right->interface(), right->interface(), alphabet, 1, {});
    EXPECT_TRUE(itself.same);
    EXPECT_GT(itself.states, 0U);
    for (const int fault : bad) {
        const auto wrong = test::hand_made("turner", fault, error);
        ASSERT_TRUE(wrong) << error;
        EXPECT_TRUE(compare_code(wrong->interface(), wrong->interface(), alphabet, 1, {}).same) << fault;
        const CodeEquality found = compare_code(right->interface(), wrong->interface(), alphabet, 1, {});
        EXPECT_FALSE(found.same) << fault;
        EXPECT_GE(found.cycles, 1U) << fault;
        EXPECT_FALSE(compare_code(wrong->interface(), right->interface(), alphabet, 1, {}).same) << fault;
    }
}

/// The second generation of RoboTool's code has a loop `while (tryTransitions())`. Here the loop contains a transition
/// that waits for an input in the model.
TEST(Watchdog, ALoopThatNeverEndsIsFoundAndNotWaitedFor) {
    test::Model model("tests/conformance/models/blink");
    test::Bench bench(model, model.machine_named("Blink"));
    const Result endless = bench.check_code(Fault::loop_never_ends, 0);
    EXPECT_EQ(endless.outcome, Outcome::differs);
    EXPECT_THAT(endless.reason, HasSubstr("`step` does not return"));
    EXPECT_EQ(endless.cycles.size(), 1U);
    EXPECT_EQ(bench.check_code().outcome, Outcome::conforms);
}

TEST(Watchdog, LeavesCodeThatReturnsAlone) {
    std::string error;
    const auto object = test::hand_made("turner", 0, error);
    ASSERT_TRUE(object) << error;
    const rc_interface& code = object->interface();
    std::vector<unsigned char> watched(code.state_size), plain(code.state_size);
    code.initial(watched.data());
    code.initial(plain.data());
    const std::vector<rc_register> registers(code.inputs);
    CycleLog one, other;
    const Stepped stepped = step_watched(code, watched.data(), registers.data(), &one, Patience::short_);
    EXPECT_FALSE(stepped.endless);
    EXPECT_EQ(stepped.result, code.step(plain.data(), registers.data(), &other));
    EXPECT_EQ(watched, plain);
    EXPECT_EQ(one.count, other.count);
}

/// Generated code that does not compile is an error of the generator. `conform` shows the compiler's message.
TEST(Uncompilable, IsReportedWithTheCompilersWords) {
    test::Model model("tests/conformance/models/nested");
    for (const auto& [fault, words] : {std::pair(Fault::undeclared_member, "no member named"),
                                       std::pair(Fault::name_collision, "duplicate case value")}) {
        Options options;
        options.generator.fault = fault;
        const Result result =
            conform(model.system, model.instantiation, model.first_module(), options, model.sources, model.diagnostics);
        EXPECT_EQ(result.outcome, Outcome::not_generated);
        EXPECT_THAT(result.reason, HasSubstr("c++ failed with status"));
        EXPECT_THAT(result.reason, HasSubstr(words));
    }
}

TEST(CodeBatch, ErrorsAreThoseOfTheirCandidates) {
    const std::vector<std::string> errors = errors_by_candidate(
        "In file included from batch.cpp:3:\n"
        "candidate_1.cpp: In function f:\n"
        "candidate_1.cpp:7:9: error: duplicate case value\n"
        "candidate_1.cpp:8:9: error: and another\n"
        "candidate_12.cpp:1:1: error: not one of three\n"
        "robochart/runtime.hpp:4:1: error: in a header of all\n",
        3);
    EXPECT_EQ(errors, (std::vector<std::string>{"", "error: duplicate case value", ""}));
}

}  // namespace
}  // namespace robochart::conformance
