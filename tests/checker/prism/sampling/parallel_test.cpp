// Work by several threads: every number once, the exception of the least.
#include "checker/prism/sampling/parallel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

namespace robochart::prism {
namespace {

TEST(Parallel, EveryNumberIsDoneOnce) {
    for (const unsigned threads : {0U, 1U, 2U, 8U}) {
        std::vector<std::atomic<int>> done(100);
        std::atomic<unsigned> greatest = 0;
        in_parallel(done.size(), threads, [&](std::size_t number, unsigned thread) {
            ++done[number];
            if (thread > greatest) greatest = thread;
        });
        for (const std::atomic<int>& each : done) EXPECT_EQ(each, 1);
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

TEST(Parallel, AsManyThreadsAsAskedFor) {
    EXPECT_EQ(threads_wanted(3), 3U);
    EXPECT_GE(threads_wanted(0), 1U);
}

}  // namespace
}  // namespace robochart::prism
