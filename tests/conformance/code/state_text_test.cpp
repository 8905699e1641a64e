// SPDX-License-Identifier: Apache-2.0
// Tests states of the code as reports show them. Reports show composite values in the notation of logs
// (docs/traces.md), so states with equal text are equal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "conformance/check/conform.hpp"
#include "conformance/code/code_system.hpp"
#include "conformance/code/cycle_log.hpp"
#include "tests/conformance/batches/batch.hpp"
#include "tests/conformance/bench.hpp"

namespace robochart::conformance {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* matrix_model =
    "stm S { event e : matrix(boolean, 2, 2) event out : matrix(boolean, 2, 2) var m : matrix(boolean, 2, 2)\n"
    "initial i state A { } transition t0 { from i to A }\n"
    "transition t1 { from A to A trigger e?m action m[1, 2] = false; m[2, 1] = m[1, 1]; out!m } }\n";

/// The machine has variables of every composite type. The report must show the values that `go` assigns. Other
/// variables have the initial values of semantics 3.6: true for truth values and 0 for numbers. A list is part of the
/// state only if a later cycle reads it, as the condition of t2 does.
constexpr const char* every_type =
    "enumeration Mode { slow fast } enumeration Colour { Red Put(boolean) }\n"
    "datatype Pose { far : real lit : boolean modes : Seq(Mode) }\n"
    "stm S { event go event done\n"
    "var m : matrix(boolean, 2, 2) var v : vector(int, 2) var p : Pose var q : Seq(nat) var s : Set(boolean)\n"
    "var c : Colour var d : Mode var f : boolean -> boolean var t : string\n"
    "initial i state A { } transition t0 { from i to A }\n"
    "transition t1 { from A to A trigger go action m[1, 2] = false; v[2] = -1; p.far = 0.5; p.lit = true;\n"
    "p.modes = <Mode::fast, Mode::slow>; q = <2, 0>; s = {true}; c = Colour::Put(true); d = Mode::fast;\n"
    "f = {(| true, false |)} as boolean -> boolean; t = \"so far\"; done }\n"
    "transition t2 { from A to A trigger go condition q == <1> } }\n";

/// Returns the state after a number of cycles in which all inputs without values occur.
std::string state_after(const rc_interface& code, int cycles) {
    std::vector<unsigned char> state(code.state_size);
    code.initial(state.data());
    for (int cycle = 0; cycle < cycles; ++cycle) {
        std::vector<rc_register> registers(code.inputs);
        for (rc_register& input : registers) input.present = 1;
        CycleLog log;
        EXPECT_EQ(code.step(state.data(), registers.data(), &log), RC_QUIESCENT);
    }
    return state_text(code.print, state.data());
}

void expect_the_words_of_every_type(const std::string& state) {
    for (const char* words : {"m=((true,false),(true,true))", "v=(0,-1)", "p=(0.5,true,<fast,slow>)", "q=<2,0>",
                              "s={true}", "c=Put(true)", "d=fast", "f={(true,false)}", "t=\"so\\040far\""})
        EXPECT_THAT(" " + state + " ", HasSubstr(" " + std::string(words) + " "));
}

TEST(StateText, MatricesAreCanonical) {
    const test::ModelFolder folder(matrix_model);
    test::Model model(folder.path());
    diagnostics::Diagnostics found;
    const Result result =
        conform(model.system, model.instantiation, model.machine_named("S"), {}, model.sources, found);
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
    EXPECT_THAT(result.warnings, IsEmpty());
}

TEST(StateText, ValuesWithPartsAreWordsOfLogs) {
    const test::ModelFolder folder(every_type);
    test::Model model(folder.path());
    test::Bench bench(model, model.machine_named("S"));
    const auto object = bench.compile_fault(cpp_emit::Fault::none, 0);
    ASSERT_TRUE(object);
    expect_the_words_of_every_type(state_after(object->interface(), 2));
}

/// The reported code omits the output `done`, so its last state is that after the other actions.
TEST(StateText, ReportsTellThem) {
    const test::ModelFolder folder(every_type);
    test::Model model(folder.path());
    test::Bench bench(model, model.machine_named("S"));
    const Result result = bench.check_code(cpp_emit::Fault::send_dropped, 0);
    ASSERT_EQ(result.outcome, Outcome::differs) << result.reason;
    ASSERT_FALSE(result.cycles.empty());
    expect_the_words_of_every_type(result.cycles.back().state);
}

/// The translation unit has several candidates, each with its own trace header.
TEST(StateText, IsPrintedForCandidatesOfABatch) {
    std::vector<std::unique_ptr<test::Model>> models;
    std::vector<std::unique_ptr<Candidate>> candidates;
    for (const char* text : {matrix_model, every_type, every_type}) {
        const test::ModelFolder folder(text);
        models.push_back(std::make_unique<test::Model>(folder.path()));
        test::Model& model = *models.back();
        candidates.push_back(candidate(model.system, model.instantiation, model.machine_named("S"), {}, model.sources,
                                       model.diagnostics));
        ASSERT_TRUE(candidates.back());
    }
    std::string error;
    const auto batch = Batch::build(std::move(candidates), {}, error);
    ASSERT_TRUE(batch) << error;
    for (std::size_t index = 0; index < models.size(); ++index) {
        const Result result = batch->judge_candidate(index);
        EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
        EXPECT_THAT(result.warnings, IsEmpty());
    }
}

/// Values in buffers between two machines are reported like values of variables.
TEST(StateText, BuffersTellWhatTheyHold) {
    const test::ModelFolder folder(
        "datatype Pose { far : real lit : boolean }\n"
        "stm A { event e : Pose event b : real var p : Pose initial i state X { } transition t0 { from i to X\n"
        "action p.far = 0.5; p.lit = true; e!p; b!(0.5) } }\n"
        "stm B { event e : Pose event b : real event go : boolean var p : Pose var x : real var y : boolean\n"
        "initial i state X { } state Y { } transition t0 { from i to X }\n"
        "transition t1 { from X to Y trigger go?y condition y } transition t2 { from Y to Y trigger e?p }\n"
        "transition t3 { from Y to Y trigger b?x } }\n"
        "controller C { event e : Pose event b : real sref a = A connection a on e to C on e\n"
        "connection a on b to C on b }\n"
        "controller D { event e : Pose event b : real event go : boolean sref d = B connection D on go to d on go\n"
        "connection D on e to d on e connection D on b to d on b }\n"
        "module M { robotic platform P { event go : boolean } cref c = C cref k = D\n"
        "connection P on go to k on go ( _async )\n"
        "connection c on e to k on e ( _async ) connection c on b to k on b ( _async ) }\n");
    test::Model model(folder.path());
    test::Bench bench(model, model.first_module());
    const auto object = bench.compile_fault(cpp_emit::Fault::none, 0);
    ASSERT_TRUE(object);
    const std::string state = state_after(object->interface(), 1);
    EXPECT_THAT(state, HasSubstr("=(0.5,true)"));
    EXPECT_THAT(state + " ", HasSubstr("=0.5 "));
}

/// Texts that are longer than the initial buffer are printed completely.
TEST(StateText, LongStatesAreReportedWhole) {
    rc_interface code{};
    code.print = [](const void*, char* buffer, std::size_t size) {
        for (std::size_t i = 0; i + 1 < size; ++i) buffer[i] = i < 10'000 ? 'x' : '\0';
        buffer[size - 1] = '\0';
    };
    EXPECT_EQ(state_text(code.print, nullptr), std::string(10'000, 'x'));
}

}  // namespace
}  // namespace robochart::conformance
