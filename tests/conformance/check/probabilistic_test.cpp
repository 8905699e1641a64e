// SPDX-License-Identifier: Apache-2.0
// Tests probabilistic junctions. In the semantics they are a nondeterministic choice. In the code the platform draws
// the alternative, and the check explores all alternatives.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "tests/conformance/bench.hpp"

namespace robochart::conformance {
namespace {

constexpr const char* text = R"(
stm S {
    event go
    event left
    event right
    initial i
    probabilistic p
    state Waiting { }
    state Left { entry left }
    state Right { entry right }
    transition t0 { from i to Waiting }
    transition t1 { from Waiting to p trigger go }
    transition t2 { from p to Left probability 0.75 }
    transition t3 { from p to Right probability 0.25 }
    transition t4 { from Left to Waiting trigger go }
    transition t5 { from Right to Waiting trigger go }
}
)";

/// The model writes probabilities in all forms: quotients, constants, the remainder to one.
TEST(Probabilistic, ChancesAreExpressions) {
    const std::string model_text(text);
    const std::pair<const char*, const char*> chances[] = {
        {"1/2", "1/2"}, {"q", "1 - q"}, {"3/4", "1 - 3/4"}, {"q * 0.5", "1 - q * 0.5"}, {"1", "0"}};
    for (const auto& [first, second] : chances) {
        std::string changed = model_text;
        changed.replace(changed.find("0.75"), 4, first);
        changed.replace(changed.find("0.25"), 4, second);
        changed.replace(changed.find("event go"), 8, "const q : real = 0.5 event go");
        test::Model model(test::ModelFolder(changed).path());
        test::Bench bench(model, model.machine_named("S"));
        const Result result = bench.check_code();
        EXPECT_EQ(result.outcome, Outcome::conforms) << first << " and " << second << ": " << result.reason;
        EXPECT_GE(result.code_states, 3U);
    }
}

TEST(Probabilistic, EveryWayIsExplored) {
    test::Model model(test::ModelFolder(text).path());
    test::Bench bench(model, model.machine_named("S"));
    const Result right = bench.check_code();
    EXPECT_EQ(right.outcome, Outcome::conforms) << right.reason;
    EXPECT_GE(right.code_states, 3U);  // Waiting, Left and Right
    // The check detects every transition with a wrong target, also the less probable alternative of the junction. The
    // exception is `go`: with a wrong target it may lead directly to a state after the junction, which is an allowed
    // alternative.
    std::size_t found = 0;
    for (std::uint32_t site = 0; site < bench.site_count(cpp_emit::Fault::wrong_target); ++site)
        found += bench.check_code(cpp_emit::Fault::wrong_target, site).outcome == Outcome::differs ? 1U : 0U;
    EXPECT_EQ(found, 5U);
}

}  // namespace
}  // namespace robochart::conformance
