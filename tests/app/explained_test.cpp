// SPDX-License-Identifier: Apache-2.0
// Tests how `conform` explains, as text and as JSON, that a model cannot run in control cycles. Also tests its further
// notes.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/command.hpp"

namespace robochart::app::testing::explained_test {
namespace {

using ::testing::HasSubstr;

const std::string blinks =
    "stm M {\n event go event x : nat\n initial i state Idle { } state B { entry x!1 }\n"
    " transition t0 { from i to Idle }\n transition t1 { from Idle to B trigger go }\n";

TEST(Explained, NotSchedulableWithCodePlaceAndRemedy) {
    const TemporaryFile model("m.rct", blinks + " transition t2 { from B to B }\n}\n");
    const Ran text = run({"conform", model.path()});
    EXPECT_EQ(text.exit, 1) << text.err;
    EXPECT_THAT(text.out, HasSubstr("NOT SCHEDULABLE M"));
    EXPECT_THAT(text.out, HasSubstr("[RC-K02]\n"));
    EXPECT_THAT(text.out, HasSubstr("t2: B -> B ("));
    EXPECT_THAT(text.out, HasSubstr("m.rct:6)"));
    EXPECT_THAT(text.out, HasSubstr("to make it schedulable: give t2: B -> B an action that takes time"));
    EXPECT_THAT(text.out, HasSubstr("see `robochart-verify explain RC-K02`"));

    const Ran data = run({"conform", model.path(), "--format", "json"});
    EXPECT_EQ(data.exit, 1);
    const auto one = nlohmann::json::parse(data.out).at("conformance").at(0);
    EXPECT_EQ(one.at("outcome"), "not schedulable");
    EXPECT_EQ(one.at("code"), "RC-K02");
    EXPECT_FALSE(one.at("explanation").at("where").empty());
    EXPECT_THAT(one.at("explanation").at("remedy").get<std::string>(), HasSubstr("t2: B -> B"));
    EXPECT_EQ(one.at("registerCycles").at("code"), "RC-K07");
    EXPECT_THAT(one.at("registerCycles").at("meaning").get<std::string>(), HasSubstr("are lost"));
}

// Three cycles pass during a wait of four units, so events can be missed. The note on them changes neither the outcome
// nor the exit code.
TEST(Explained, EventsThatCanBeMissedChangeNoExitCode) {
    const TemporaryFile model("m.rct", blinks +
                                           " state C { entry wait(4) }\n transition t2 { from B to C }\n transition t3 "
                                           "{ from C to B trigger go }\n}\n");
    const Ran text = run({"conform", model.path()});
    EXPECT_EQ(text.exit, 0) << text.out << text.err;
    EXPECT_THAT(
        text.out,
        HasSubstr("event go can be missed for 3 cycles while the machine is busy: enters M::C (m.rct:6) [RC-K09]\n"));
    const Ran data = run({"conform", model.path(), "--format", "json"});
    const auto missed = nlohmann::json::parse(data.out).at("conformance").at(0).at("missedEvents");
    ASSERT_EQ(missed.size(), 1U);
    EXPECT_EQ(missed[0].at("event"), "go");
    EXPECT_EQ(missed[0].at("code"), "RC-K09");
    EXPECT_EQ(missed[0].at("reasons").at(0).at("while"), "busy");
    EXPECT_EQ(missed[0].at("cycles"), 3);
    EXPECT_EQ(missed[0].at("reasons").at(0).at("places"), (nlohmann::json{"enters M::C (m.rct:6)"}));
}

// An outer state has a transition with `stop`, and its inner state has one with `go`. If both events come in one cycle,
// the code takes `go` first and `stop` second.
TEST(Explained, EventsThatComeSecondChangeNoExitCode) {
    const TemporaryFile model("m.rct",
                              "interface I { halt() brake() }\nstm M {\n requires I\n event go event stop\n initial i\n"
                              " state A { initial j\n  state B { }\n  state C { entry halt() }\n"
                              "  transition a { from j to B }\n  transition b { from B to C trigger go }\n }\n"
                              " state D { entry brake() }\n transition t0 { from i to A }\n"
                              " transition t1 { from A to D trigger stop }\n}\n");
    const Ran text = run({"conform", model.path()});
    EXPECT_EQ(text.exit, 0) << text.out << text.err;
    EXPECT_THAT(text.out, HasSubstr("event stop comes second in a cycle: after go, in M::A::B (m.rct:7) [RC-K10]\n"));
    const Ran data = run({"conform", model.path(), "--format", "json"});
    const auto overtaken = nlohmann::json::parse(data.out).at("conformance").at(0).at("overtakenEvents");
    ASSERT_EQ(overtaken.size(), 1U);
    EXPECT_EQ(overtaken[0].at("event"), "stop");
    EXPECT_EQ(overtaken[0].at("code"), "RC-K10");
    EXPECT_EQ(overtaken[0].at("by"), (nlohmann::json{"go"}));
    EXPECT_EQ(overtaken[0].at("due"), false);
    EXPECT_EQ(overtaken[0].at("places"), (nlohmann::json{"M::A::B (m.rct:7)"}));
}

TEST(Explained, EachCodeHasAPage) {
    for (int i = 1; i <= 10; ++i) {
        const Ran page = run({"explain", fmt::format("RC-K{:02}", i)});
        EXPECT_EQ(page.exit, 0);
        EXPECT_THAT(page.out, HasSubstr("control cycles"));
    }
}

}  // namespace
}  // namespace robochart::app::testing::explained_test
