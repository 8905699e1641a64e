// SPDX-License-Identifier: Apache-2.0
// Tests formulas on handwritten runs. Random formulas are compared with the definitions of the operators on the whole
// run.
#include "simulation/trial/formulas.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "simulation/scenario/read_scenario.hpp"
#include "simulation/world/random.hpp"

namespace robochart::simulation {
namespace {

/// Returns a scenario of five control steps of one second, with measures a and b and a claim with this property.
Scenario with_property(const std::string& property) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const std::string text =
        "scenario S for M { step 1 s physics 1 s unit 1 s duration 5 s arena 1 m by 1 m "
        "robots 1 { place at (0 cm, 0 cm) heading 0 deg } "
        "measure a is second_moment measure b is second_moment "
        "accept probability " +
        property + " >= 50 % with confidence 90 % }";
    Scenario scenario = read_scenario(sources, sources.add("s.scenario", text), diagnostics);
    std::string findings;
    for (const auto& finding : diagnostics.sorted_findings()) findings += finding.message() + "\n";
    EXPECT_EQ(findings, "") << property;
    return scenario;
}

/// The values of each measure after 0, 1, ... steps.
using Values = std::vector<std::vector<double>>;

MeasureNow at(const Values& run, std::uint64_t step) {
    return [&run, step](std::size_t measure) { return run[measure][step]; };
}

/// Returns the formula's value, and after how many steps it is known: "true 3".
std::string answer(const std::string& property, const Values& run) {
    const Scenario scenario = with_property(property);
    if (scenario.claims.size() != 1) return "";
    Property watched(scenario.claims.front().property, 1, 5);
    for (std::uint64_t step = 0; step <= 5; ++step)
        if (watched.is_due(step)) watched.evaluate_at(step, at(run, step));
    if (!watched.answer().holds) return "open";
    return (*watched.answer().holds ? "true " : "false ") + std::to_string(watched.answer().step);
}

const Values up_and_down{{0, 1, 2, 1, 0, 0}, {5, 4, 3, 2, 1, 0}};

TEST(Formulas, AreKnownAsEarlyAsTheyCanBe) {
    EXPECT_EQ(answer("a >= 2 within 4 s", up_and_down), "true 2");
    EXPECT_EQ(answer("a >= 2 within 2 s", up_and_down), "true 2") << "the limit counts";
    EXPECT_EQ(answer("a >= 2 within 1 s", up_and_down), "false 1") << "known at the limit";
    EXPECT_EQ(answer("a >= 3 within 4 s", up_and_down), "false 4");
    EXPECT_EQ(answer("always b >= 2", up_and_down), "false 4");
    EXPECT_EQ(answer("always b >= 0", up_and_down), "true 5");
    EXPECT_EQ(answer("a in 1 to 1 at 3 s", up_and_down), "true 3");
    EXPECT_EQ(answer("a at 3 s <= 0", up_and_down), "false 3");
    EXPECT_EQ(answer("b <= 0", up_and_down), "true 5") << "by itself about the end";
    EXPECT_EQ(answer("b <= 0 at end", up_and_down), "true 5");
}

TEST(Formulas, Until) {
    EXPECT_EQ(answer("b >= 3 until a >= 2", up_and_down), "true 2");
    EXPECT_EQ(answer("b >= 4 until a >= 2", up_and_down), "true 2") << "not needed at the end itself";
    EXPECT_EQ(answer("b >= 5 until a >= 2", up_and_down), "false 1");
    EXPECT_EQ(answer("b >= 0 until a >= 3", up_and_down), "false 5") << "the end must come";
    EXPECT_EQ(answer("b >= 3 until a >= 2 within 1 s", up_and_down), "false 1");
    EXPECT_EQ(answer("a >= 9 until b >= 5", up_and_down), "true 0");
}

TEST(Formulas, StaysForAndTheFirstTimeOfAConjunction) {
    EXPECT_EQ(answer("a >= 1 stays for 2 s within 5 s", up_and_down), "true 3") << "from 1 to 3";
    EXPECT_EQ(answer("a >= 1 stays for 3 s within 5 s", up_and_down), "false 5");
    EXPECT_EQ(answer("(a >= 1 and b <= 3) within 5 s", up_and_down), "true 2");
    EXPECT_EQ(answer("((a >= 1 and b <= 3) stays for 1 s) within 5 s", up_and_down), "true 3");
    EXPECT_EQ(answer("a <= 0 stays for 1 s at 4 s", up_and_down), "false 4") << "only since 4";
    EXPECT_EQ(answer("a <= 0 stays for 1 s at 5 s", up_and_down), "true 5");
}

TEST(Formulas, ConnectivesDecideEarly) {
    EXPECT_EQ(answer("a >= 2 within 4 s or b <= 0 at end", up_and_down), "true 2");
    EXPECT_EQ(answer("a >= 2 within 1 s and b <= 0 at end", up_and_down), "false 1");
    EXPECT_EQ(answer("a >= 2 within 4 s and b <= 0 at end", up_and_down), "true 5");
    EXPECT_EQ(answer("not (a >= 2 within 4 s)", up_and_down), "false 2");
    EXPECT_EQ(answer("(not a >= 2) within 4 s", up_and_down), "true 0");
    EXPECT_EQ(answer("(a >= 2 within 1 s or a >= 1 within 1 s) and not (b <= 1 within 3 s)", up_and_down), "true 3");
}

TEST(Formulas, WhatATrialThatStopsLeavesOpenIsTaken) {
    const Scenario scenario = with_property("a >= 2 within 4 s");
    Property watched(scenario.claims.front().property, 1, 5);
    watched.evaluate_at(0, at(up_and_down, 0));
    watched.end(1, false);
    EXPECT_EQ(watched.answer(), (Answer{false, 1, true}));
    Property decided(scenario.claims.front().property, 1, 5);
    for (std::uint64_t step = 0; step <= 2; ++step) decided.evaluate_at(step, at(up_and_down, step));
    decided.end(3, false);
    EXPECT_EQ(decided.answer(), (Answer{true, 2, false})) << "what is known stays";
}

// ---------------------------------------------------------------- comparison with the definitions

using Kind = Formula::Kind;

/// Returns the value at one instant of a whole run, by definition.
bool defined(const Formula& f, const Values& run, std::size_t t) {
    switch (f.kind) {
        case Kind::compare:
            return f.low <= run[f.measure][t] && run[f.measure][t] <= f.high;
        case Kind::stays: {
            const auto span = static_cast<std::size_t>(f.time);
            if (t < span) return false;
            for (std::size_t i = t - span; i <= t; ++i)
                if (!defined(f.parts[0], run, i)) return false;
            return true;
        }
        case Kind::negation:
            return !defined(f.parts[0], run, t);
        case Kind::both:
            return defined(f.parts[0], run, t) && defined(f.parts[1], run, t);
        case Kind::either:
            return defined(f.parts[0], run, t) || defined(f.parts[1], run, t);
        case Kind::at:
        case Kind::within:
        case Kind::until:
        case Kind::always:
            break;
    }
    throw std::logic_error("a condition on a trial");
}

/// Returns the value for the whole run, by definition.
bool defined(const Formula& f, const Values& run) {
    const std::size_t last = std::isinf(f.time) ? 5 : static_cast<std::size_t>(f.time);
    switch (f.kind) {
        case Kind::at:
            return defined(f.parts[0], run, last);
        case Kind::within:
            for (std::size_t t = 0; t <= last; ++t)
                if (defined(f.parts[0], run, t)) return true;
            return false;
        case Kind::always:
            for (std::size_t t = 0; t <= last; ++t)
                if (!defined(f.parts[0], run, t)) return false;
            return true;
        case Kind::until:
            for (std::size_t end = 0; end <= last; ++end) {
                bool before = true;
                for (std::size_t t = 0; t < end; ++t) before = before && defined(f.parts[0], run, t);
                if (before && defined(f.parts[1], run, end)) return true;
            }
            return false;
        case Kind::negation:
            return !defined(f.parts[0], run);
        case Kind::both:
            return defined(f.parts[0], run) && defined(f.parts[1], run);
        case Kind::either:
            return defined(f.parts[0], run) || defined(f.parts[1], run);
        case Kind::compare:
        case Kind::stays:
            break;
    }
    throw std::logic_error("a condition on an instant");
}

class RandomFormula {
public:
    explicit RandomFormula(std::uint64_t seed) : random_(seed) {}

    Formula instant(int depth) {
        Formula f;
        const std::uint64_t choice = depth == 0 ? 0 : random_.next() % 5;
        if (choice == 0) {
            f.measure = random_.next() % 2;
            f.low = static_cast<double>(random_.next() % 3);
            f.high = f.low + static_cast<double>(random_.next() % 2);
            return f;
        }
        f.kind = std::array{Kind::compare, Kind::stays, Kind::negation, Kind::both, Kind::either}[choice];
        f.time = static_cast<double>(random_.next() % 3);
        for (std::size_t i = 0; i < (choice < 3 ? 1U : 2U); ++i) f.parts.push_back(instant(depth - 1));
        return f;
    }
    Formula trial(int depth) {
        Formula f;
        const std::uint64_t choice = random_.next() % (depth == 0 ? 4 : 7);
        f.kind = std::array{
            Kind::at, Kind::within, Kind::always, Kind::until, Kind::negation, Kind::both, Kind::either}[choice];
        f.time = random_.next() % 2 == 0 || f.kind == Kind::always ? INFINITY : static_cast<double>(random_.next() % 6);
        const std::size_t parts = f.kind == Kind::until || f.kind == Kind::both || f.kind == Kind::either ? 2 : 1;
        for (std::size_t i = 0; i < parts; ++i) f.parts.push_back(choice < 4 ? instant(2) : trial(depth - 1));
        return f;
    }
    Values run() {
        Values run(2);
        for (auto& values : run)
            for (int t = 0; t <= 5; ++t) values.push_back(static_cast<double>(random_.next() % 4));
        return run;
    }

private:
    Random random_;
};

TEST(Formulas, RandomOnesAreAsTheirOperatorsAreDefined) {
    std::size_t early = 0;
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        RandomFormula random(seed);
        const Formula formula = random.trial(2);
        const Values run = random.run();
        Property watched(formula, 1, 5);
        for (std::uint64_t step = 0; step <= 5; ++step)
            if (watched.is_due(step)) watched.evaluate_at(step, at(run, step));
        ASSERT_TRUE(watched.answer().holds) << seed;
        EXPECT_EQ(*watched.answer().holds, defined(formula, run)) << seed;
        early += watched.answer().step < 5 ? 1U : 0U;
        // Later values do not change an answer that is known.
        Values other = run;
        const Values later = random.run();
        for (std::size_t m = 0; m < 2; ++m)
            for (std::size_t t = watched.answer().step + 1; t <= 5; ++t) other[m][t] = later[m][t];
        EXPECT_EQ(*watched.answer().holds, defined(formula, other)) << seed;
    }
    EXPECT_GT(early, 1000U);
}

}  // namespace
}  // namespace robochart::simulation
