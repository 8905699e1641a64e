// SPDX-License-Identifier: Apache-2.0
// Tests probabilistic assertions: the elements that their names denote, and the types that a property may have.
#include <gtest/gtest.h>

#include <functional>

#include "frontend/syntax/expression_visitor.hpp"
#include "tests/frontend/fixture.hpp"

namespace robochart::frontend {
namespace {

using testing::Reading;

constexpr const char* model =
    "enumeration Light { red green }\n"
    "robotic platform RP { var speed : nat event seen : Light }\n"
    "controller C { sref s = S }\n"
    "module M { rref rp = RP cref c = C }\n"
    "stm S { var count : nat var lit : boolean const p : real event e initial i state A { initial j state B { }\n"
    "  transition u { from j to B } } transition t { from i to A } }\n";

/// Returns the model together with an assertion file.
std::unique_ptr<Reading> with_claims(const std::string& claims) {
    auto reading = testing::read(model);
    const auto id = reading->sources.add("t.assertions", claims);
    reading->model.files.push_back(parse(reading->sources, id, true, reading->findings));
    resolve(reading->model, reading->findings);
    return reading;
}

/// Returns the codes of errors, each with its suggested fix.
std::string errors(const std::string& claims) {
    const auto reading = with_claims(claims);
    std::string out;
    for (const auto& finding : reading->findings.sorted_findings()) {
        if (finding.rule->severity != diagnostics::Severity::error) continue;
        out += (out.empty() ? "" : " ") + std::string(finding.rule->code);
        if (!finding.fixes.empty()) out += ":" + finding.fixes.front().replacement;
    }
    return out;
}

/// Returns "name=place" for every name with a target in the first property. The place is the enclosing element of the
/// target.
std::string targets(const std::string& claims) {
    const auto reading = with_claims(claims);
    EXPECT_TRUE(reading->findings.ok()) << reading->report();
    std::string out;
    walk_tree(*reading->model.files[1]->probabilistic_assertions.front().property, [&](const Expr& expr) {
        if (expr.name.empty()) return;
        const Declaration* target = expr.target;
        const std::string around = target != nullptr && target->parent != nullptr ? target->parent->name + "." : "";
        out += (out.empty() ? "" : " ") + expr.name.parts.back() + "=" +
               (target != nullptr ? around + target->name : std::string("-"));
    });
    return out;
}

TEST(Probability, NamesStandForPartsOfTheModel) {
    EXPECT_EQ(targets("prob property P: Prob=? of [Finally M::c::s::count == 1 /\\ M::c::s::lit]"),
              "count=S.count lit=S.lit");
    EXPECT_EQ(targets("prob property P: Exists [Finally M::rp::speed > 1]"), "speed=RP.speed");
    EXPECT_EQ(targets("prob property P: Exists [Finally M::rp::seen.in.val == Light::red]"),
              "seen=RP.seen red=Light.red");
    EXPECT_EQ(targets("prob property P: Exists [Finally M::c::s is in M::c::s::A]"), "s=S A=S.A");
    EXPECT_EQ(targets("prob property P: Exists [Finally S is in A::B]"), "S=S B=A.B");
    EXPECT_EQ(targets("prob property P: Exists [Finally S::A is in S::A::B]"), "A=S.A B=A.B");
    EXPECT_EQ(targets("prob property P: Exists [Finally deadlock \\/ init]"), "deadlock=- init=-");
}

TEST(Probability, NamesStandForWhatAssertionFilesDefine) {
    EXPECT_EQ(targets("const k : core::nat prob property P: Exists [Finally S::count == k]"), "count=S.count k=k");
    EXPECT_EQ(targets("pmodules X: pmodule N { v : bool; } prob property P: Exists [Finally @X::N::v]"), "v=v");
    EXPECT_EQ(errors("label l = true formula f = 1 rewards r = true : $f; endrewards\n"
                     "defs D: pfunction g(x) = { return $$x }\n"
                     "pmodules X: pmodule N { v : [0 to 1]; [S::e.in] @v == 0 -> (0.5 : @v = 1) & (@N::v = &g(1)); }\n"
                     "constants K: S::p set to 0.5\n"
                     "prob property P: Reward {r} >= 1 of [Reachable #l] with constants K with definitions D with "
                     "modules X"),
              "");
}

TEST(Probability, UnknownNamesAreErrorsWithASuggestion) {
    const auto path = [](const std::string& formula) {
        return errors(
            "const limit : core::nat label ready = true formula total = 1\n"
            "prob property P: Exists [Finally " +
            formula + "]");
    };
    EXPECT_EQ(path("S::coumt == 1"), "RC-N01:count");
    EXPECT_EQ(path("M::rp::sped == 1"), "RC-N01:speed");
    EXPECT_EQ(path("S::count == limt"), "RC-N01:limit");
    EXPECT_EQ(path("S is in S::AA"), "RC-N01:A");
    EXPECT_EQ(path("#redy"), "RC-N01:ready");
    EXPECT_EQ(path("$totl == 1"), "RC-N01:total");
    EXPECT_EQ(path("M::rp::seen.in.val == Light::gren"), "RC-N01:green");
    EXPECT_EQ(path("M::rp::sen.in.val == Light::green"), "RC-N01:seen");
    EXPECT_EQ(path("@v"), "RC-N01");
    EXPECT_EQ(path("$$x"), "RC-N01");
    EXPECT_EQ(path("&f(1) == 1"), "RC-N01");
    EXPECT_EQ(errors("constants Few: S::p set to 1 prob property P: true with constants Fews"), "RC-N01:Few");
    EXPECT_EQ(errors("prob property P: Reward {r} =? of [Total]"), "RC-N01");
}

// The reference's validator has the rules NotBooleanOrQueryInProbAssertion and NotPathFormulaInProbAssertion.
TEST(Probability, PropertiesAreBooleanOrQueries) {
    for (const char* number : {"1", "-1", "1.5 + 2", "(1)", "S::count", "\"text\""})
        EXPECT_EQ(errors("prob property P: " + std::string(number)), "RC-Q11") << number;
    for (const char* path :
         {"Finally true", "true Until false", "(Globally true)", "not Next true", "true /\\ (Weak Until true)"})
        EXPECT_EQ(errors("prob property P: " + std::string(path)), "RC-Q12") << path;
    for (const char* property : {"true", "not true", "1 == 2", "S::lit", "1 != 2 iff 2 == 1", "Exists [Finally false]",
                                 "Prob=? of [true Until false]", "Reward=? of [Total]", "deadlock => init"})
        EXPECT_EQ(errors("prob property P: " + std::string(property)), "") << property;
}

TEST(Probability, ClausesHaveAnOrder) {
    const std::string defined = "constants K: S::p set to 1 defs D: pfunction f() = { return 1 }\n";
    const std::string property = defined + "prob property P: true with ";
    EXPECT_EQ(errors(property + "constants K with definitions D with cmdoptions \"-x\""), "");
    EXPECT_EQ(errors(property + "definitions D with constants K"), "RC-P35");
    EXPECT_EQ(errors(property + "constants K with constants K"), "RC-P35");
}

/// A mistake ends only the assertion that contains it.
TEST(Probability, ReadingGoesOnBehindAMistake) {
    for (const char* part : {"prob property Q: Prob of [Finally true]", "prob property Q: Prob=? of Finally true]",
                             "rewards r = true 1; endrewards", "pmodules X: pmodule N { v : int; }",
                             "constants C: k from 1", "prob property Q: true using sim with XY at n=1",
                             "label l = ", "prob generate path Q: using simulation 10 steps", "defs D: f() = 1"}) {
        const auto reading = with_claims(std::string(part) + "\nprob property P: 1\nassertion A: S is deadlock-free");
        ASSERT_FALSE(reading->model.files[1]->probabilistic_assertions.empty()) << part;
        EXPECT_EQ(reading->model.files[1]->probabilistic_assertions.back().name, "P") << part;
        EXPECT_EQ(reading->model.files[1]->assertions.size(), 1U) << part;
        EXPECT_EQ(reading->model.files[1]->kept.size(), 0U) << part;
        EXPECT_TRUE(reading->model.files[1]->has_syntax_errors) << part;
    }
}

/// RoboTool's files are parsed completely, and all their names are resolved.
TEST(Probability, TheSuiteIsUnderstood) {
    const auto& shared = testing::shared_folder();
    if (shared.empty()) GTEST_SKIP() << "the shared folder is not there";
    for (const auto& [folder, properties] :
         {std::pair("suite/prism/uvc", 14U), std::pair("suite/prism/robotool/hvc", 14U)}) {
        if (!std::filesystem::exists(shared / folder)) continue;
        Reading reading;
        const auto loaded = load_project(reading.sources, {(shared / folder).string()}, reading.findings);
        EXPECT_TRUE(reading.findings.ok()) << reading.report();
        std::size_t count = 0;
        for (const auto& file : loaded->files) {
            count += file->probabilistic_assertions.size();
            EXPECT_TRUE(file->kept.empty());
        }
        EXPECT_EQ(count, properties) << folder;
    }
}

}  // namespace
}  // namespace robochart::frontend
