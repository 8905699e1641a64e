// SPDX-License-Identifier: Apache-2.0
// Makes every run use the same random cases, unless RC_PARAMS is set. A nightly run sets it to test more cases with a
// new seed.
#include <gtest/gtest.h>

#include <cstdlib>

namespace {

class RandomSetup : public testing::Environment {
public:
    void SetUp() override { setenv("RC_PARAMS", "seed=20 max_success=500 max_discard_ratio=20 max_size=120", 0); }
};

const testing::Environment* const random_setup = testing::AddGlobalTestEnvironment(new RandomSetup);

}  // namespace
