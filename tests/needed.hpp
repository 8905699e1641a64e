// SPDX-License-Identifier: Apache-2.0
// Checks that a program or library is present that a test needs and that scripts/setup.sh installs. If it is missing,
// the test says so and is skipped. In continuous integration (CI is set) the test fails instead, because nobody would
// notice that it was skipped.
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
