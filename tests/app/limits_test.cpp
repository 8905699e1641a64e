// SPDX-License-Identifier: Apache-2.0
// Tests limits and signals in every phase. A run that would take hours or all memory ends soon, with exit code 3 and a
// report of the partial results, and removes its temporary files. The time bounds are generous, because these tests
// detect runs that hang.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <string>

#include "tests/app/command.hpp"

namespace robochart::app::testing::limits_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// Returns record types, each with two fields of the next type, so that a value has 2^levels parts.
std::string doubling_records(int levels) {
    std::string text;
    for (int i = 0; i < levels; ++i)
        text += "datatype T" + std::to_string(i) + " { a : T" + std::to_string(i + 1) + " b : T" +
                std::to_string(i + 1) + " }\n";
    text += "datatype T" + std::to_string(levels) + " { x : boolean }\n";
    return text +
           "stm S {\n var v : T0\n event e : T0\n initial i\n state A { }\n transition t0 { from i to A }\n"
           " transition t1 { from A to A trigger e ? v }\n}\n";
}

/// Returns a condition that quantifies over 3^17 values.
std::string large_quantifier() {
    std::string names;
    for (char c = 'a'; c <= 'q'; ++c) names += std::string(c == 'a' ? "" : ", ") + c + c + " : nat";
    return "stm S {\n initial i\n state A { }\n transition t0 { from i to A condition forall " + names +
           " @ aa + bb >= 0 }\n}\n";
}

/// Returns a controller with parallel machines of two states each, which together have 2^count states.
std::string many_machines(int count) {
    std::string text;
    std::string refs;
    for (int i = 0; i < count; ++i) {
        const std::string n = std::to_string(i);
        text += "stm S" + n +
                " {\n event e\n initial i\n state A {} state B {}\n transition t0 { from i to A }\n"
                " transition t1 { from A to B trigger e }\n transition t2 { from B to A trigger e }\n}\n";
        refs += " event e" + n + "\n sref s" + n + " = S" + n + "\n connection C on e" + n + " to s" + n + " on e\n";
    }
    return text + "controller C {\n" + refs + "}\n";
}

struct Hard {
    const char* name;
    std::string model;
    const char* arguments;  ///< the model is m.rct
};

void PrintTo(const Hard& hard, std::ostream* out) {
    *out << hard.name;
}

class HardWork : public ::testing::TestWithParam<Hard> {};

std::string in_time(const Hard& hard, const std::string& more) {
    // The shell's own limit ends the test if the command does not end.
    return "cat > m.rct <<'END'\n" + hard.model +
           "END\n mkdir tmp; export TMPDIR=$PWD/tmp\n timeout -s KILL 60 \"$verify\" " + hard.arguments + " " + more +
           "; code=$?; ls tmp; exit $code";
}

TEST_P(HardWork, OfTimeEndIt) {
    const Ran ran = run_shell(in_time(GetParam(), "--timeout 1 m.rct"));
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    EXPECT_THAT(ran.out + ran.err, HasSubstr("the time limit was reached"));
    EXPECT_THAT(ran.out, Not(HasSubstr("robochart-")));  // no temporary files are left
}

TEST_P(HardWork, OfMemoryOrTimeEndIt) {
    const Ran ran = run_shell(in_time(GetParam(), "--memory 100M --timeout 2 m.rct"));
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    EXPECT_THAT(ran.out + ran.err, HasSubstr("limit"));
}

TEST_P(HardWork, OfTheSystemEndIt) {
    const Ran ran = run_shell("ulimit -v 1500000; " + in_time(GetParam(), "--timeout 2 m.rct"));
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
}

TEST_P(HardWork, SignalsEndItWithAReport) {
    const Hard& hard = GetParam();
    const Ran ran =
        run_shell("cat > m.rct <<'END'\n" + hard.model +
                  "END\n mkdir tmp; export TMPDIR=$PWD/tmp\n timeout -s KILL 60 \"$verify\" " + hard.arguments +
                  " m.rct & p=$!; sleep 1; kill -TERM $p; wait $p; code=$?; ls tmp; exit $code");
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    EXPECT_THAT(ran.out + ran.err, HasSubstr("the run was interrupted"));
    EXPECT_THAT(ran.out, Not(HasSubstr("robochart-")));
}

TEST_P(HardWork, TheReportIsJsonWhereItIsWanted) {
    const Ran ran = run_shell(in_time(GetParam(), "--format json --timeout 1 m.rct"));
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    EXPECT_THAT(ran.out, AllOf(HasSubstr("\"schema\": \"robochart-verify/report/1\""), HasSubstr("limit was reached")));
}

INSTANTIATE_TEST_SUITE_P(LimitedPhases, HardWork,
                         ::testing::Values(Hard{"Carriers", doubling_records(22), "check --core"},
                                           Hard{"CarriersOfCode", doubling_records(22), "conform"},
                                           Hard{"Values", large_quantifier(), "check --core"},
                                           Hard{"Composition", many_machines(40), "conform --walks 0"}),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(RunLimits, AreOfTheWholeRunNotOfEachCheck) {
    // Each of the ten assertions alone would need all of its two seconds.
    std::string claims;
    for (int i = 0; i < 10; ++i) claims += "assertion A" + std::to_string(i) + " : C is deterministic\n";
    const Hard hard{"", many_machines(30), "check"};
    const Ran ran = run_shell("cat > m.assertions <<'END'\n" + claims + "END\n" +
                              in_time(hard, "--timeout 2 --no-reduction --untimed m.rct"));
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    EXPECT_THAT(ran.out, AllOf(HasSubstr("A0"), HasSubstr("A9"), HasSubstr("10 inconclusive")));
}

TEST(RunLimits, OneClaimThatReachesTheMemoryLimitDoesNotEndTheOthers) {
    const Hard hard{"", many_machines(30), "check"};
    const Ran ran = run_shell(
        "printf 'assertion Large : C is deterministic\\nassertion Small : S0 is deadlock-free\\n' > m.assertions\n" +
        in_time(hard, "--memory 100MiB --timeout 500 --no-cache --no-reduction --untimed --format json m.rct"));
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    EXPECT_THAT(ran.out, AllOf(HasSubstr("the memory limit of 100 MiB was reached"), HasSubstr("\"holds\"")));
}

TEST(RunLimits, WhatWasKnownBeforeIsReported) {
    const std::string model = many_machines(30) + "stm Small { initial i state A { } transition t0 { from i to A } }\n";
    const Hard hard{"", model, "check"};
    const Ran ran = run_shell(
        "cat > m.assertions <<'END'\nassertion First : Small is deterministic\nassertion Second : C is "
        "deterministic\nEND\n" +
        in_time(hard, "--timeout 3 --no-reduction --untimed m.rct"));
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    EXPECT_THAT(ran.out, AllOf(HasSubstr("holds        First"), HasSubstr("inconclusive Second")));
}

// The system's limit of processor time sends SIGXCPU, and repeats it each second. The run ends in an orderly way,
// although the signal comes again.
TEST(RunLimits, OfTheSystemsProcessorTimeEndItInOrder) {
    const Ran ran = run_shell("cat > m.rct <<'END'\n" + many_machines(40) +
                              "END\n mkdir tmp; export TMPDIR=$PWD/tmp\n ulimit -S -t 1; timeout -s KILL 60 "
                              "\"$verify\" check --core --no-reduction m.rct; code=$?; ls tmp; exit $code");
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    EXPECT_THAT(ran.out + ran.err, HasSubstr("the run was interrupted"));
}

// Freeing the states takes longer than the watchdog thread waits. The watchdog must not print a second object.
TEST(RunLimits, AScriptHasOneObject) {
    for (const char* format : {"json", "framed_json"}) {
        const Ran ran = run_shell(
            "printf 'channel a : {0..99}\\nP(n) = a?x -> P((n*x+1) %% 1000003)\\nassert P(1) :[deterministic [FD]]\\n' "
            "> s.csp\n"
            "timeout -s KILL 60 \"$verify\" cspm --timeout 3 --format " +
            std::string(format) + " s.csp");
        EXPECT_EQ(ran.exit, 3) << ran.err;
        EXPECT_EQ(std::ranges::count(ran.out, '\n'), 1) << ran.out;
    }
}

TEST(RunLimits, TheSecondSignalEndsTheRunAtOnce) {
    const Ran ran = run_shell(
        R"(printf 'channel a : {0..99}\nP(n) = a?x -> P((n*x+1) %% 1000003)\nassert P(1) :[deterministic [FD]]\n' > s.csp
mkdir tmp; export TMPDIR=$PWD/tmp
"$verify" cspm s.csp > out & sleep 1; kill -INT $!; kill -INT $!; wait $!; echo "exit $?"; ls tmp)");
    EXPECT_THAT(ran.out, ::testing::AnyOf("exit 3\n", "exit 130\n")) << ran.err;
}

}  // namespace
}  // namespace robochart::app::testing::limits_test
