// SPDX-License-Identifier: Apache-2.0
#include "prism/emit/preferences.hpp"

#include <gtest/gtest.h>

namespace robochart::prism_emit {
namespace {

TEST(Preferences, RangesAndTheKindAreRead) {
    Preferences found;
    EXPECT_EQ(read_preferences("# comment\nINT_MIN=-1\r\nINT_MAX = 20\nNAT_MIN=0\nNAT_MAX=5\nREAL_MIN=-3\nREAL_MAX=3\n"
                               "PRISM_MODELTYPE=mdp\nSTM_GEN_ORDER=\nERROR_LOG_FILE=error.log\n\n",
                               found),
              "");
    EXPECT_EQ(found.integer.low, -1);
    EXPECT_EQ(found.integer.high, 20);
    EXPECT_EQ(found.nat.high, 5);
    EXPECT_EQ(found.real.low, -3);
    EXPECT_EQ(found.kind, prism::ModelKind::mdp);
}

TEST(Preferences, WhatIsNotThereStays) {
    Preferences found;
    found.nat = {1, 4};
    EXPECT_EQ(read_preferences("INT_MAX=3\n", found), "");
    EXPECT_EQ(found.nat.low, 1);
    EXPECT_EQ(found.nat.high, 4);
}

TEST(Preferences, SettingsThatAreNotFollowedAreNamed) {
    Preferences found;
    EXPECT_EQ(read_preferences("MAX_SEQ_INS=3\nINT_MAX=3\nDBG_OPTION=true\nTYPE_OVERRIDE=\nOP_BOUND=3\n"
                               "USE_CONF_FROM_INSTANTIATION_CSP=false\n",
                               found),
              "");
    EXPECT_EQ(found.ignored, (std::vector<std::string>{"MAX_SEQ_INS", "OP_BOUND"}));
    EXPECT_TRUE(found.integer.asked);
    EXPECT_FALSE(found.nat.asked);
}

TEST(Preferences, MistakesAreNamedWithTheirLine) {
    const auto error = [](const std::string& text) {
        Preferences found;
        return read_preferences(text, found);
    };
    EXPECT_EQ(error("\nINT_MAX=many\n"), "line 2: INT_MAX: a whole number is expected");
    EXPECT_EQ(error("INT_MAX=3000000000\n"), "line 1: INT_MAX: a whole number is expected") << "more than 32 bits";
    EXPECT_EQ(error("PRISM_MODELTYPE=ctmc"), "line 1: PRISM_MODELTYPE: dtmc or mdp is expected");
    EXPECT_EQ(error("PRISM_MODEL_TYPE=mdp"), "line 1: PRISM_MODEL_TYPE: did you mean PRISM_MODELTYPE?");
    EXPECT_EQ(error("INT_MXA=3"), "line 1: INT_MXA: did you mean INT_MAX?");
    EXPECT_EQ(error("BOUNDED_NUM_OPTION=0\nDBG_OPTION=true\nMAX_SEQ_INS=3\nOP_BOUND=3\nOUTPUT_LOG_FILE=debug.log\n"
                    "TYPE_OVERRIDE=\nUSE_CONF_FROM_INSTANTIATION_CSP=false"),
              "")
        << "what RoboTool writes beside them";
    EXPECT_EQ(error("\n\nnonsense"), "line 3: KEY=VALUE is expected");
    EXPECT_EQ(error("NAT_MIN=2\nNAT_MAX=1"), "NAT_MIN is greater than NAT_MAX");
}

}  // namespace
}  // namespace robochart::prism_emit
