// SPDX-License-Identifier: Apache-2.0
// Tests parallel work on threads: each number is processed once, and the exception of the lowest number is rethrown.
// Tests also threads that throw, and threads that cannot be started.
#include "base/threads/threads.hpp"

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/diagnostics/budget.hpp"

namespace robochart::diagnostics {
namespace {

TEST(Parallel, EveryNumberIsDoneOnce) {
    for (const unsigned threads : {0U, 1U, 2U, 8U}) {
        std::vector<std::atomic<int>> done(100);
        std::atomic<unsigned> greatest = 0;
        in_parallel(done.size(), threads, [&](std::size_t number, unsigned thread) {
            ++done[number];
            if (thread > greatest) greatest = thread;
        });
        for (const std::atomic<int>& count : done) EXPECT_EQ(count, 1);
        EXPECT_LT(greatest, std::max(1U, threads));
    }
    in_parallel(0, 4, [](std::size_t, unsigned) { FAIL(); });
}

TEST(Parallel, TheExceptionOfTheLeastNumberIsThrown) {
    for (int i = 0; i < 50; ++i) {
        std::string found;
        try {
            in_parallel(40, 4, [](std::size_t number, unsigned) {
                if (number % 10 == 7) throw std::runtime_error(std::to_string(number));
            });
        } catch (const std::runtime_error& error) {
            found = error.what();
        }
        EXPECT_EQ(found, "7");
    }
}

TEST(Parallel, NoNumberIsBegunAfterAnException) {
    std::atomic<int> done = 0;
    EXPECT_THROW(in_parallel(1000, 1,
                             [&](std::size_t number, unsigned) {
                                 ++done;
                                 if (number == 3) throw std::runtime_error("");
                             }),
                 std::runtime_error);
    EXPECT_EQ(done, 4);
}

TEST(Threads, ThrowWhatTheFirstOfThemHasThrownAndStopTheOthers) {
    std::atomic<bool> stopped = false;
    const auto work = [&](unsigned number) {
        if (number == 2) throw std::bad_alloc();
        while (!stopped) std::this_thread::yield();
        if (number == 1) throw std::runtime_error("1");
    };
    Threads threads(4, work, [&] { stopped = true; });
    EXPECT_EQ(threads.size(), 4U);
    EXPECT_THROW(threads.join(), std::runtime_error) << "of the least number, not the first in time";
    EXPECT_TRUE(threads.returned_within(std::chrono::milliseconds(0)));
}

TEST(Threads, AreStoppedAndAwaitedWhereTheCallerThrows) {
    std::atomic<bool> stopped = false;
    std::atomic<int> returned = 0;
    const auto work = [&](unsigned) {
        while (!stopped) std::this_thread::yield();
        ++returned;
    };
    try {
        const Threads threads(3, work, [&] { stopped = true; });
        throw std::runtime_error("");
    } catch (const std::runtime_error&) {
    }
    EXPECT_EQ(returned, 2);
}

TEST(Watched, WhatAThreadThrowsReachesTheCaller) {
    std::atomic<bool> stopped = false;
    const auto work = [&] {
        static std::atomic<int> first = 0;
        if (first++ == 0) throw std::bad_alloc();
        while (!stopped) std::this_thread::yield();
    };
    EXPECT_THROW(in_parallel_watched(
                     3, work, [&] { stopped = true; }, [] {}),
                 std::bad_alloc);
}

TEST(Watched, WhatTheWatcherThrowsStopsTheThreads) {
    std::atomic<bool> stopped = false;
    const auto work = [&] {
        while (!stopped) std::this_thread::yield();
    };
    EXPECT_THROW(in_parallel_watched(
                     2, work, [&] { stopped = true; }, [] { throw LimitReached("now"); }),
                 LimitReached);
}

TEST(Watched, TheWatcherLooksOnceAtTheEnd) {
    int looks = 0;
    in_parallel_watched(
        2, [] {}, [] {}, [&] { ++looks; });
    EXPECT_GE(looks, 1);
}

/// Runs `work` in a program without memory for the stacks of many threads. Returns its exit code, which is 3 if it
/// reports a limit.
int end_without_stacks(const std::function<void()>& work) {
    const pid_t child = fork();
    if (child == 0) {
        std::uint64_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        rlimit limit{};
        getrlimit(RLIMIT_AS, &limit);
        limit.rlim_cur = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) + (64U << 20U);
        setrlimit(RLIMIT_AS, &limit);
        try {
            work();
        } catch (const LimitReached& reached) {
            _exit(std::string(reached.what()).find("threads cannot be started") != std::string::npos ? 3 : 5);
        } catch (...) {
            _exit(4);
        }
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Threads, ThatCannotBeStartedAreALimit) {
    EXPECT_EQ(end_without_stacks([] { in_parallel(1000, 200, [](std::size_t, unsigned) {}); }), 3);
    EXPECT_EQ(end_without_stacks([] {
                  std::atomic<bool> stopped = false;
                  const auto work = [&] {
                      while (!stopped) std::this_thread::yield();
                  };
                  in_parallel_watched(
                      200, work, [&] { stopped = true; }, [] {});
              }),
              3);
}

TEST(Parallel, AsManyThreadsAsAskedFor) {
    EXPECT_EQ(threads_wanted(3), 3U);
    EXPECT_GE(threads_wanted(0), 1U);
}

}  // namespace
}  // namespace robochart::diagnostics
