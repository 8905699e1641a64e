// SPDX-License-Identifier: Apache-2.0
// Tests that findings are decoded as they were encoded, and that other bytes are rejected.
#include "checker/refine/verdict/findings.hpp"

#include <gtest/gtest.h>

namespace robochart::refine {
namespace {

const process::EventSet named{0, 1, 7, 9};
constexpr std::size_t width = 2;

Findings divergence() {
    Findings findings;
    findings.statistics.states = 12;
    findings.statistics.transitions = 34;
    findings.statistics.depth = 3;
    findings.statistics.spec_nodes = 5;
    findings.statistics.chased = 6;
    findings.statistics.decided_by = DecidedBy::choice_free;
    findings.statistics.diagram_nodes = 12;
    findings.statistics.log10_states = 17.25;
    findings.violation = Violation{ViolationKind::divergence,
                                   {{1, 2}, {{7, 7, {3, 4}}, {0, 9, {5, 0xFFFFFFFFU}}}},
                                   {{5, 0xFFFFFFFFU}, {{0, 0, {5, 0xFFFFFFFFU}}}},
                                   process::Event{9}};
    return findings;
}

TEST(FindingsTest, ComeBackAsTheyWere) {
    const Findings written = divergence();
    const auto read = decode(encode(written, named), named, width);
    ASSERT_TRUE(read && read->violation);
    EXPECT_EQ(read->statistics.states, 12U);
    EXPECT_EQ(read->statistics.spec_nodes, 5U);
    EXPECT_EQ(read->statistics.chased, 6U);
    EXPECT_EQ(read->statistics.decided_by, DecidedBy::choice_free);
    EXPECT_EQ(read->statistics.diagram_nodes, 12U);
    EXPECT_EQ(read->statistics.log10_states, 17.25);
    EXPECT_EQ(read->violation->kind, ViolationKind::divergence);
    EXPECT_EQ(read->violation->event, process::Event{9});
    ASSERT_EQ(read->violation->run.steps.size(), 2U);
    EXPECT_EQ(read->violation->run.initial, (std::vector<lts::Word>{1, 2}));
    EXPECT_EQ(read->violation->run.steps[1].revealed, 9U);
    EXPECT_EQ(read->violation->run.steps[1].state, (std::vector<lts::Word>{5, 0xFFFFFFFFU}));
    EXPECT_EQ(read->violation->loop.steps.size(), 1U);
}

TEST(FindingsTest, EventsAreWrittenByTheirPlaces) {
    const process::EventSet others{0, 1, 20, 30};
    const auto read = decode(encode(divergence(), named), others, width);
    ASSERT_TRUE(read && read->violation);
    EXPECT_EQ(read->violation->run.steps[0].event, 20U);
    EXPECT_EQ(read->violation->event, process::Event{30});
}

TEST(FindingsTest, OfAnAssertionThatHoldsThereIsNoViolation) {
    Findings findings;
    findings.statistics.states = 1;
    const auto read = decode(encode(findings, named), named, width);
    ASSERT_TRUE(read);
    EXPECT_FALSE(read->violation);
}

TEST(FindingsTest, OtherBytesAreNone) {
    const std::string bytes = encode(divergence(), named);
    for (std::size_t length = 0; length < bytes.size(); ++length)
        EXPECT_FALSE(decode(bytes.substr(0, length), named, width)) << length;
    EXPECT_FALSE(decode(bytes + std::string(8, '\0'), named, width));
    EXPECT_FALSE(decode(bytes, named, width + 1));
    EXPECT_FALSE(decode(bytes, {0, 1, 7}, width)) << "an event without a name";
    std::string no_way = bytes;
    no_way[0] = 5;
    EXPECT_FALSE(decode(no_way, named, width)) << "a way to decide that does not exist";
    std::string wrong_kind = bytes;
    wrong_kind[10 * 8] = 99;  // the byte after the ten figures says whether there is a violation
    EXPECT_FALSE(decode(wrong_kind, named, width));
    std::string endless = bytes;
    for (std::size_t i = 14 * 8; i < 15 * 8; ++i) endless[i] = '\xff';
    EXPECT_FALSE(decode(endless, named, width)) << "a run of so many steps";
}

}  // namespace
}  // namespace robochart::refine
