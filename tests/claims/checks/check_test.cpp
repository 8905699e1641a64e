// SPDX-License-Identifier: Apache-2.0
#include "claims/checks/check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "claims/checks/duration.hpp"
#include "tests/claims/support.hpp"

namespace robochart::claims {
namespace {

using ::testing::HasSubstr;
using testing::Read;

struct Row {
    const char* text;
    const char* finding;  ///< "" if there is none
    const char* message;
};

/// Tests the kinds of bad input that docs/claims.md names.
TEST(ClaimChecks, RejectBadInput) {
    for (const Row& row : {
             Row{"claim A : never halt", "", ""},
             Row{"claim A : never holt", "CLM-T01:1", "did you mean `halt`?"},
             Row{"claim A of Patroll : never halt", "CLM-T02:1", "did you mean"},
             Row{"claim A : never halt\nclaim A : never goTo", "CLM-T03:2", ""},
             Row{"claim Taken : never halt", "CLM-T03:1", ""},
             Row{"claim A : never goTo(1, 2)", "CLM-T04:1", "carries 1 value, not 2"},
             Row{"claim A : never goTo(w) with v > 1", "CLM-T04:1", "`v` is no value here"},
             Row{"claim A : never goTo(true)", "CLM-T04:1", "has the type nat"},
             Row{"claim A : never goTo(w) with w", "CLM-T04:1", "no condition"},
             Row{"claim A : never show(blue, _)", "", ""},  // a variable
             Row{"claim A : never show(red, _)", "", ""},
             Row{"claim A : never show(c, b) with c == Colour::green and b", "", ""},
             Row{"claim A : never show(c, b) with c == b", "CLM-T04:1", "different types"},
             Row{"claim A : never goTo(w) with w > last show", "CLM-T04:1", "one value"},
             Row{"claim A : never beep", "CLM-T05:1", "`in beep` or `out beep`"},
             Row{"claim A : never out beep", "", ""},
             Row{"claim A : obstacle leads to halt within 3", "CLM-T06:1", "`3 units`"},
             Row{"claim A : obstacle leads to halt within 3 seconds", "CLM-T06:1", "`unit 0.1 s`"},
             Row{"unit 0.1 s claim A : obstacle leads to halt within -1 s", "CLM-T06:1", "not negative"},
             Row{"unit 0.1 s claim A : obstacle leads to halt within 99999999 s", "CLM-T06:1", "10000 time units"},
             Row{"unit 0.1 s claim A : obstacle leads to halt within 150 ms", "CLM-T06:1",
                 "the neighbours are 100 ms and 200 ms; `unit 50 ms` would do"},
             Row{"unit 0.10 s claim A : obstacle leads to halt within 100 ms", "", ""},
             Row{"claim A : obstacle leads to halt within 1.5 units", "CLM-T06:1", "whole"},
             Row{"unit 3 units claim A : never halt", "CLM-T06:1", "such as `unit 0.1 s`"},
             Row{"claim A : halt at least 0 units after obstacle", "CLM-T07:1", ""},
             Row{"claim A : at most 0 halt", "CLM-T07:1", "write `never`"},
             Row{"claim A : halt only after halt", "CLM-T07:1", ""},
             Row{"claim A : after goTo until goTo, never goTo(w) with w > 2", "CLM-T07:1", "`last E`"},
             Row{"claim A : after goTo until goTo, never goTo(w) with w > 2 or halt", "", ""},
             Row{"claim A : before start, never halt", "CLM-T07:1", ""},
             Row{"claim A : obstacle leads to halt before halt", "CLM-T07:1", ""},
             Row{"claim A : after obstacle, at most 2 halt", "CLM-T08:1", ""},
             Row{"claim A : after obstacle, halt at least every 3 units", "CLM-T08:1", ""},
             Row{"claim A : never halt with constant limit of Patrol set to 1", "", ""},
             Row{"claim A : never halt with constant limt of Patrol set to 1", "CLM-T17:1", "did you mean `limit`?"},
             Row{"claim A : never halt with constant retries of Patrol set to 1", "CLM-T17:1", "no constant `retries`"},
             Row{"claim A : never halt with constant limit of Patroll set to 1", "CLM-T02:1", "did you mean"},
             Row{"claim A : never halt with constant limit of Patrol set to -1", "CLM-T04:1",
                 "not a literal of type nat"},
             Row{"claim A : never halt with constant limit of Patrol set to 1.5", "CLM-T04:1", "type nat"},
             Row{"claim A : never halt with constant limit of Patrol set to true", "CLM-T04:1", "type nat"},
             Row{"claim A : never halt with constant limit of Patrol set to red", "CLM-T04:1", "type nat"},
             Row{"claim A : never halt with constant limit of Patrol set to 3 units", "CLM-T04:1", "is no time"},
             Row{"claim A : never halt with constant limit of Patrol set to 1, and constant limit of Patrol set to 2",
                 "CLM-T15:1", "set twice"},
             Row{"assume A : never clear with constant limit of Patrol set to 1", "CLM-T15:1", "assumption"},
             Row{"claim A : after first obstacle, at most 2 halt", "", ""},
             Row{"claim A : after each obstacle, at most 2 halt", "", ""},
             Row{"import smal::* claim A : never halt", "CLM-T12:1 CLM-T02:1", "did you mean `small`?"},
             Row{"import small::* claim A : never halt", "", ""},
             Row{"claim A : while in Held, never goTo", "", ""},
             Row{"claim A : while in Patrol::Held, never goTo", "", ""},
             Row{"claim A : while Held, never goTo", "CLM-T04:1", "write `in Held`"},
             Row{"claim A : while in Helt, never goTo", "CLM-T13:1", "did you mean `Held`?"},
             Row{"claim A : while in Inner, never goTo", "CLM-T13:1", "did you mean `Outer::Inner`?"},
             Row{"claim A : while in Patrol::Nowhere, never goTo", "CLM-T13:1", "no state `Patrol::Nowhere`"},
             Row{"claim A : never Held", "CLM-T04:1", "`always not in Held`"},
             Row{"claim A : always retries <= limit and in Outer::Inner", "", ""},
             Row{"claim A : always retrees <= 3", "CLM-T13:1", "did you mean `retries`?"},
             Row{"claim A : always retries", "CLM-T04:1", "no condition"},
             Row{"claim A : always shade == Colour::red", "", ""},
             Row{"claim A : always shade == 1", "CLM-T04:1", "different types"},
             Row{"claim A : always retries <= last level", "CLM-T04:1", "last values"},
             Row{"claim A : always 1 < 2", "CLM-T04:1", "no state and no variable"},
             Row{"claim A : never halt with in Held", "CLM-T04:1", "`while in S, ...`"},
             Row{"claim A : in Held for at least 0 units", "CLM-T07:1", ""},
             Row{"claim A : possible in Held", "", ""},
             Row{"claim A : can take obstacle within 2 units", "", ""},
             Row{"claim A : while in Held, can take clear", "", ""},
             Row{"claim A : can take halt", "CLM-T15:1", "one input"},
             Row{"claim A : after obstacle, can take clear", "CLM-T15:1", "`while in STATE`"},
             Row{"order Patrol : obstacle first, obstacle drops clear", "", ""},
             Row{"unit 0.1 s unit 100 ms claim A : never halt", "", ""},
             Row{"unit 0.1 s\nunit 0.2 s claim A : never halt", "CLM-T09:1 CLM-T09:2", "100 ms"},
             Row{"order Patrol : halt first", "CLM-T15:1", "does not receive an event `halt`"},
             Row{"order Patrol : in first", "CLM-T15:1", ""},
             Row{"order Patrol : obstacle first\norder Patrol : clear first", "CLM-T15:2", "two orders"},
             Row{"order Patrol : obstacle drops obstacle", "CLM-T15:1", "itself"},
             Row{"order Nobody : obstacle first", "CLM-T02:1", ""},
             Row{"claim A : in a cycle with obstacle, any call but halt only after halt", "", ""},
             Row{"claim A : in a cycle with obstacle, always in Held", "", ""},
             Row{"claim A : in a cycle with obstacle, halt at least 3 units after goTo", "CLM-T15:1", "no time inside"},
             Row{"claim A : in a cycle with obstacle, halt only after clear", "CLM-T15:1", "write `raised clear`"},
             Row{"claim A : in a cycle with halt, never goTo", "CLM-T15:1", "begins with inputs"},
             Row{"claim A : raised obstacle leads to halt within 0 units", "", ""},
             Row{"claim A : in a cycle with obstacle, never enter Held", "CLM-T15:1", "end of a cycle"},
             Row{"assume A : obstacle leads to clear within 3 units", "", ""},
             Row{"assume A : halt leads to clear within 3 units", "", ""},
             Row{"assume A : obstacle leads to halt within 3 units", "CLM-T15:1", "restricts inputs"},
             Row{"assume A : obstacle leads to clear", "CLM-T15:1", "when inputs come"},
         }) {
        const Read read(row.text);
        ASSERT_TRUE(read.model_ok);
        EXPECT_EQ(read.findings(), row.finding) << row.text << "\n" << read.report();
        EXPECT_THAT(read.report(), HasSubstr(row.message)) << row.text;
    }
}

/// The fix replaces the name of the state, and not the word in front of the name.
TEST(ClaimChecks, FixTheNameOfAState) {
    for (const char* const text : {"claim A : while in Inner, never goTo", "claim A : enter Inner only after clear",
                                   "claim A : always not in  Inner or in Held"}) {
        const Read read(text);
        const auto findings = read.diagnostics.sorted_findings();
        ASSERT_EQ(findings.size(), 1U) << read.report();
        ASSERT_EQ(findings.front().fixes.size(), 1U);
        const diagnostics::FixIt& fix = findings.front().fixes.front();
        EXPECT_EQ(std::string_view(text).substr(fix.span.begin, fix.span.end - fix.span.begin), "Inner") << text;
        EXPECT_EQ(fix.replacement, "Outer::Inner");
    }
}

TEST(ClaimChecks, ResolvesEvents) {
    const Read read(
        "unit 0.1 s claim A : obstacle leads to any call but goTo within 1.5 s unless goTo(w) with w > last goTo");
    ASSERT_TRUE(read.diagnostics.ok()) << read.report();
    ASSERT_EQ(read.checked.claims.size(), 1U);
    const CheckedClaim& claim = read.checked.claims.front();
    EXPECT_EQ(claim.component.path, "small::Patrol");
    EXPECT_EQ(claim.body.units, 15);
    EXPECT_EQ(claim.body.others.any.front().channels.size(), 4U);  // show, halt, reverse, brake
    EXPECT_EQ(claim.remembered.size(), 1U);
    EXPECT_EQ(read.checked.unit, 100'000'000);
}

TEST(Durations, AreWrittenExactly) {
    EXPECT_EQ(durations::duration_text(100'000'000), "100 ms");
    EXPECT_EQ(durations::duration_text(2'500'000'000), "2.5 s");
    EXPECT_EQ(durations::duration_text(1), "0.000001 ms");
    EXPECT_EQ(durations::units_text(1, std::nullopt), "1 unit");
    EXPECT_EQ(durations::units_text(30, 100'000'000), "30 units (3 s)");
}

TEST(Fractions, AreExact) {
    EXPECT_EQ(Fraction::of_decimal("0.25") * Fraction(4), Fraction(1));
    EXPECT_LT(Fraction(1, 3), Fraction(1, 2));
    EXPECT_EQ(Fraction(1, 3) + Fraction(1, 6), Fraction(1, 2));
    EXPECT_EQ(Fraction(1) - Fraction(3, 2), Fraction(-1, 2));
    EXPECT_THROW((void)(Fraction(INT64_MAX) + Fraction(1)), NotComputable);
}

}  // namespace
}  // namespace robochart::claims
