// SPDX-License-Identifier: Apache-2.0
// Tests chains of swarms. States and transitions are counted by hand and robot by robot. The tests also cover claims
// that states do not determine, bounds for swarms that are Markov chains, and the refutation of swarms that are not.
#include "simulation/chain/chain.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "simulation/chain/chain_report.hpp"
#include "simulation/scenario/read_scenario.hpp"

namespace robochart::simulation {
namespace {

using ::testing::HasSubstr;

struct ReadChain {
    explicit ReadChain(const std::string& items, const std::string& robots = "3") {
        const std::string text =
            "scenario S for M { step 1 s physics 1 s unit 1 s duration 12 s trials 300 seed 1 "
            "arena 100 cm by 100 cm light lamp at (0 cm, 0 cm) robots " +
            robots +
            " { place random in arena } measure a is in_state(A) measure b is in_state(B) measure "
            "way is distance(lamp) measure near is reached(lamp, 10 cm) " +
            items + " }";
        scenario = read_scenario(sources, sources.add("s.scenario", text), found);
        // The states have the numbers that the controller gives them.
        for (std::size_t m = 0; m < 2 && m < scenario.measures.size(); ++m)
            scenario.measures[m].states = {static_cast<std::uint16_t>(m)};
        tell();
    }
    void tell() {
        findings.clear();
        for (const auto& finding : found.sorted_findings())
            findings += std::string(finding.rule->code) + " " + finding.message() + "\n";
    }
    /// Returns the report on the claims.
    std::string question_findings() {
        const ChainStates states(scenario, std::nullopt);
        (void)find_chain_questions(scenario, states, found);
        tell();
        return findings;
    }

    diagnostics::SourceManager sources;
    diagnostics::Diagnostics found;
    Scenario scenario;
    std::string findings;
};

const char* const question = " estimate average near with confidence 95 %";

TEST(Abstraction, IsRead) {
    const ReadChain read(
        "abstract by way in 10 cm, 20 cm, near, a in 50 % every 2 s estimate time until near >= 50 % with confidence "
        "90 % "
        "estimate average a with confidence 95 %");
    ASSERT_EQ(read.findings, "");
    const Abstraction& abstraction = *read.scenario.abstraction;
    EXPECT_EQ(abstraction.every, 2);
    ASSERT_EQ(abstraction.distinctions.size(), 3U);
    EXPECT_EQ(abstraction.distinctions[0].levels, (std::vector<double>{10, 20}));
    EXPECT_TRUE(abstraction.distinctions[1].levels.empty());
    EXPECT_EQ(abstraction.distinctions[2].levels, (std::vector<double>{0.5}));
    ASSERT_EQ(read.scenario.chain_questions.size(), 2U);
    EXPECT_TRUE(read.scenario.chain_questions[0].time);
    EXPECT_EQ(read.scenario.chain_questions[1].measure, 0U);
    EXPECT_EQ(read.scenario.chain_questions[0].text, "time until near >= 50 % with confidence 90 %");
}

TEST(Abstraction, WhatIsWrongIsSaid) {
    const auto findings = [](const std::string& items) { return ReadChain(items).findings; };
    EXPECT_THAT(findings("estimate average a with confidence 95 %"), HasSubstr("RC-M04"));
    EXPECT_THAT(findings("abstract by near every 2 s"), HasSubstr("RC-M04"));
    EXPECT_THAT(findings("abstract by way every 2 s estimate average near with confidence 95 %"), HasSubstr("RC-M04"));
    EXPECT_THAT(findings(std::string("abstract by near every 1.5 s") + question), HasSubstr("RC-M13"));
    EXPECT_THAT(findings(std::string("abstract by near every 13 s") + question), HasSubstr("RC-M03"));
    EXPECT_THAT(findings(std::string("abstract by near in 50 %, 20 % every 1 s") + question), HasSubstr("RC-M03"));
    EXPECT_THAT(findings(std::string("abstract by near, near every 1 s") + question), HasSubstr("RC-M05"));
    EXPECT_THAT(findings(std::string("abstract by near in 50 cm every 1 s") + question), HasSubstr("RC-M02"));
    EXPECT_THAT(findings(std::string("abstract by near every 1 s vary robots in 1 to 2") + question),
                HasSubstr("RC-M03"));
    EXPECT_THAT(findings(std::string("abstract by near every 1 s accept each near >= 50 %") + question),
                HasSubstr("a chain, or bands"));
    EXPECT_THAT(findings("abstract by near every 1 s estimate average way with confidence 95 %"), HasSubstr("RC-M03"));
    EXPECT_THAT(findings("abstract by near every 1 s estimate time until always near >= 1 % with confidence 95 %"),
                HasSubstr("RC-M16"));
}

TEST(Abstraction, StatesAnswerOrItIsSaid) {
    const auto codes_of = [](const std::string& items) {
        return ReadChain("abstract by way in 10 cm, 20 cm, a every 2 s " + items).question_findings();
    };
    const std::string tail = " within 4 s with confidence 95 %";
    EXPECT_EQ(codes_of("estimate probability (way <= 10 cm and a >= 40 %)" + tail), "");
    EXPECT_EQ(codes_of("estimate probability (not way <= 20 cm)" + tail), "");
    EXPECT_THAT(codes_of("estimate probability way <= 15 cm" + tail), HasSubstr("RC-M17"));
    EXPECT_THAT(codes_of("estimate probability way >= 10 cm" + tail), HasSubstr("RC-M17"))
        << "10 cm is in the class below";
    EXPECT_THAT(codes_of("estimate probability b >= 50 %" + tail), HasSubstr("RC-M17"));
    EXPECT_THAT(codes_of("estimate probability a >= 50 % stays for 2 s" + tail), HasSubstr("RC-M17"));
    EXPECT_THAT(codes_of("estimate probability a >= 50 % within 3 s with confidence 95 %"),
                HasSubstr("no state at 3 s"));
    EXPECT_THAT(codes_of("estimate probability always a >= 50 % with confidence 95 %"), HasSubstr("RC-M17"));
    EXPECT_THAT(codes_of("estimate average b with confidence 95 %"), HasSubstr("RC-M17"));
    EXPECT_THAT(codes_of("accept probability a >= 50 % within 4 s >= 50 % with confidence 95 %"), "");
    for (const char* number : {"50", "10000"})
        EXPECT_THAT(codes_of("accept probability a >= 50 % within 4 s >= 50 % with confidence 95 %, at most " +
                             std::string(number) + " trials"),
                    HasSubstr("at most N trials"));
}

// ---------------------------------------------------------------- states and transitions

/// Three robots are in A, in B or in neither, which gives ten states, and the initial state.
TEST(ChainStates, AreTheNumbersOfRobots) {
    const ReadChain read(std::string("abstract by a, b every 1 s estimate average a with confidence 95 %"));
    ASSERT_EQ(read.findings, "");
    const ChainStates states(read.scenario, std::nullopt);
    EXPECT_EQ(states.size(), 11U);
    const std::size_t two_one = states.find_state({2.0 / 3, 1.0 / 3});
    ASSERT_NE(two_one, ChainStates::none);
    EXPECT_EQ(states.state_text(two_one), "a 2 of 3, b 1 of 3");
    EXPECT_EQ(states.find_state({2.0 / 3, 2.0 / 3}), ChainStates::none) << "there are no four robots";
    EXPECT_EQ(states.class_of_measure(two_one, 0), (MeasureClass{true, 2, 2, 2.0 / 3, 2.0 / 3}));
    EXPECT_EQ(states.class_of_measure(two_one, 2), std::nullopt);
    for (std::size_t to = 1; to < states.size(); ++to) EXPECT_TRUE(states.permitted_transitions()[two_one][to]);
    EXPECT_FALSE(states.permitted_transitions()[two_one][ChainStates::start]);
}

TEST(ChainStates, HaveLevels) {
    const ReadChain read(
        "abstract by way in 10 cm, 20 cm, a in 40 % every 1 s estimate average a with confidence 95 %");
    ASSERT_EQ(read.findings, "");
    const ChainStates states(read.scenario, std::nullopt);
    EXPECT_EQ(states.size(), 1U + 3 * 2);
    EXPECT_EQ(states.state_text(states.find_state({10, 1.0 / 3})), "way up to 10 cm, a 0 to 1 of 3");
    EXPECT_EQ(states.state_text(states.find_state({10.5, 2.0 / 3})), "way 10 to 20 cm, a 2 to 3 of 3");
    EXPECT_EQ(states.state_text(states.find_state({1e9, 0})), "way above 20 cm, a 0 to 1 of 3");
}

TEST(ChainStates, TooManyAreRefused) {
    const ReadChain many("abstract by a, b, near every 1 s estimate average a with confidence 95 %", "40");
    ASSERT_EQ(many.findings, "");
    EXPECT_THROW(ChainStates(many.scenario, std::nullopt), TooManyStates);
}

/// Robots start in neither state, go to A, then to B, and stay there. The result is compared with all assignments of
/// states to three robots.
TEST(ChainStates, TransitionsAreThoseOfRobots) {
    const ReadChain read("abstract by a, b every 1 s estimate average a with confidence 95 %");
    ASSERT_EQ(read.findings, "");
    const std::vector<std::vector<bool>> after{{false, true, false}, {false, true, true}, {false, false, true}};
    const ChainStates states(read.scenario, RobotSteps{{0, 1, 2}, {true, false, false}, after});
    ASSERT_EQ(states.size(), 11U);
    const auto state = [&](const std::array<std::size_t, 3>& robots) {
        double a = 0;
        double b = 0;
        for (const std::size_t robot : robots) {
            if (robot == 1) ++a;
            if (robot > 1) ++b;
        }
        return states.find_state({a / 3, b / 3});
    };
    statistics::Permitted expected(11, std::vector<bool>(11));
    expected[ChainStates::start][state({0, 0, 0})] = true;
    for (std::size_t before = 0; before < 27; ++before)
        for (std::size_t behind = 0; behind < 27; ++behind) {
            const std::array<std::size_t, 3> from{before % 3, before / 3 % 3, before / 9};
            const std::array<std::size_t, 3> to{behind % 3, behind / 3 % 3, behind / 9};
            if (after[from[0]][to[0]] && after[from[1]][to[1]] && after[from[2]][to[2]])
                expected[state(from)][state(to)] = true;
        }
    EXPECT_EQ(states.permitted_transitions(), expected);
}

/// If a class has no successors because time stops, the class excludes no transition.
TEST(Transitions, NothingIsExcludedWhereTimeStops) {
    const ReadChain read("abstract by a every 1 s estimate average a with confidence 95 %", "1");
    const ChainStates states(read.scenario, RobotSteps{{0, 1}, {true, false}, {{false, true}, {false, false}}});
    const statistics::Permitted permitted = states.permitted_transitions();
    EXPECT_EQ(permitted[1], (std::vector<bool>{false, false, true}));
    EXPECT_EQ(permitted[2], (std::vector<bool>{false, true, true}));
}

/// A limit that is reached ends the search for transitions.
TEST(Transitions, ObeyLimits) {
    const ReadChain read("abstract by a every 1 s estimate average a with confidence 95 %", "1");
    const ChainStates states(read.scenario, RobotSteps{{0, 1}, {true, false}, {{true, true}, {true, true}}});
    diagnostics::Budget budget;
    budget.interrupt();
    EXPECT_THROW(budget.check(), diagnostics::LimitReached);
    EXPECT_THROW((void)states.permitted_transitions(&budget), diagnostics::LimitReached);
}

/// A measure of time is in seconds and does not count robots, so it is not a share.
TEST(States, OfATime) {
    const ReadChain read(
        "measure now is time abstract by now in 2 s every 1 s estimate time until now >= 1 s with confidence 95 %");
    ASSERT_EQ(read.findings, "");
    const ChainStates states(read.scenario, std::nullopt);
    ASSERT_EQ(states.size(), 3U);
    EXPECT_EQ(states.state_text(1), "now up to 2 s");
    EXPECT_EQ(states.state_text(2), "now above 2 s");
    EXPECT_EQ(states.find_state({11}), 2U);
}

// ---------------------------------------------------------------- answers

/// One robot, which may be near the lamp.
const char* const one_robot =
    "abstract by near every 1 s accept probability near >= 100 % within 12 s >= 40 % with confidence 95 % "
    "estimate time until near >= 100 % with confidence 95 % estimate average near with confidence 95 %";

using Draw = std::function<std::vector<double>(std::mt19937_64&)>;

std::vector<ChainAnswer> answered(const Scenario& scenario, const Draw& draw, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::vector<TrialResult> trials(2 * scenario.trials);
    for (TrialResult& trial : trials)
        for (const double sample : draw(random)) trial.samples.push_back({sample});
    const ChainStates states(scenario, std::nullopt);
    diagnostics::Diagnostics found;
    std::vector<Excluded> excluded;
    const auto permitted = states.permitted_transitions();
    const auto sequences = sequences_of(scenario, states, permitted, trials, excluded);
    EXPECT_TRUE(excluded.empty());
    std::vector<ChainAnswer> result;
    for (const ChainAsked& chain_question : find_chain_questions(scenario, states, found))
        result.push_back(chain_answer(scenario, chain_question, permitted, sequences, trials, nullptr));
    EXPECT_TRUE(found.ok());
    return result;
}

/// Returns a run of a robot that comes near with probability 0.1 and leaves with probability 0.3 in each second.
std::vector<double> wanders(std::mt19937_64& random) {
    std::uniform_real_distribution<double> draw(0, 1);
    std::vector<double> seen{0};
    while (seen.size() < 13) {
        const double near = seen.back() == 0 ? 0.1 : 0.7;
        seen.push_back(draw(random) < near ? 1 : 0);
    }
    return seen;
}

/// The robot is near within 12 s with probability 1 - 0.9^12, comes near after 10 s on average, and is near for a
/// quarter of the time in the long run. In at least 95 % of repetitions, all three bounds hold and nothing is refuted.
TEST(ChainAnswer, HoldsOfChainsInNineteenOfTwentyRepetitions) {
    ReadChain read(one_robot, "1");
    ASSERT_EQ(read.findings, "");
    read.scenario.set_trials(60);
    const std::array<double, 3> truth{1 - std::pow(0.9, 12), 10, 0.25};
    std::array<int, 3> good{};
    for (std::uint64_t repetition = 0; repetition < 200; ++repetition) {
        const auto answers = answered(read.scenario, wanders, repetition + 1);
        ASSERT_EQ(answers.size(), 3U);
        for (std::size_t q = 0; q < 3; ++q)
            if (!answers[q].is_refuted() && answers[q].low <= truth[q] && truth[q] <= answers[q].high) ++good[q];
    }
    for (const int count : good) EXPECT_GE(count, 190);
}

TEST(ChainAnswer, ClaimsAreJudged) {
    const ReadChain read(one_robot, "1");
    const auto answers = answered(read.scenario, wanders, 5);
    // 1 - 0.9^12 is 0.72, so 300 trials distinguish it from 0.4.
    EXPECT_EQ(answers[0].claim_verdict(), ClaimVerdict::holds);
    EXPECT_EQ(answers[1].claim_verdict(), ClaimVerdict::estimated);
    EXPECT_GT(answers[1].low, 4);
    EXPECT_LT(answers[1].high, 40);
}

/// In three of five trials the event never comes. Otherwise it comes with probability one half in each second.
TEST(ChainAnswer, WhatIsLockedIsRefuted) {
    const ReadChain read(one_robot, "1");
    const auto locked = [](std::mt19937_64& random) {
        std::uniform_real_distribution<double> draw(0, 1);
        const bool stays = draw(random) < 0.6;
        std::vector<double> seen{0};
        while (seen.size() < 13) seen.push_back(seen.back() == 1 || (!stays && draw(random) < 0.5) ? 1 : 0);
        return seen;
    };
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const auto answers = answered(read.scenario, locked, seed);
        for (std::size_t q = 0; q < 2; ++q) EXPECT_TRUE(answers[q].is_refuted()) << seed;
    }
}

/// The robot leaves after two seconds near the lamp. The chain's state does not contain how long the robot has been
/// there. The share of robots in fresh trials may agree with the chain, but the test of its order fails.
TEST(ChainOrder, WhatLastsForAFixedTimeIsRefuted) {
    const ReadChain read("abstract by near every 1 s estimate average near with confidence 95 %", "1");
    const ChainStates states(read.scenario, std::nullopt);
    diagnostics::Diagnostics found;
    const auto questions = find_chain_questions(read.scenario, states, found);
    const auto finding = [&](const Draw& draw) {
        std::mt19937_64 random(3);
        std::vector<TrialResult> trials(600);
        for (TrialResult& trial : trials)
            for (const double sample : draw(random)) trial.samples.push_back({sample});
        std::vector<Excluded> excluded;
        const auto permitted = states.permitted_transitions();
        return order_finding(questions, permitted, sequences_of(read.scenario, states, permitted, trials, excluded));
    };
    EXPECT_FALSE(finding(wanders));
    const auto lasting = finding([](std::mt19937_64& random) {
        std::uniform_real_distribution<double> draw(0, 1);
        std::vector<double> seen{0};
        while (seen.size() < 13) {
            const bool begun = seen.back() == 1 && (seen.size() < 2 || seen[seen.size() - 2] == 0);
            seen.push_back(begun || (seen.back() == 0 && draw(random) < 0.3) ? 1 : 0);
        }
        return seen;
    });
    ASSERT_TRUE(lasting);
    EXPECT_NEAR(lasting->confidence, 0.95, 1e-12);
    EXPECT_EQ(states.state_text(lasting->found.state), "near 1 of 1")
        << "what is next after it depends on the one before";

    ChainResult result;
    result.questions = 1;
    EXPECT_THAT(order_text(states, result), HasSubstr("not asked"));
    result.order_asked = true;
    EXPECT_THAT(order_text(states, result), HasSubstr("nothing shows"));
    result.order = lasting;
    EXPECT_TRUE(result.has_failed());
    EXPECT_THAT(order_text(states, result), HasSubstr("REFUTED with confidence 95 %"));
    EXPECT_THAT(chain_summary(result), HasSubstr("what follows a state depends on the one before it"));
    ChainAnswer& answer = result.answers.emplace_back();
    answer.of_no_chain = true;
    EXPECT_EQ(answer_word(answer), "REFUTED");
    EXPECT_THAT(answers_text(result), HasSubstr("its order is refuted"));
}

/// If claims have several confidences, the chain is tested at the highest one.
TEST(ChainOrder, HasTheGreatestConfidenceOfTheQuestions) {
    const ReadChain read(
        "abstract by near every 1 s estimate average near with confidence 90 % "
        "estimate time until near >= 100 % with confidence 99 %",
        "1");
    const ChainStates states(read.scenario, std::nullopt);
    diagnostics::Diagnostics found;
    const auto questions = find_chain_questions(read.scenario, states, found);
    ASSERT_EQ(questions.size(), 2U);
    // After each change, the state stays the same for one step. After each step without a change, the state changes.
    const statistics::StateSequence twos{1, 1, 2, 2, 1, 1, 2, 2, 1, 1, 2, 2, 1, 1, 2, 2, 1, 1, 2, 2};
    const std::vector<statistics::StateSequence> all(40, twos);
    const auto finding = order_finding(questions, statistics::all_permitted(states.size()), all);
    ASSERT_TRUE(finding);
    EXPECT_NEAR(finding->confidence, 0.99, 1e-12);
    diagnostics::Budget budget;
    budget.interrupt();
    EXPECT_THROW((void)order_finding(questions, statistics::all_permitted(states.size()), all, &budget),
                 diagnostics::LimitReached);
}

/// A transition of a trial that the model excludes (RC-M18) is reported with its place.
TEST(Sequences, WhatIsExcludedIsFound) {
    const ReadChain read("abstract by a every 1 s estimate average a with confidence 95 %", "1");
    const ChainStates states(read.scenario, RobotSteps{{0, 1}, {true, false}, {{false, true}, {false, true}}});
    std::vector<TrialResult> trials(2);
    trials[0].samples = {{0}, {1}, {1}};
    trials[1].samples = {{0}, {1}, {0}};
    std::vector<Excluded> excluded;
    const auto sequences = sequences_of(read.scenario, states, states.permitted_transitions(), trials, excluded);
    EXPECT_EQ(sequences[0].size(), 4U);
    ASSERT_EQ(excluded.size(), 1U);
    EXPECT_EQ(excluded[0].trial, 1U);
    EXPECT_EQ(excluded[0].time, 2);
    EXPECT_EQ(excluded[0].from, "a 1 of 1");
    EXPECT_EQ(excluded[0].to, "a 0 of 1");
}

/// The report says which values have no bounds and which claims are undecided.
TEST(ChainReport, SaysWhatItIs) {
    ChainResult result;
    result.questions = 2;
    ChainAnswer& answer = result.answers.emplace_back();
    answer.asked.kind = ChainAsked::Kind::time;
    answer.asked.text = "time until x";
    answer.low = 12.34;
    answer.high = std::numeric_limits<double>::infinity();
    EXPECT_THAT(answers_text(result), HasSubstr("at least 12.3 s; no upper bound was found"));
    EXPECT_FALSE(result.is_complete());
    EXPECT_THAT(chain_summary(result), HasSubstr("1 of 2 open"));
    answer.checks.push_back({60, {0.5, 1}, 0.3, {0.2, 0.4}, true});
    EXPECT_TRUE(result.has_failed());
    EXPECT_THAT(answers_text(result), HasSubstr("REFUTED"));
    EXPECT_THAT(answers_text(result), HasSubstr("at 60 s it says between 50 % and 100 %"));
    EXPECT_THAT(chain_summary(result), HasSubstr("refuted: the chain is no abstraction here (1 of 2 answers)"));
}

}  // namespace
}  // namespace robochart::simulation
