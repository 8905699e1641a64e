// SPDX-License-Identifier: Apache-2.0
// Tests `check --sizes`, which prints the sizes of the components' processes. The expected numbers are counted by hand
// here.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/command.hpp"

namespace robochart::app::testing::sizes_test {
namespace {

using ::testing::HasSubstr;

// The untimed D__ has five states and five transitions: the initial node, then A and B, each entered by a hidden event.
// They form a line that ends in a ring of four states. O__ is the ring of a and b after the uncompressed call. A
// process is compressed when its transitions are first computed, so the first state is not in the ring.
constexpr const char* machine = R"(stm S {
  event a event b
  initial i
  state A { }
  state B { }
  transition t0 { from i to A }
  transition t1 { from A to B trigger a }
  transition t2 { from B to A trigger b }
}
)";

nlohmann::json sizes(const std::vector<std::string>& options) {
    const TemporaryFile model("sizes.rct", machine);
    std::vector<std::string> arguments{"check", model.path(), "--sizes", "--format", "json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Ran ran = run(arguments);
    const auto report = nlohmann::json::parse(ran.out, nullptr, false);
    EXPECT_FALSE(report.is_discarded()) << ran.out << ran.err;
    return report.is_discarded() ? nlohmann::json::array() : report["sizes"];
}

TEST(Sizes, AreThoseOfTheProcesses) {
    const auto all = sizes({"--untimed"});
    ASSERT_EQ(all.size(), 1U) << all;
    EXPECT_EQ(all[0]["component"], "S");
    EXPECT_EQ(all[0]["time"], "untimed");
    EXPECT_EQ(all[0]["process"], nlohmann::json({{"states", 5}, {"transitions", 5}, {"whole", true}}));
    EXPECT_EQ(all[0]["compressed"], nlohmann::json({{"states", 3}, {"transitions", 3}, {"whole", true}}));
}

TEST(Sizes, SayWhereALimitWasReached) {
    const auto all = sizes({"--untimed", "--max-states", "3"});
    ASSERT_EQ(all.size(), 1U) << all;
    EXPECT_EQ(all[0]["process"]["whole"], false);
    EXPECT_LE(all[0]["process"]["states"], 5);
}

TEST(Sizes, AreInTheText) {
    const TemporaryFile model("sizes.rct", machine);
    const Ran ran = run({"check", model.path(), "--sizes"});
    EXPECT_THAT(ran.out, HasSubstr("sizes of the components, as they are and compressed"));
    EXPECT_THAT(ran.out, HasSubstr("untimed S "));
    EXPECT_THAT(ran.out, HasSubstr("timed   S "));
}

}  // namespace
}  // namespace robochart::app::testing::sizes_test
