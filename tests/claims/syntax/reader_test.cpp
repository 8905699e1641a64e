// SPDX-License-Identifier: Apache-2.0
#include "claims/syntax/reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "base/diagnostics/render.hpp"
#include "claims/syntax/layout.hpp"
#include "claims/syntax/parser.hpp"

namespace robochart::claims {
namespace {

using ::testing::HasSubstr;

struct Parsed {
    explicit Parsed(const std::string& text) { file = read(sources, sources.add("a.claims", text), diagnostics); }
    [[nodiscard]] std::string report() const { return diagnostics::render_text(sources, diagnostics); }

    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    ClaimFile file;
};

std::string formatted(const std::string& text) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    return format(sources, sources.add("a.claims", text), diagnostics)
        .value_or(diagnostics::render_text(sources, diagnostics));
}

TEST(ClaimReader, ReadsAFile) {
    const Parsed parsed(
        "package p\nimport small::*\nunit 0.1 s\nclaim A of Patrol : after estop until reset, never goTo\n");
    ASSERT_TRUE(parsed.diagnostics.ok()) << parsed.report();
    EXPECT_EQ(parsed.file.package->text, "p");
    ASSERT_EQ(parsed.file.imports.size(), 1U);
    EXPECT_TRUE(parsed.file.imports[0].wildcard);
    EXPECT_EQ(parsed.file.units.at(0).number, "0.1");
    ASSERT_EQ(parsed.file.claims.size(), 1U);
    const Claim& claim = parsed.file.claims[0];
    EXPECT_EQ(claim.component->text, "Patrol");
    EXPECT_EQ(claim.scope.kind, ScopeKind::after_until);
    EXPECT_EQ(claim.body.kind, BodyKind::never);
    EXPECT_EQ(claim.wording, "after estop until reset, never goTo");
}

TEST(ClaimReader, ReadsEachBody) {
    const auto body_of = [](const std::string& text) {
        const Parsed parsed("claim A : " + text);
        EXPECT_TRUE(parsed.diagnostics.ok()) << parsed.report();
        return parsed.file.claims.empty() ? Body{} : parsed.file.claims[0].body;
    };
    EXPECT_EQ(body_of("never a or b").events.patterns.size(), 2U);
    EXPECT_EQ(body_of("a only after b").kind, BodyKind::only_after);
    EXPECT_EQ(body_of("a only within 3 s after b").kind, BodyKind::only_within);
    EXPECT_EQ(body_of("a leads to b within 3 s unless c").exceptions.patterns.size(), 1U);
    EXPECT_EQ(body_of("a leads to b unless c").kind, BodyKind::leads);
    EXPECT_EQ(body_of("a leads to b before c").kind, BodyKind::leads_before);
    EXPECT_EQ(body_of("a at least 3 s after b").kind, BodyKind::at_least);
    EXPECT_EQ(body_of("at most 3 a in any 2 min").count, "3");
    EXPECT_EQ(body_of("a at least every 3 units").kind, BodyKind::every);
    EXPECT_EQ(body_of("possible a").kind, BodyKind::possible);
    EXPECT_EQ(body_of("never any call but a or b").events.patterns[0].but.size(), 2U);
    EXPECT_EQ(body_of("never goTo(v) with v != last goTo and v != (last goTo + 1) % 4").events.patterns.size(), 1U);
}

TEST(ClaimReader, ReadsEachScope) {
    const auto scope_of = [](const std::string& text) {
        const Parsed parsed("claim A : " + text + ", never x");
        EXPECT_TRUE(parsed.diagnostics.ok()) << parsed.report();
        return parsed.file.claims.empty() ? Scope{} : parsed.file.claims[0].scope;
    };
    EXPECT_EQ(scope_of("before a").kind, ScopeKind::before);
    EXPECT_EQ(scope_of("after a").kind, ScopeKind::after);
    EXPECT_TRUE(scope_of("after first a").only_first);
    EXPECT_EQ(scope_of("after each start or a").kind, ScopeKind::after_each);
    EXPECT_EQ(scope_of("for 3 s after a").kind, ScopeKind::for_after);
    EXPECT_EQ(scope_of("in a cycle with a or b").first.patterns.size(), 2U);
}

TEST(ClaimReader, ReadsConditionsOnStatesAndVariables) {
    const auto claim_of = [](const std::string& text) {
        const Parsed parsed(text);
        EXPECT_TRUE(parsed.diagnostics.ok()) << parsed.report();
        return parsed.file.claims.empty() ? Claim{} : parsed.file.claims[0];
    };
    const Claim during = claim_of("claim A : while in Operating::Held and not retries > 2, never a");
    EXPECT_EQ(during.scope.kind, ScopeKind::during);
    EXPECT_EQ(during.scope.condition->op, Op::conjunction);
    EXPECT_EQ(claim_of("claim A : always in Held or retries == 0").body.condition->op, Op::disjunction);
    EXPECT_EQ(claim_of("claim A : in Held for at least 3 s").body.kind, BodyKind::for_at_least);
    EXPECT_EQ(claim_of("claim A : retries > 2 for at most 3 units").body.kind, BodyKind::for_at_most);
    EXPECT_EQ(claim_of("claim A : possible retries > 2").body.condition->op, Op::greater);
    EXPECT_EQ(claim_of("claim A : possible in P::Held").body.condition->op, Op::in_state);
    EXPECT_EQ(claim_of("claim A : possible in estop").body.condition, nullptr);  // or a state; the checks know
    EXPECT_EQ(claim_of("claim A : enter Held leads to leave Held within 3 s").body.events.patterns[0].kind,
              PatternKind::enter);
    EXPECT_EQ(claim_of("claim A : can take a within 2 units").body.kind, BodyKind::can_take);
    EXPECT_TRUE(claim_of("assume A : a leads to b within 1 units").assumption);
    EXPECT_EQ(claim_of("claim A : never enter or leave").body.events.patterns[1].kind, PatternKind::named);
    EXPECT_EQ(claim_of("claim A : always leads to while").body.kind, BodyKind::leads);
}

TEST(ClaimReader, ReadsOrders) {
    const Parsed parsed("order Patrol : estop first, obstacle, estop drops reset, clear\nclaim A : never order\n");
    ASSERT_TRUE(parsed.diagnostics.ok()) << parsed.report();
    ASSERT_EQ(parsed.file.orders.size(), 1U);
    EXPECT_EQ(parsed.file.orders[0].first.size(), 2U);
    ASSERT_EQ(parsed.file.orders[0].drops.size(), 2U);
    EXPECT_EQ(parsed.file.orders[0].drops[1].dropped.text, "clear");
    EXPECT_FALSE(Parsed("order Patrol : estop").diagnostics.ok());
}

/// Words are keywords only where the grammar expects them.
TEST(ClaimReader, EventsMayHaveTheNamesOfKeywords) {
    const Parsed good(
        "claim A : after reset until out, never unit or first\nclaim C : each leads to ^start within 1 units");
    ASSERT_TRUE(good.diagnostics.ok()) << good.report();
    EXPECT_EQ(good.file.claims[1].body.others.patterns[0].kind, PatternKind::named);
}

TEST(ClaimReader, GivesAdvice) {
    EXPECT_THAT(Parsed("claim A : never goTo > 3").report(), HasSubstr("goTo(w) with w > 3"));
    EXPECT_THAT(Parsed("claim A : a then b within 3 s").report(), HasSubstr("leads to halt within"));
    EXPECT_THAT(Parsed("claim A : after a never b").report(), HasSubstr("a scope ends with a comma"));
    EXPECT_THAT(Parsed("claim A : a leads to b within 3 parsecs").report(), HasSubstr("the unit of the duration"));
    EXPECT_THAT(Parsed("claim A : never a & b").report(), HasSubstr("CLM-P02"));
}

TEST(ClaimReader, ContinuesAtTheNextClaim) {
    const Parsed parsed("claim A : never\nclaim B : at most x\nclaim C : never a\nclaim D : a leads b\n");
    EXPECT_EQ(parsed.diagnostics.error_count(), 3U) << parsed.report();
    ASSERT_EQ(parsed.file.claims.size(), 1U);
    EXPECT_EQ(parsed.file.claims[0].name.text, "C");
}

TEST(ClaimReader, ReadsConstants) {
    const Parsed parsed(
        "claim A : never a with constant c of X set to -1\nclaim B : a leads to b within 3 s with constant c of P::X "
        "set to 150 ms, and constant d of Y set to Colour::red and constant e of Y set to true\n"
        "claim C : never a with constant c of X set to 3 unit 0.1 s\n");
    ASSERT_TRUE(parsed.diagnostics.ok()) << parsed.report();
    ASSERT_EQ(parsed.file.claims.size(), 3U);
    EXPECT_EQ(parsed.file.claims[0].constants.at(0).value, "-1");
    EXPECT_EQ(parsed.file.claims[0].wording, "never a with constant c of X set to -1");
    const std::vector<SetConstant>& constants = parsed.file.claims[1].constants;
    ASSERT_EQ(constants.size(), 3U);
    EXPECT_EQ(constants[0].component.text, "P::X");
    ASSERT_TRUE(constants[0].duration);
    EXPECT_EQ(constants[0].duration->number, "150");
    EXPECT_EQ(constants[1].value, "Colour::red");
    EXPECT_EQ(constants[2].value, "true");
    EXPECT_EQ(parsed.file.claims[2].constants.at(0).value, "3") << "`unit` begins an item";
    EXPECT_EQ(parsed.file.units.size(), 1U);
}

/// `with constant` begins the constants, unless `constant` is the name of a value.
TEST(ClaimReader, ConstantMayBeTheNameOfAValue) {
    const Parsed parsed("claim A : never a(constant) with constant > 3 with constant c of X set to 1\n");
    ASSERT_TRUE(parsed.diagnostics.ok()) << parsed.report();
    EXPECT_NE(parsed.file.claims[0].body.events.patterns[0].condition, nullptr);
    EXPECT_EQ(parsed.file.claims[0].constants.size(), 1U);
}

TEST(ClaimReader, RejectsIncompleteConstants) {
    for (const char* text :
         {"claim A : never a with constant c set to 1", "claim A : never a with constant c of X to 1",
          "claim A : never a with constant c of X set to",
          "claim A : never a with constant c of X set to 1, constant d of X set to 2",
          "claim A : never a with constant c of X set to 1 + 2"})
        EXPECT_THAT(Parsed(text).report(), HasSubstr("CLM-P01")) << text;
}

TEST(ClaimReader, LimitsTheDepth) {
    const std::string many(Parser::max_depth + 10, '(');
    const Parsed parsed("claim A : never a(w) with " + many + "w > 1");
    EXPECT_THAT(parsed.report(), HasSubstr("CLM-P05"));
}

TEST(ClaimLayout, LaysOutEachClaimOnALine) {
    EXPECT_EQ(
        formatted("import  small :: *\n\n\n\nunit 0.1   s\nclaim A:after a\n   until b ,never goTo ( - 1 )or  c\n"),
        "import small::*\n\nunit 0.1 s\nclaim A : after a until b, never goTo(-1) or c\n");
}

TEST(ClaimLayout, LaysOutConstants) {
    EXPECT_EQ(formatted("claim A:never a with  constant c of P :: X set to - 1 , and constant d of X set to 3   s\n"),
              "claim A : never a with constant c of P::X set to -1, and constant d of X set to 3 s\n");
}

TEST(ClaimLayout, KeepsComments) {
    const std::string text =
        "// first  \nclaim A : never a // why\n/* more */ claim B : after a, // here\n    never b\n";
    const std::string once = formatted(text);
    EXPECT_THAT(once, HasSubstr("// why"));
    EXPECT_THAT(once, HasSubstr("// here\n    never b"));
    EXPECT_EQ(formatted(once), once);
}

}  // namespace
}  // namespace robochart::claims
