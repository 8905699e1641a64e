// SPDX-License-Identifier: Apache-2.0
// Compares the obligations of rules with docs/rules-language.md, "What rules mean", row by row. Compares the arithmetic
// of windows with an evaluation of the definition on every history.
#include <gtest/gtest.h>

#include "base/diagnostics/splitmix64.hpp"
#include "claims/sleec/obligations/open.hpp"
#include "claims/sleec/obligations/samples.hpp"
#include "tests/claims/sleec/support.hpp"

namespace robochart::sleec {
namespace {

using testing::Read;
using testing::with_definitions;

/// Returns the obligations of the first rule, with the names of the events of with_definitions(): "Stop 0-5 | not Help
/// 5-9".
std::string demands(const std::string& rule, const Valuation& values = {0, 0, 0, 0},
                    WithoutLimit without = WithoutLimit::eventually) {
    Read read(with_definitions("R " + rule));
    if (!read.checked_too().checked) return read.report();
    const auto obligation = obligation_of(read.checked->rules[0], values, without);
    if (!obligation) return "nothing";
    std::string text;
    for (const Demand& demand : obligation->any)
        text += (text.empty() ? "" : " | ") + std::string(demand.forbids ? "not " : "") +
                read.checked->event_name(demand.event) + " " + std::to_string(demand.begin) + "-" +
                (demand.end == forever ? "" : std::to_string(demand.end));
    for (const std::size_t event : obligation->ended_by) text += " unless " + read.checked->event_name(event);
    return text;
}

/// The values are those of near, safe, level, load.
TEST(SleecObligations, FollowTheDefinitions) {
    EXPECT_EQ(demands("when Go then Stop within 5 seconds"), "Stop 0-5");
    EXPECT_EQ(demands("when Go then not Stop within 2 minutes"), "not Stop 0-120");
    EXPECT_EQ(demands("when Go then Stop"), "Stop 0-");
    EXPECT_EQ(demands("when Go then Stop", {}, WithoutLimit::now), "Stop 0-0");
    EXPECT_EQ(demands("when Go then not Stop"), "not Stop 0-");
    EXPECT_EQ(demands("when Go then not Stop", {}, WithoutLimit::now), "not Stop 0-0");
    EXPECT_EQ(demands("when Go then Stop within [2, 5] seconds"), "Stop 2-5");
    EXPECT_EQ(demands("Stop at least 5 seconds after Go"), "not Stop 0-4");
    EXPECT_EQ(demands("Stop at least 0 seconds after Go"), "nothing");
    EXPECT_EQ(demands("when Go and near then Stop"), "nothing");
    EXPECT_EQ(demands("when Go and near then Stop", {1, 0, 0, 0}), "Stop 0-");
    EXPECT_EQ(demands("when Go then Stop unless Halt"), "Stop 0- unless Halt");
}

TEST(SleecObligations, BeginBehindOtherwiseWhereTheLimitEnds) {
    EXPECT_EQ(demands("when Go then Stop within 5 seconds otherwise Alarm within 3 seconds otherwise not Help within 2 "
                      "seconds"),
              "Stop 0-5 | Alarm 5-8 | not Help 8-10");
    EXPECT_EQ(demands("when Go then Stop otherwise Alarm"), "Stop 0-") << "what has no limit is never missed";
    EXPECT_EQ(demands("when Go then Stop otherwise not Stop", {}, WithoutLimit::now), "Stop 0-0 | not Stop 0-0");
}

TEST(SleecObligations, TheLastTrueDefeaterDecides) {
    const std::string rule = "when Go then Stop unless near then Alarm unless safe then Help unless level > 5";
    EXPECT_EQ(demands(rule, {0, 0, 0, 0}), "Stop 0-");
    EXPECT_EQ(demands(rule, {1, 0, 0, 0}), "Alarm 0-");
    EXPECT_EQ(demands(rule, {1, 1, 0, 0}), "Help 0-");
    EXPECT_EQ(demands(rule, {1, 1, 6, 0}), "nothing");
}

/// This is correct where SLEEC-TK has fault 2: a defeater in braces counts.
TEST(SleecObligations, DefeatersNestAsWritten) {
    const std::string rule = "when Go then Alarm within 2 seconds unless near then {Help within 3 seconds unless safe}";
    EXPECT_EQ(demands(rule, {0, 1, 0, 0}), "Alarm 0-2");
    EXPECT_EQ(demands(rule, {1, 0, 0, 0}), "Help 0-3");
    EXPECT_EQ(demands(rule, {1, 1, 0, 0}), "nothing");
    const std::string behind = "when Go then Stop within 2 seconds otherwise {Help unless safe}";
    EXPECT_EQ(demands(behind, {0, 0, 0, 0}), "Stop 0-2 | Help 2-");
    EXPECT_EQ(demands(behind, {0, 1, 0, 0}), "nothing") << "nothing is asked if Stop is missed, so nothing at all";
}

/// This is correct where SLEEC-TK has fault 1: >= on a scale.
TEST(SleecObligations, ScalesAreOrdered) {
    const std::string rule = "when Go and load >= mid then Stop";
    EXPECT_EQ(demands(rule, {0, 0, 0, 0}), "nothing");
    EXPECT_EQ(demands(rule, {0, 0, 0, 1}), "Stop 0-");
    EXPECT_EQ(demands(rule, {0, 0, 0, 2}), "Stop 0-");
}

/// Go needs only two samples. Its condition depends on two measures, but the rule only on the truth of the condition.
TEST(SleecSamples, AreWhatRulesDistinguish) {
    Read read(with_definitions("R1 when Go and level > 3 and near then Stop\nR2 when Halt and safe then Stop"));
    ASSERT_TRUE(read.checked_too().checked);
    const auto go = find_samples(*read.checked, {0, 1}, 0, WithoutLimit::eventually, nullptr);
    ASSERT_EQ(go.size(), 2U);
    EXPECT_FALSE(go[0].obligations[0]);
    EXPECT_TRUE(go[1].obligations[0]);
    EXPECT_FALSE(go[1].obligations[1]) << "its trigger is another";
    EXPECT_GT(go[1].values[2], 3);
}

TEST(SleecSamples, FindValuesBetweenAndAroundConstants) {
    Read read(with_definitions("R when Go and level > 3 and level < 5 then Stop"));
    ASSERT_TRUE(read.checked_too().checked);
    EXPECT_EQ(find_samples(*read.checked, {0}, 0, WithoutLimit::eventually, nullptr).size(), 2U) << "4 is between";
    Read none(with_definitions("R when Go and level > 3 and level < 4 then Stop"));
    ASSERT_TRUE(none.checked_too().checked);
    EXPECT_EQ(find_samples(*none.checked, {0}, 0, WithoutLimit::eventually, nullptr).size(), 1U)
        << "numbers are integers";
}

TEST(SleecSamples, AreNotDecidedWhereTheyCannotBe) {
    Read read(with_definitions("R when Go and ({level} + 1 > 3) then Stop"));
    ASSERT_TRUE(read.checked_too().checked);
    EXPECT_THROW((void)find_samples(*read.checked, {0}, 0, WithoutLimit::eventually, nullptr), NotDecided);
}

// ---------------------------------------------------------------- comparison with the definition

/// Events 0 and 1 occur at seconds 0 to 7. Windows end at 5 or never. A history has one bit for each event and second.
constexpr std::int64_t seconds = 8;
constexpr std::uint32_t histories = 1U << 16U;

bool occurs(std::uint32_t history, std::size_t event, std::int64_t second) {
    return (history >> (static_cast<std::uint32_t>(event) * 8U + static_cast<std::uint32_t>(second)) & 1U) != 0;
}

bool holds(const Demand& demand, std::uint32_t history) {
    bool came = false;
    for (std::int64_t i = demand.begin; i < seconds && i <= demand.end; ++i)
        came = came || occurs(history, *demand.event.begin(), i);
    return came != demand.forbids;
}

bool holds(const Obligation& obligation, std::uint32_t history) {
    for (const Demand& demand : obligation.any)
        if (holds(demand, history)) return true;
    return false;
}

Obligation random_obligation(std::uint64_t& state) {
    const auto below = [&state](std::uint64_t end) { return diagnostics::splitmix64(state) % end; };
    Obligation result;
    for (std::uint64_t i = 1 + below(3); i > 0; --i) {
        Demand demand;
        demand.forbids = below(3) == 0;
        demand.event = below(2);
        demand.begin = static_cast<std::int64_t>(below(5));
        demand.end = below(6) == 0 ? forever : demand.begin + static_cast<std::int64_t>(below(5));
        if (demand.end != forever) demand.end = std::min<std::int64_t>(demand.end, 5);
        result.any.push_back(demand);
    }
    return result;
}

TEST(SleecObligations, ImplyAsTheDefinitionSays) {
    std::uint64_t state = 5;
    int yes = 0;
    for (int round = 0; round < 150; ++round) {
        const Obligation a = random_obligation(state);
        const Obligation b = random_obligation(state);
        bool all = true;
        for (std::uint32_t history = 0; history < histories && all; ++history)
            all = !holds(a, history) || holds(b, history);
        EXPECT_EQ(implies(a, b), all) << "round " << round;
        yes += all ? 1 : 0;
    }
    EXPECT_GT(yes, 10);
}

/// Follows the history second by second. An obligation is fulfilled or violated only if all histories with the same
/// prefix agree.
TEST(SleecObligations, StepAsTheDefinitionSays) {
    std::uint64_t state = 7;
    for (int round = 0; round < 300; ++round) {
        const Obligation obligation = random_obligation(state);
        for (int k = 0; k < 40; ++k) {
            const auto history = static_cast<std::uint32_t>(diagnostics::splitmix64(state) % histories);
            Progress progress;
            Effect effect = Effect::open;
            for (std::int64_t second = 0; second < seconds && effect == Effect::open; ++second) {
                for (std::size_t event = 0; event < 2 && effect == Effect::open; ++event)
                    if (occurs(history, event, second)) effect = take_event(obligation, progress, event);
                if (effect == Effect::open) effect = take_tock(obligation, progress);
            }
            if (effect == Effect::open) continue;  // no finite history decides an obligation without an end
            EXPECT_EQ(effect == Effect::fulfilled, holds(obligation, history)) << "round " << round << ", " << history;
        }
    }
}

}  // namespace
}  // namespace robochart::sleec
