// What a test needs of the machine: a program or library that scripts/setup.sh installs. Without it the test says so
// and is skipped; in continuous integration (CI is set) it has failed, for a test that cannot run there shows nothing.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>

#define ROBOCHART_NEEDS(present, what)                                                                        \
    do {                                                                                                      \
        if (!(present)) {                                                                                     \
            /* NOLINTNEXTLINE(concurrency-mt-unsafe): before any thread starts */                             \
            if (std::getenv("CI") != nullptr) FAIL() << "in continuous integration there must be " << (what); \
            GTEST_SKIP() << "there is no " << (what);                                                         \
        }                                                                                                     \
    } while (false)
