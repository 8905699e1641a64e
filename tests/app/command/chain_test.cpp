// SPDX-License-Identifier: Apache-2.0
// Tests `simulate` with a scenario that defines a chain: answers, refutation, files, rejected inputs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/app/command.hpp"
#include "tests/contents.hpp"

namespace robochart::app::testing::chain_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

std::string scenario() {
    return tests::read_contents(repository("corpus/foraging/chain.scenario"));
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return at == std::string::npos ? text : text.replace(at, what.size(), with);
}

/// Returns a folder with the scenario and a copy of the model.
Folder folder_with(const std::string& text) {
    return Folder({{"m/foraging.rct", tests::read_contents(repository("corpus/foraging/foraging.rct"))},
                   {"m/chain.scenario", text}});
}

TEST(Chain, AnswersAndLeavesFiles) {
    const Folder folder = folder_with(scenario());
    const Ran ran =
        run({"simulate", folder / "m/chain.scenario", "--trials", "60", "--format", "json", "--out", folder / "out"});
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
    const json found = json::parse(ran.out);
    EXPECT_EQ(found.at("schema"), "robochart-verify/chain/1");
    EXPECT_EQ(found.at("trials"), 60);
    EXPECT_EQ(found.at("states"), 3) << "one robot rests, searches or is on its way home";
    EXPECT_THAT(found.at("proof").get<std::string>(), HasSubstr("states of its semantics"));
    ASSERT_EQ(found.at("answers").size(), 3U);
    for (const json& answer : found.at("answers")) {
        EXPECT_EQ(answer.at("verdict"), "estimated");
        EXPECT_LT(answer.at("low"), answer.at("high"));
        EXPECT_FALSE(answer.at("checks").empty());
    }
    EXPECT_EQ(found.at("files").size(), 5U);
    for (const json& file : found.at("files")) EXPECT_TRUE(std::filesystem::exists(file.get<std::string>()));
    const std::string out = folder / "out/simulation/ForagingChain/";
    EXPECT_THAT(tests::read_contents(out + "chain.csv"), HasSubstr("from,to,count,visits,low,high\n"));
    EXPECT_THAT(tests::read_contents(out + "chain-checks.csv"), HasSubstr("contradicts\n1,0,"));
}

/// The time to return home depends on the distance, and a search takes at most twenty seconds. With steps of five
/// seconds, the state does not determine how long a robot has been in it. A robot that was on its way home five seconds
/// ago cannot be searching now, because it must first rest for five seconds.
TEST(Chain, IsRefutedWhereTheStateSaysTooLittle) {
    const Folder folder = folder_with(
        replaced(replaced(scenario(), "every 60 s", "every 5 s"), "estimate probability homing >= 50 % within",
                 "accept probability homing >= 50 % within 60 s >= 90 % with confidence 95 %\n\testimate "
                 "probability homing >= 50 % within"));
    const Ran ran = run({"simulate", folder / "m/chain.scenario", "--no-pictures", "--trials", "200"});
    EXPECT_EQ(ran.exit, 1) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("9 transitions"));
    EXPECT_THAT(ran.out, HasSubstr("1 excluded: what 5 time units of foraging::Robot admit"));
    EXPECT_THAT(ran.out, HasSubstr("REFUTED"));
    EXPECT_THAT(ran.out, HasSubstr("refuted: the chain is no abstraction here"));
}

/// What the model admits in one time unit must not exclude what the code does in several.
TEST(Chain, SeveralTimeUnitsInAStepExcludeNothing) {
    const Folder folder = folder_with(replaced(scenario(), "unit 1 s", "unit 0.5 s"));
    const Ran ran = run({"simulate", folder / "m/chain.scenario", "--no-pictures", "--trials", "30"});
    EXPECT_NE(ran.exit, 2) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr(" 0 excluded: several time units pass in a control step"));
}

/// With few trials, the claim about the decision of the corpus (best_of_n) stays undecided, and no test refutes the
/// chain.
TEST(Chain, OfTheDecisionIsNotRefuted) {
    const Ran ran =
        run({"simulate", repository("corpus/best_of_n/chain.scenario"), "--no-pictures", "--trials", "200"});
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("nothing shows that what follows a state depends on the one before it"));
    EXPECT_THAT(ran.out, HasSubstr("fresh trials do not contradict the chain at 13 times"));
}

/// The chain does not observe the robots that say B. So it cannot distinguish the start from a state in which all
/// robots say B, although their next states differ.
TEST(Chain, WithTooFewObservationsIsRefutedByTheOrderTest) {
    std::string text = tests::read_contents(repository("corpus/best_of_n/chain.scenario"));
    text.erase(text.find("abstract by"));
    text += "abstract by surveys_a, says_a, surveys_b every 10 s estimate average says_a with confidence 95 % }\n";
    const Folder folder({{"m/best_of_n.rct", tests::read_contents(repository("corpus/best_of_n/best_of_n.rct"))},
                         {"m/chain.scenario", text}});
    const Ran ran =
        run({"simulate", folder / "m/chain.scenario", "--no-pictures", "--trials", "400", "--format", "json"});
    EXPECT_EQ(ran.exit, 1) << ran.out << ran.err;
    const json found = json::parse(ran.out);
    EXPECT_EQ(found.at("answers")[0].at("verdict"), "refuted");
    const json& order = found.at("order");
    EXPECT_TRUE(order.at("less").at("before") == "start" || order.at("more").at("before") == "start") << order;
    EXPECT_LT(order.at("less").at("high"), order.at("more").at("low"));
}

TEST(Chain, OptionsOfTrialsThatAreWatchedAreRefused) {
    const Folder folder = folder_with(scenario());
    for (const std::vector<std::string>& option :
         {std::vector<std::string>{"--html", "a.html"}, {"--log", "logs"}, {"--monitor"}}) {
        std::vector<std::string> command{"simulate", folder / "m/chain.scenario", "--trials", "2"};
        command.insert(command.end(), option.begin(), option.end());
        const Ran ran = run(command);
        EXPECT_EQ(ran.exit, 4) << ran.err;
        EXPECT_THAT(ran.err, HasSubstr(option.front() + " takes a scenario without a chain"));
    }
}

/// If a limit ends a trial, the answer stays open.
TEST(Chain, LimitsAreObeyed) {
    const Folder folder = folder_with(replaced(scenario(), "duration 600 s", "duration 100000 s"));
    const Ran ran =
        run({"simulate", folder / "m/chain.scenario", "--no-pictures", "--trials", "10000", "--timeout", "3"});
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("time limit"));
}

}  // namespace
}  // namespace robochart::app::testing::chain_test
