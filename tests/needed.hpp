// SPDX-License-Identifier: Apache-2.0
// Programs and libraries that a test needs and that scripts/setup.sh installs. If one is missing, the test says so and
// is skipped. In continuous integration (CI is set) it fails, because a skipped test would go unnoticed.
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
