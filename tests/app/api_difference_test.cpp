// SPDX-License-Identifier: Apache-2.0
// Tests how the report describes a difference between the event API and the cycle API of generated code.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/report/report.hpp"

namespace robochart::app::testing::api_difference_test {
namespace {

using ::testing::HasSubstr;

Report differing() {
    ConformanceReport one;
    one.component = "p::M";
    one.result.outcome = conformance::Outcome::differs;
    one.result.dispatched = 1234;
    one.result.reason = "the event API differs from the cycle: `dispatch` of v = 1: other outputs";
    one.result.cycles.push_back({{"a"}, {"go()"}, "state=A"});
    conformance::ApiDifference difference;
    difference.event = "v = 1";
    difference.what = "`dispatch` of v = 1: other outputs";
    difference.cycle = {{"x(1)", "y()"}, "at rest", "state=B"};
    difference.dispatched = {{"y()"}, "terminated", "state=C"};
    one.result.api_difference = difference;
    Report report;
    report.conformance.push_back(one);
    return report;
}

TEST(ApiDifference, ADifferenceIsReportedSideBySide) {
    const Report report = differing();
    EXPECT_EQ(report.exit_code(), Exit::failed);
    const std::string text = render_text(report, {});
    EXPECT_THAT(text, HasSubstr("DIFFERS"));
    EXPECT_THAT(text, HasSubstr("events dispatched one at a time: 1,234 compared with a cycle\n"));
    EXPECT_THAT(text, HasSubstr("cycle 1   in {a}  out <go()>  state=A\n"
                                "                 then v = 1:\n"
                                "                   step     out <x(1), y()>  at rest  state=B\n"
                                "                   dispatch out <y()>  terminated  state=C\n"));
}

TEST(ApiDifference, ADifferenceIsDataInJson) {
    const auto json = nlohmann::json::parse(render_json(differing())).at("conformance").at(0);
    EXPECT_EQ(json.at("outcome"), "differs");
    EXPECT_EQ(json.at("dispatched"), 1234);
    EXPECT_EQ(json.at("apiDifference").at("event"), "v = 1");
    EXPECT_EQ(json.at("apiDifference").at("step").at("outputs"), (nlohmann::json{"x(1)", "y()"}));
    EXPECT_EQ(json.at("apiDifference").at("dispatch").at("ends"), "terminated");
    EXPECT_EQ(json.at("apiDifference").at("dispatch").at("state"), "state=C");
}

}  // namespace
}  // namespace robochart::app::testing::api_difference_test
