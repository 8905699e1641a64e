// SPDX-License-Identifier: Apache-2.0
// Tests that a verdict about a smaller model always says so. If they occur in a reachable state, the verdict names
// arithmetic that left its type, calls of functions without a body, and sequences that are too short. Otherwise it
// contains no such note.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/app/command.hpp"

namespace robochart::app::testing::bounds_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// x counts to 3. The guard of t2 doubles it, and 2 * 2 is not in 0..3. t3 is never enabled, so x + 9 is never
// evaluated.
const char* const machine = R"(
function f(x : nat) : nat { }
stm S {
  event a : nat
  event b
  event c
  var x : nat = 0
  initial i
  state A { }
  state B { entry a ! f(x) }
  transition t0 { from i to A }
  transition t1 { from A to A trigger b condition x < 3 action x = x + 1 }
  transition t2 { from A to B trigger c condition x * 2 == 2 }
  transition t3 { from B to B trigger c condition x > 3 action x = x + 9 }
}
)";

class Bounds : public ::testing::Test {
protected:
    nlohmann::json check(const std::string& assertions, const std::vector<std::string>& options = {}) {
        const TemporaryFile model("bounds.rct", machine);
        const std::string folder = std::filesystem::path(model.path()).parent_path().string();
        std::ofstream(folder + "/bounds.assertions") << assertions;
        std::vector<std::string> arguments{"check", folder, "--format", "json"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Ran ran = run(arguments);
        const auto report = nlohmann::json::parse(ran.out, nullptr, false);
        EXPECT_FALSE(report.is_discarded()) << ran.out << ran.err;
        return report.is_discarded() ? nlohmann::json::object() : report["bounds"];
    }
};

TEST_F(Bounds, AreReportedWithElementAndPlace) {
    const auto bounds = check("assertion A : S is divergence-free\n", {"--range", "nat=0..3"});
    ASSERT_EQ(bounds.size(), 2U) << bounds;
    const std::string all = bounds.dump();
    EXPECT_THAT(all, HasSubstr("in x * 2 == 2, 2 * 2 leaves its type and is taken as 2"));
    EXPECT_THAT(all, HasSubstr("\"element\":\"S::t2\""));
    EXPECT_THAT(all, HasSubstr("bounds.rct:13"));
    EXPECT_THAT(all, HasSubstr("in f(x), f has no body here and is taken as 0"));
    EXPECT_THAT(all, HasSubstr("bounds.rct:10"));
    for (const auto& bound : bounds) EXPECT_EQ(bound["time"], "untimed, timed");
}

TEST_F(Bounds, AreNotReportedWhereNoneIsReached) {
    // With a carrier that contains 3 * 2, only the note on the function remains. With a body for the function in the
    // instantiations, no note remains.
    const auto wide = check("untimed assertion A : S is divergence-free\n", {"--range", "nat=0..9"});
    ASSERT_EQ(wide.size(), 1U) << wide;
    EXPECT_EQ(wide[0]["element"], "S::B");
    EXPECT_EQ(wide[0]["time"], "untimed");
    const auto none = check(
        "untimed assertion A : S is divergence-free\n"
        "csp Instantiations csp-begin\nf(x__) = x__\ncsp-end\n",
        {"--range", "nat=0..9"});
    EXPECT_EQ(none.size(), 0U) << none;
    // Without assertions, `check` checks the core properties, which depend on the same states. The condition x * 2 == 2
    // compares only values of the default carriers, which the user has not chosen.
    EXPECT_EQ(check("").size(), 2U);
}

TEST_F(Bounds, AreInTheTextAlthoughQuiet) {
    const TemporaryFile model("quiet.rct", machine);
    const std::string folder = std::filesystem::path(model.path()).parent_path().string();
    std::ofstream(folder + "/quiet.assertions") << "untimed assertion A : S is divergence-free\n";
    const Ran ran = run({"check", folder, "--quiet", "--range", "nat=0..3"});
    EXPECT_EQ(ran.exit, 0);
    EXPECT_THAT(ran.out, AllOf(HasSubstr("rests on: in x * 2 == 2, 2 * 2 leaves"), HasSubstr("--range gives types"),
                               Not(HasSubstr("x + 9"))));
}

/// The sender never sends 2, so doubling leaves the type only if the receiver is checked alone.
TEST_F(Bounds, AreThoseThatTheClaimsProcessReaches) {
    const TemporaryFile model("reached.rct", R"(
stm Sender { event go event out : nat initial i state A { }
  transition t0 { from i to A } transition t1 { from A to A trigger go action out ! 1 } }
stm Receiver { event in_ : nat event twice : nat var x : nat initial i state B { } state D { entry twice ! (x + x) }
  transition t0 { from i to B } transition t1 { from B to D trigger in_ ? x } transition t2 { from D to B } }
controller C { event go event twice : nat sref s = Sender sref r = Receiver
  connection C on go to s on go connection s on out to r on in_ connection r on twice to C on twice }
)");
    const std::string folder = std::filesystem::path(model.path()).parent_path().string();
    std::ofstream(folder + "/reached.assertions") << "untimed assertion Whole : C is deadlock-free\n"
                                                     "untimed assertion Alone : Receiver is deadlock-free\n";
    const Ran ran = run({"check", folder, "--format", "json", "--range", "nat=0..3"});
    const auto report = nlohmann::json::parse(ran.out, nullptr, false);
    ASSERT_FALSE(report.is_discarded()) << ran.out << ran.err;
    EXPECT_FALSE(report["assertions"][0].contains("basis")) << report["assertions"][0];
    ASSERT_EQ(report["assertions"][1]["basis"].size(), 1U) << report["assertions"][1];
    EXPECT_EQ(report["assertions"][1]["basis"][0]["kind"], "bound");
    EXPECT_EQ(report["assertions"][1]["basis"][0]["element"], "Receiver::D");
    EXPECT_EQ(report["bounds"].size(), 1U);
}

/// The carrier has sequences of at most two elements, so no sequence has a third element, and the junction has no
/// enabled transition.
TEST_F(Bounds, OfSequencesAreNamedWithTheOptionThatWidensThem) {
    const std::string parts = R"(
  event in_ : Seq(boolean)
  var s : Seq(boolean)
  initial i
  state A { }
  junction j
  final f
  transition t0 { from i to A }
  transition t1 { from A to j trigger in_ ? s }
)";
    const auto basis = [&](const std::string& first, const std::string& second) {
        const TemporaryFile model("short.rct", "import sequence_toolkit::*\nstm S {" + parts +
                                                   "transition t2 { from j to f condition " + first +
                                                   " }\ntransition t3 { from j to A condition " + second + " }\n}\n");
        const std::string folder = std::filesystem::path(model.path()).parent_path().string();
        std::ofstream(folder + "/short.assertions") << "untimed assertion A : S is deadlock-free\n";
        const Ran ran = run({"check", folder, "--concrete", "--format", "json"});
        const auto report = nlohmann::json::parse(ran.out, nullptr, false);
        EXPECT_FALSE(report.is_discarded()) << ran.out << ran.err;
        return report.is_discarded() ? "" : report["assertions"][0].value("basis", nlohmann::json::array()).dump();
    };
    EXPECT_THAT(basis("head(extract([3, 4], s))", "not head(extract([3, 4], s))"),
                AllOf(HasSubstr("sequences hold at most 2 elements here"), HasSubstr("takes none"),
                      HasSubstr("--range Seq=0..4")));
    EXPECT_THAT(basis("size(s) > 2", "size(s) < 2"),
                AllOf(HasSubstr("has one answer for all of them"), HasSubstr("--range Seq=0..3")));
    EXPECT_EQ(basis("size(s) > 1", "size(s) <= 1"), "[]");
}

/// An evaluation error names the constant that has no value.
TEST_F(Bounds, ErrorsNameTheirCauseInTheModel) {
    const auto reason = [&](const std::string& text) {
        const TemporaryFile model("cause.rct", text);
        const Ran ran = run({"check", model.path(), "--untimed", "--format", "json"});
        const auto report = nlohmann::json::parse(ran.out, nullptr, false);
        EXPECT_FALSE(report.is_discarded()) << ran.out << ran.err;
        EXPECT_EQ(ran.exit, 2);
        return report.is_discarded() ? "" : report["assertions"][0].value("reason", std::string());
    };
    EXPECT_THAT(reason("stm S { event go const speed : nat const half : nat = 1 var n : nat initial i state A { }\n"
                       "transition t0 { from i to A }\n"
                       "transition t1 { from A to A trigger go condition n >= half / speed } }"),
                AllOf(HasSubstr("cause.rct:3"), HasSubstr("division by zero"), HasSubstr("--const speed=1")));
}

/// Components are named with their package. If several parts have a component of the same name, the name of the part
/// precedes the name of the package.
TEST_F(Bounds, NameTheComponent) {
    const Folder folder(
        {{"a.rct", "package a\n" + std::string(machine)}, {"b.rct", "package b\n" + std::string(machine)}});
    const Ran ran = run({"check", folder.path(), "--untimed", "--quiet", "--range", "nat=0..3"});
    EXPECT_THAT(ran.out, AllOf(HasSubstr("in x * 2 == 2, 2 * 2 leaves its type and is taken as 2"), HasSubstr("a.rct:"),
                               HasSubstr("b.rct:")))
        << ran.err;
}

}  // namespace
}  // namespace robochart::app::testing::bounds_test
