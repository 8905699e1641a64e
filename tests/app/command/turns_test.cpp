// SPDX-License-Identifier: Apache-2.0
// Tests the turns of claims: an undecided claim does not delay the others.
#include "driver/claims/turns.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "app/command/run.hpp"
#include "app/report/report.hpp"

namespace robochart::app::turns_test {
namespace {

/// Claims that record their turns. `slow` is never decided before its turn ends.
class Turns {
public:
    explicit Turns(Options options) : options_(std::move(options)), run_(options_) { options_.run = &run_; }

    driver::WaitingClaim decided(const std::string& title) {
        return {title, [this, title](const driver::Turn&) {
                    order.push_back(title);
                    return true;
                }};
    }
    /// Returns a claim that is decided only in an unlimited turn.
    driver::WaitingClaim slow(const std::string& title) {
        return {title, [this, title](const driver::Turn& turn) {
                    order.push_back(title);
                    if (!turn.ends) return true;
                    std::this_thread::sleep_until(*turn.ends);
                    return false;
                }};
    }
    /// Returns a claim that its own limit, such as --max-states, leaves undecided.
    driver::WaitingClaim limited(const std::string& title) {
        return {title, [this, title](const driver::Turn&) {
                    order.push_back(title);
                    return false;
                }};
    }
    void decide(const std::vector<driver::WaitingClaim>& claims) { decide_in_turns(claims, search_context(options_)); }

    std::vector<std::string> order;

private:
    Options options_;
    Run run_;
};

Options within(double seconds, double of_each = 0) {
    Options options;
    options.cache = false;
    options.limits.timeout_seconds = seconds;
    options.limits.assertion_seconds = of_each;
    return options;
}

using Order = std::vector<std::string>;

TEST(Turns, OneThatIsNotDecidedWaitsForTheOthers) {
    Turns turns(within(0.5));
    turns.decide({turns.slow("a"), turns.decided("b"), turns.decided("c")});
    EXPECT_EQ(turns.order, (Order{"a", "b", "c", "a"}));
}

TEST(Turns, ALoneClaimHasOneTurnWithoutEnd) {
    Turns turns(within(0.5));
    turns.decide({turns.decided("a"), turns.slow("b")});
    EXPECT_EQ(turns.order, (Order{"a", "b"}));
}

TEST(Turns, ALimitOfItsOwnIsNotTriedAgain) {
    Turns turns(within(0.5));
    turns.decide({turns.limited("a"), turns.decided("b")});
    EXPECT_EQ(turns.order, (Order{"a", "b"}));
}

TEST(Turns, EndWithTheTimeOfAnAssertion) {
    Turns turns(within(0, 0.02));
    turns.decide({turns.slow("a"), turns.slow("b")});
    EXPECT_EQ(turns.order, (Order{"a", "b"}));
}

TEST(Turns, KeptSearchesHaveOneTurn) {
    Options options = within(0.5);
    options.storage.disk = "kept";
    Turns turns(options);
    turns.decide({turns.slow("a"), turns.decided("b")});
    EXPECT_EQ(turns.order, (Order{"a", "b"}));
}

TEST(Turns, ALimitOfTheRunNamesTheClaim) {
    Turns turns(within(0.01));
    try {
        turns.decide({turns.slow("a"), turns.slow("b"), turns.slow("c"), turns.slow("d"), turns.slow("e"),
                      turns.slow("f"), turns.slow("g"), turns.slow("h"), turns.slow("i"), turns.slow("k"),
                      turns.slow("l"), turns.slow("m")});
        FAIL() << "it has no more time";
    } catch (const diagnostics::LimitReached& limit) {
        EXPECT_TRUE(std::string(limit.what()).starts_with("the time limit was reached while deciding "));
    }
}

TEST(Turns, ReportNamesTheLimitThatEnded) {
    Options options = within(0, 5);
    app::Run run(options);
    options.run = &run;
    driver::SearchContext search = search_context(options);
    search.turn.ends = std::chrono::steady_clock::now();
    EXPECT_EQ(ended_turn("the time limit was reached while compiling", search),
              "its time limit was reached (--assertion-timeout 5) while compiling");
    EXPECT_EQ(ended_turn("the limit of 5 states was reached", search), "the limit of 5 states was reached");
    search.turn.ends.reset();
    EXPECT_EQ(ended_turn("the time limit was reached", search), "the time limit was reached");
}

// If an assertion has used up its time, the advice names the option for assertions, not the one for runs.
TEST(Turns, AdviceNamesTheLimitThatWasMet) {
    const auto advice = [](const std::string& reason, const char* subject = "model") {
        Report report;
        report.subject = subject;
        report.assertions.emplace_back().reason = reason;
        return report.limit_advice();
    };
    EXPECT_TRUE(advice("its time limit was reached (--assertion-timeout 5)")
                    .starts_with("what may help: --assertion-timeout gives each"));
    EXPECT_TRUE(advice("the time limit was reached").starts_with("what may help: --timeout gives more"));
    EXPECT_TRUE(advice("the memory limit of 4 MiB was reached").starts_with("what may help: --disk DIR"));
    EXPECT_EQ(advice("the run was interrupted"), "");
    EXPECT_EQ(advice("the limit of 5 states was reached", "process"), "what may help: --max-states allows more")
        << "scripts have no --range";
}

}  // namespace
}  // namespace robochart::app::turns_test
