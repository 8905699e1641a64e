// SPDX-License-Identifier: Apache-2.0
// Uses the same random cases in every run, unless RC_PARAMS is set (a nightly run: more cases and a new seed).
#include <gtest/gtest.h>

#include <cstdlib>

namespace {

class RandomSetup : public testing::Environment {
public:
    void SetUp() override { setenv("RC_PARAMS", "seed=20 max_success=500 max_discard_ratio=20 max_size=120", 0); }
};

const testing::Environment* const random_setup = testing::AddGlobalTestEnvironment(new RandomSetup);

}  // namespace
