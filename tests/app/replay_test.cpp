// SPDX-License-Identifier: Apache-2.0
// Replays counterexamples of all models of the tests from their JSON.
#include "tests/app/replay.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/app/command.hpp"
#include "tests/random_models/models/well_formed.hpp"
#include "tests/rounds.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::app::testing::replay_test {
namespace {

namespace fs = std::filesystem;

void show(const char* what, const Replayed& sum) {
    if (std::getenv("ROBOCHART_SHOW") == nullptr) return;
    std::printf("%s: %zu assertions, %zu counterexamples, %zu steps, %zu states of machines\n", what, sum.assertions,
                sum.counterexamples, sum.steps, sum.machines);
    for (const auto& [kind, count] : sum.endings) std::printf("  end %s: %zu\n", kind.c_str(), count);
    for (const auto& [kind, count] : sum.kinds) std::printf("  step %s: %zu\n", kind.c_str(), count);
}

void expect_no_faults(const Replayed& sum) {
    std::string all;
    for (std::size_t i = 0; i < sum.faults.size() && i < 10; ++i) all += sum.faults[i] + "\n";
    EXPECT_TRUE(sum.faults.empty()) << sum.faults.size() << " faults\n" << all;
}

TEST(Replay, OfTheCorpusAndItsFalseClaims) {
    Replayed sum;
    replay({repository("corpus/aggregation"), repository("corpus/false_claims/aggregation.assertions")}, true, sum);
    replay({repository("corpus/swarm_taxis"), repository("corpus/false_claims/swarm_taxis.assertions")}, true, sum);
    show("corpus", sum);
    expect_no_faults(sum);
    EXPECT_GE(sum.counterexamples, 3U);
}

const char* const forms = R"(
interface I { event a : nat event b event c : nat }
interface O { move(l: real, c: Colour) }
enumeration Colour { red light_green(nat) }
record R { x : real y : Colour }
stm Fast { uses I initial i state A { } transition t0 { from i to A }
  transition t1 { from A to A trigger a ? x condition x > 0 action c ! x } var x : nat }
stm Slow { uses I initial i state A { } state B { entry wait(2) } transition t0 { from i to A }
  transition t1 { from A to B trigger a ? x } transition t2 { from B to A action c ! x } var x : nat }
stm Clocky { uses I clock T initial i state A { } state B { } transition t0 { from i to A }
  transition t1 { from A to B trigger b condition since(T) >= 3 }
  transition t2 { from B to A trigger a ? x action # T } var x : nat }
stm Sets { uses I clock T initial i state A { } state B { } transition t0 { from i to A action # T }
  transition t1 { from A to B trigger b condition since(T) >= 3 } }
stm Data { requires O event p : R event q : Seq(real) var v : R initial i
  state A { entry move(-0.75, Colour::red) ; v = R (| x = 1.5, y = Colour::light_green(1) |) ; p ! v ; q ! <0.5, 1.5> }
  transition t0 { from i to A } }
stm Choices { uses I initial i state A { } state B { } transition t0 { from i to A }
  transition t1 { from A to B trigger b } transition t2 { from A to A trigger b } }
stm Ends { uses I initial i state A { } final f transition t0 { from i to A } transition t1 { from A to f trigger b } }
stm Spins { initial i state A { } state B { } transition t0 { from i to A } transition t1 { from A to B }
  transition t2 { from B to A } }
)";

const char* const claims = R"(
assertion A1 : Slow refines Fast
assertion A2 : Fast refines Slow in the traces model
assertion A3 : Fast refines Slow in the failures model
timed assertion A4 : Slow refines Fast in the tick-tock model
timed assertion A5 : Slow equals Fast in the tick-tock model
assertion A6 : Fast equals Slow
assertion A7 : Slow equals Fast
assertion A8 : clock Clocky::T is initialised
assertion A9 : clock Sets::T is not initialised
assertion A10 : Choices is deterministic
assertion A11 : Ends does not terminate
assertion A12 : Choices terminates
assertion A13 : Spins is divergence-free
assertion A14 : Slow::B is not reachable in Slow
timed assertion A15 : Data is timelock-free
assertion A16 : Data is deadlock-free
assertion A17 : Ends is deadlock-free in the failures model
untimed assertion A18 : Quick refines Slow in the traces model
untimed assertion A19 : Slow refines Quick
timed assertion A20 : Waits refines Slow in the traces model
timed assertion A21 : Waits is deadlock-free
timed assertion A22 : event b is not missed in Choices for 2 time units
untimed csp Quick associated to Slow csp-begin
Quick = Slow::a.in?x -> (Slow::c.out!x -> Quick [] mine -> STOP)
channel mine
csp-end
timed csp Waits associated to Slow csp-begin
Waits = Slow::a.in?x -> tock -> Slow::c.out!x -> Waits [] tock -> Waits [] Slow::b.in -> Over
Over = tock -> Over
csp-end
)";

TEST(Replay, OfEveryFormOfClaim) {
    const TemporaryFile model("forms.rct", forms);
    const std::string folder = fs::path(model.path()).parent_path().string();
    std::ofstream(folder + "/forms.assertions") << claims;
    Replayed sum;
    replay({folder}, true, sum);
    show("forms", sum);
    expect_no_faults(sum);
    for (const char* kind : {"forbidden", "refusal", "divergence", "deadlock", "nondeterminism", "reached",
                             "terminated", "timelock", "clockNotInitialised", "clockInitialised", "missed"})
        EXPECT_GT(sum.endings[kind], 0U) << kind;
}

TEST(Replay, OfRandomModelsCoreAssertions) {
    Replayed sum;
    std::size_t count = tests::rounds(12);
    std::size_t first = 0;
    if (const char* text = std::getenv("ROBOCHART_SEEDS")) count = std::stoull(text);
    if (const char* text = std::getenv("ROBOCHART_FIRST_SEED")) first = std::stoull(text);
    for (std::size_t seed = first; seed < first + count; ++seed) {
        const TemporaryFile folder("README", "");
        const std::string path = fs::path(folder.path()).parent_path().string();
        const std::string error =
            random_models::write(random_models::well_formed(seed, random_models::Shape::timed_core()), path);
        ASSERT_EQ(error, "");
        if (std::getenv("ROBOCHART_SHOW") != nullptr) std::printf("seed %zu\n", seed), std::fflush(stdout);
        replay({path}, true, sum);
    }
    show("random models", sum);
    expect_no_faults(sum);
    EXPECT_GE(sum.counterexamples, count);
}

TEST(Replay, OfSuitesWhereTheyAre) {
    const fs::path shared = tests::shared_folder();
    if (shared.empty()) GTEST_SKIP() << "no shared material";
    Replayed sum;
    for (const char* suite : {"suite/robotool/accept", "suite/findings/agreeing"}) {
        if (!fs::is_directory(shared / suite)) continue;
        for (const auto& entry : fs::directory_iterator(shared / suite))
            if (entry.is_directory()) replay({entry.path().string()}, true, sum);
    }
    show("suites", sum);
    expect_no_faults(sum);
    EXPECT_GE(sum.counterexamples, 50U);
}

}  // namespace
}  // namespace robochart::app::testing::replay_test
