// SPDX-License-Identifier: Apache-2.0
// Tests the budget of a run: each limit is detected and reported with the current phase, and resources are released.
#include "base/diagnostics/budget.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <vector>

#include "tests/temporary_folder.hpp"

namespace robochart::diagnostics {
namespace {

using std::chrono::steady_clock;
using ::testing::HasSubstr;

std::string thrown_by_polling(Budget& budget) {
    try {
        for (int i = 0; i < 1000; ++i) budget.poll();
    } catch (const LimitReached& limit) {
        return limit.what();
    }
    return "";
}

TEST(Budget, LetsWorkWithinItsLimitsGoOn) {
    Budget budget;
    EXPECT_EQ(thrown_by_polling(budget), "");
    EXPECT_EQ(budget.reached_limit(), "");
    Limits later;
    later.deadline = steady_clock::now() + std::chrono::hours(1);
    Budget bounded(later);
    EXPECT_EQ(thrown_by_polling(bounded), "");
}

TEST(Budget, SaysWhichLimitAndInWhichPhase) {
    Limits past;
    past.deadline = steady_clock::now() - std::chrono::seconds(1);
    Budget late(past, "counting");
    EXPECT_EQ(thrown_by_polling(late), "the time limit was reached while counting");

    Limits little;
    little.memory_bytes = 1U << 20U;
    Budget large(little);
    EXPECT_EQ(thrown_by_polling(large), "the memory limit of 1 MiB was reached");

    Limits limits;
    limits.interrupted = [] { return true; };
    Budget stopped(limits);
    EXPECT_EQ(thrown_by_polling(stopped), "the run was interrupted");
}

TEST(Budget, IsInterruptedFromOutside) {
    Budget budget;
    EXPECT_FALSE(budget.is_interrupted());
    budget.interrupt();
    EXPECT_TRUE(budget.is_interrupted());
    EXPECT_THROW(budget.poll(), LimitReached);  // already at the first call, because a limit that was reached is known
}

TEST(Budget, NamesTheInnermostPhase) {
    Budget budget;
    const Budget::Phase outer(budget, "doing much");
    {
        const Budget::Phase inner(budget, "doing little");
        budget.interrupt();
        EXPECT_THAT(budget.reached_limit(), HasSubstr("while doing little"));
    }
    EXPECT_THAT(budget.reached_limit(), HasSubstr("while doing much"));
    EXPECT_THROW(Budget::Phase(budget, "more"), LimitReached);
}

TEST(Budget, CountsTheMemoryOfAProcessAndItsChildren) {
    EXPECT_GT(resident_bytes(), 1U << 20U);
    const pid_t child = fork();
    if (child == 0) {
        setpgid(0, 0);
        if (fork() == 0) {
            std::vector<char> block(64U << 20U, 1);
            pause();
            _exit(0);
        }
        pause();
        _exit(0);
    }
    std::uint64_t bytes = 0;
    for (int i = 0; i < 500 && bytes < (64U << 20U); ++i, usleep(20'000)) bytes = resident_bytes_of_tree(child);
    EXPECT_GE(bytes, 64U << 20U);
    kill(-child, SIGKILL);  // also ends its child
    waitpid(child, nullptr, 0);
}

TEST(Budget, ReleasesWhatIsHeldAndNothingElse) {
    const tests::TemporaryFolder folder;
    const auto file = [&](const char* name) { return folder.write(name, "text"); };
    Budget budget;
    const Budget::Held held(&budget, file("held"));
    { const Budget::Held finished(&budget, file("finished")); }
    const Budget::Held of_nobody(nullptr, file("free"));
    budget.release_resources();
    EXPECT_FALSE(std::filesystem::exists(folder.in("held")));
    EXPECT_TRUE(std::filesystem::exists(folder.in("finished")));
    EXPECT_TRUE(std::filesystem::exists(folder.in("free")));
}

}  // namespace
}  // namespace robochart::diagnostics
