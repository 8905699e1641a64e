// SPDX-License-Identifier: Apache-2.0
// Tests the public functions of the library: what they load, decide and report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "driver/robochart_verify.hpp"

namespace robochart::verify {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A robot that continues after an obstacle, at most `most` times.
const char* const patrol_model = R"(interface Sensors { event obstacle event clear }
interface Motors { drive() halt() }
stm Patrol {
    uses Sensors requires Motors
    const most : nat
    var stops : nat = 0
    initial start
    state Driving { entry drive() }
    state Waiting { entry halt() }
    transition begin { from start to Driving }
    transition blocked { from Driving to Waiting trigger obstacle action stops = stops + 1 }
    transition freed { from Waiting to Driving trigger clear condition stops < most }
}
)";

const char* const claims =
    "untimed assertion Live : Patrol is deadlock-free\n"
    "untimed assertion Waits : Patrol::Waiting is reachable in Patrol\n";

LoadOptions most(const std::string& value) {
    LoadOptions options;
    options.constants["most"] = value;
    return options;
}

LoadResult load(const std::string& assertions, const std::string& value = "2") {
    return load_texts({{"patrol.rct", patrol_model}, {"patrol.assertions", assertions}}, most(value));
}

std::vector<std::string> verdicts(const CheckResult& result) {
    std::vector<std::string> words;
    for (const Answer& answer : result.answers) words.emplace_back(name_of(answer.verdict));
    return words;
}

TEST(Library, ListsTheClaimsOfAModel) {
    const LoadResult loaded = load(claims);
    ASSERT_TRUE(loaded.model) << loaded.text;
    const std::vector<Claim>& listed = loaded.model->claims();
    ASSERT_EQ(listed.size(), 2U);
    EXPECT_EQ(listed[0].name, "Live");
    EXPECT_EQ(listed[1].name, "Waits");
    ASSERT_TRUE(listed[1].place);
    EXPECT_EQ(listed[1].place->file, "patrol.assertions");
    EXPECT_EQ(listed[1].place->line, 2U);
}

TEST(Library, DecidesClaimsAndShowsTheRunOfOneThatFails) {
    LoadResult loaded = load(claims);
    ASSERT_TRUE(loaded.model) << loaded.text;
    const CheckResult result = loaded.model->check();
    EXPECT_THAT(verdicts(result), ElementsAre("fails", "holds"));
    EXPECT_FALSE(result.all_hold());
    const Answer& live = result.answers.front();
    EXPECT_EQ(live.title, "Live [untimed] Patrol is deadlock-free");
    ASSERT_TRUE(live.run);
    EXPECT_FALSE(live.run->timed);
    EXPECT_FALSE(live.run->loop_start);
    std::vector<std::string> inputs;
    for (const Step& step : live.run->steps)
        if (step.text.starts_with("input ")) inputs.push_back(step.text.substr(0, step.text.find(" (")));
    EXPECT_THAT(inputs, ElementsAre("input obstacle", "input clear", "input obstacle"));
    ASSERT_EQ(live.run->steps.back().machines.size(), 1U);
    const Machine& machine = live.run->steps.back().machines.front();
    EXPECT_EQ(machine.text, "in Waiting");
    ASSERT_EQ(machine.variables.size(), 1U);
    EXPECT_EQ(machine.variables.front().name, "stops");
    EXPECT_EQ(machine.variables.front().value, "2");
    EXPECT_THAT(live.text, HasSubstr("input obstacle"));
}

TEST(Library, ConstantsAreThoseOfTheOptions) {
    LoadResult loaded = load(claims, "1");
    ASSERT_TRUE(loaded.model) << loaded.text;
    const CheckResult result = loaded.model->check({"Live"});
    ASSERT_EQ(result.answers.size(), 1U);
    ASSERT_TRUE(result.answers.front().run);
    const auto& steps = result.answers.front().run->steps;
    EXPECT_EQ(std::ranges::count_if(steps, [](const Step& step) { return step.text.starts_with("input "); }), 1);
}

TEST(Library, DecidesOnlySelectedClaims) {
    LoadResult loaded = load(claims);
    ASSERT_TRUE(loaded.model) << loaded.text;
    const CheckResult result = loaded.model->check({"W*"});
    EXPECT_THAT(verdicts(result), ElementsAre("holds"));
    EXPECT_TRUE(result.all_hold());
}

TEST(Library, ReportsAWordThatSelectsNoClaim) {
    LoadResult loaded = load(claims);
    ASSERT_TRUE(loaded.model) << loaded.text;
    const CheckResult result = loaded.model->check({"Wait"});
    EXPECT_THAT(result.answers, IsEmpty());
    ASSERT_EQ(result.findings.size(), 1U);
    EXPECT_THAT(result.findings.front().message, HasSubstr("did you mean 'Waits'?"));
    EXPECT_FALSE(result.all_hold());
}

TEST(Library, AnswersAreTheSameInEveryCheck) {
    LoadResult loaded = load(claims);
    ASSERT_TRUE(loaded.model) << loaded.text;
    const CheckResult first = loaded.model->check();
    const CheckResult second = loaded.model->check();
    EXPECT_EQ(verdicts(first), verdicts(second));
    EXPECT_EQ(first.answers.front().text, second.answers.front().text);
    EXPECT_EQ(first.findings.size(), second.findings.size());
}

TEST(Library, DecidesCorePropertiesIfAModelClaimsNothing) {
    LoadResult loaded = load_texts({{"patrol.rct", patrol_model}}, most("2"));
    ASSERT_TRUE(loaded.model) << loaded.text;
    EXPECT_THAT(loaded.model->claims(), IsEmpty());
    const CheckResult result = loaded.model->check();
    EXPECT_FALSE(result.answers.empty());
    EXPECT_FALSE(result.all_hold()) << "it stops after the second obstacle";
}

TEST(Library, AModelWithErrorsIsNotLoaded) {
    const LoadResult loaded =
        load_texts({{"wrong.rct", "stm S {\n\tinitial i\n\ttransition t { from i to Nowhere }\n}\n"}});
    EXPECT_FALSE(loaded.model);
    const auto error = std::ranges::find(loaded.findings, Severity::error, &Finding::severity);
    ASSERT_NE(error, loaded.findings.end());
    EXPECT_FALSE(error->code.empty());
    EXPECT_THAT(loaded.text, HasSubstr("wrong.rct"));
}

TEST(Library, AMissingFileIsAFinding) {
    const LoadResult loaded = load_files({"/nonexistent/model.rct"});
    EXPECT_FALSE(loaded.model);
    ASSERT_FALSE(loaded.findings.empty());
    EXPECT_THAT(loaded.findings.front().message, HasSubstr("/nonexistent/model.rct"));
    EXPECT_FALSE(load_files({}).model);
    EXPECT_FALSE(load_texts({}).model);
}

TEST(Library, AnUnknownConstantIsAFinding) {
    LoadOptions options = most("2");
    options.constants["least"] = "1";
    const LoadResult loaded = load_texts({{"patrol.rct", patrol_model}}, options);
    EXPECT_FALSE(loaded.model);
    ASSERT_FALSE(loaded.findings.empty());
    EXPECT_THAT(loaded.findings.front().message, HasSubstr("least"));
}

// A claim with an error must not be reported as one that holds.
TEST(Library, AClaimWithAnErrorDoesNotHideTheOthers) {
    LoadResult loaded = load(std::string(claims) + "untimed assertion Wrong : Nobody is deadlock-free\n");
    ASSERT_TRUE(loaded.model) << loaded.text;
    EXPECT_EQ(loaded.model->claims().size(), 3U);
    const CheckResult result = loaded.model->check({"Waits", "Wrong"});
    EXPECT_THAT(verdicts(result), ElementsAre("holds", "error"));
    EXPECT_FALSE(result.all_hold());
}

TEST(Library, ALimitLeavesAClaimInconclusive) {
    LoadResult loaded = load(claims);
    ASSERT_TRUE(loaded.model) << loaded.text;
    CheckOptions options;
    options.limits.states = 2;
    const CheckResult result = loaded.model->check({"Live"}, options);
    EXPECT_THAT(verdicts(result), ElementsAre("inconclusive"));
    EXPECT_THAT(result.answers.front().reason, HasSubstr("2 states"));
    EXPECT_FALSE(result.all_hold());
}

TEST(Library, AnInterruptedCheckDecidesNothing) {
    LoadResult loaded = load(claims);
    ASSERT_TRUE(loaded.model) << loaded.text;
    CheckOptions options;
    options.interrupted = [] { return true; };
    const CheckResult result = loaded.model->check(options);
    EXPECT_FALSE(result.limit.empty());
    for (const Answer& answer : result.answers) EXPECT_EQ(answer.verdict, Verdict::inconclusive) << answer.title;
    EXPECT_FALSE(result.all_hold());
    options.interrupted = {};
    EXPECT_THAT(verdicts(loaded.model->check(options)), ElementsAre("fails", "holds")) << "the model is still usable";
}

TEST(Library, AllHoldCountsNoInformativeAnswer) {
    CheckResult result;
    EXPECT_FALSE(result.all_hold()) << "nothing holds";
    result.answers.resize(2);
    result.answers[0].verdict = Verdict::holds;
    result.answers[1].verdict = Verdict::fails;
    EXPECT_FALSE(result.all_hold());
    result.answers[1].information = true;
    EXPECT_TRUE(result.all_hold());
    result.answers[1] = {};
    result.answers[1].verdict = Verdict::no_check;
    EXPECT_TRUE(result.all_hold());
    result.findings.emplace_back();
    EXPECT_FALSE(result.all_hold()) << "there is an error";
}

}  // namespace
}  // namespace robochart::verify
