// SPDX-License-Identifier: Apache-2.0
// Tests that every name of a project has an occurrence, which refers to the named element (language reference 1.3).
#include "frontend/project/occurrences.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "frontend/syntax/lexer.hpp"
#include "frontend/syntax/parse.hpp"
#include "tests/frontend/fixture.hpp"
#include "tests/source_folder.hpp"

namespace robochart::frontend {
namespace {

using testing::resolved;

/// The occurrence at the n-th position (from 1) of `word` in the text.
struct Found {
    NameKind kind;
    const Declaration* target;
    std::string text;
    bool declares;
    Access access;
    std::uint32_t line;  ///< of the target's name
};

class Occurrences : public ::testing::Test {
protected:
    void load(const std::string& text, bool is_assertions = false) {
        text_ = text;
        reading_ = resolved(text, is_assertions);
        list_ = find_occurrences(reading_->model);
    }
    Found at(const std::string& marked) {
        const std::size_t bar = marked.find('@');
        std::string plain = marked;
        plain.erase(bar, 1);
        const std::size_t where = text_.find(plain);
        EXPECT_NE(where, std::string::npos) << marked;
        for (const Occurrence& occurrence : list_)
            if (occurrence.span.begin == where + bar) {
                const std::uint32_t line =
                    occurrence.target != nullptr
                        ? reading_->sources
                              .position(occurrence.target->name_span.source, occurrence.target->name_span.begin)
                              .line
                        : 0;
                return {occurrence.kind,     occurrence.target, occurrence.text,
                        occurrence.declares, occurrence.access, line};
            }
        ADD_FAILURE() << "nothing at " << marked;
        return {NameKind::unknown, nullptr, "", false, Access::none, 0};
    }

    std::string text_;
    std::unique_ptr<testing::Reading> reading_;
    std::vector<Occurrence> list_;
};

TEST_F(Occurrences, OfVariablesSayHowTheyAreUsed) {
    load(
        "stm S {\n"
        "  var x : nat = 1\n"
        "  event e : nat\n"
        "  clock C\n"
        "  initial i\n"
        "  state A { entry x = x + 2 }\n"
        "  transition t { from i to A }\n"
        "  transition u { from A to A trigger e?x #C condition since(C) < 3 action send e!x }\n"
        "}\n");
    ASSERT_TRUE(reading_->findings.ok()) << reading_->report();
    EXPECT_TRUE(at("var @x").declares);
    EXPECT_EQ(at("entry @x").access, Access::write);
    EXPECT_EQ(at("= @x +").access, Access::read);
    EXPECT_EQ(at("= @x +").line, 2U);
    EXPECT_EQ(at("e?@x").access, Access::write);
    EXPECT_EQ(at("trigger @e").access, Access::read);
    EXPECT_EQ(at("send @e").access, Access::write);
    EXPECT_EQ(at("e!@x").access, Access::read);
    EXPECT_EQ(at("#@C").access, Access::write);
    EXPECT_EQ(at("since(@C").line, 4U);
    EXPECT_EQ(at("from @A").line, 6U);
    EXPECT_EQ(at("x : @nat").kind, NameKind::core_type);
}

TEST_F(Occurrences, OfQualifiedNamesPointAtTheirOwnTargets) {
    load(
        "package p\n"
        "enumeration E { red green }\n"
        "interface I { var c : p::E }\n"
        "datatype R { hue : E }\n"
        "stm S {\n"
        "  requires p::I\n"
        "  var r : R\n"
        "  initial i state A { entry c = E::red; r = R(| hue = p::E::green |); r.hue = c }\n"
        "  transition t { from i to A }\n"
        "}\n");
    ASSERT_TRUE(reading_->findings.ok()) << reading_->report();
    EXPECT_EQ(at(": @p::E }").kind, NameKind::package);
    EXPECT_EQ(at(": @p::E }").text, "p");
    EXPECT_EQ(at(": p::@E }").line, 2U);
    EXPECT_EQ(at("@E::red").line, 2U);
    EXPECT_EQ(at("E::@red").target->kind, DeclKind::enum_literal);
    EXPECT_EQ(at("@p::E::green").kind, NameKind::package);
    EXPECT_EQ(at("p::@E::green").target->kind, DeclKind::enumeration);
    EXPECT_EQ(at("requires p::@I").line, 3U);
}

TEST_F(Occurrences, OfFieldsPointAtTheRecord) {
    load(
        "datatype R { hue : nat }\n"
        "stm S {\n"
        "  var r : R\n"
        "  initial i state A { entry r = R(| hue = 2 |); r.hue = 1 }\n"
        "  transition t { from i to A }\n"
        "}\n");
    EXPECT_EQ(at("R(| @hue").line, 1U);
    EXPECT_EQ(at("r.@hue").line, 1U);
    EXPECT_EQ(at("r.@hue").target->kind, DeclKind::field);
    EXPECT_EQ(at("; @r.hue").access, Access::write);
}

TEST_F(Occurrences, FollowReferencesAlongPathsInAssertions) {
    testing::Reading both;
    const auto model = both.sources.add("m.rct",
                                        "package p\n"
                                        "robotic platform Rob { event e }\n"
                                        "stm S { event e initial i state A { } transition t { from i to A } }\n"
                                        "controller C { event e sref s = S connection C on e to s on e }\n"
                                        "module M { rref r = Rob cref c = C connection r on e to c on e (_async) }\n");
    text_ =
        "import p::*\n"
        "assertion A1 : p::M::c::s::A is reachable in p::M\n"
        "assertion A2 : M refines Spec\n"
        "csp Spec associated to M csp-begin Spec = STOP csp-end\n";
    const auto claims = both.sources.add("m.assertions", text_);
    both.model.files.push_back(parse(both.sources, model, false, both.findings));
    both.model.files.push_back(parse(both.sources, claims, true, both.findings));
    resolve(both.model, both.findings);
    ASSERT_TRUE(both.findings.ok()) << both.report();
    list_ = find_occurrences(both.model);
    std::erase_if(list_, [&](const Occurrence& o) { return o.span.source != claims; });
    reading_ = std::make_unique<testing::Reading>(std::move(both));
    EXPECT_EQ(at("import @p").text, "p");
    EXPECT_EQ(at("@p::M::c").kind, NameKind::package);
    EXPECT_EQ(at("p::@M::c").target->kind, DeclKind::module);
    EXPECT_EQ(at("M::@c::s").target->kind, DeclKind::reference);
    EXPECT_EQ(at("c::@s::A").line, 4U);
    EXPECT_EQ(at("s::@A is").target->kind, DeclKind::state);
    EXPECT_EQ(at("refines @Spec").kind, NameKind::process);
    EXPECT_TRUE(at("csp @Spec").declares);
    EXPECT_EQ(at("to @M csp").target->kind, DeclKind::module);
    EXPECT_TRUE(at("assertion @A1").declares);
}

/// Returns true for words that assertion files reserve only in some positions.
bool is_assertion_word(std::string_view word) {
    static const std::set<std::string_view> words = {
        "assertion", "csp",       "timed",     "untimed",  "associated",  "deadlock",   "divergence", "timelock",
        "free",      "terminate", "does",      "refine",   "refines",     "equals",     "equal",      "deterministic",
        "reachable", "model",     "traces",    "failures", "divergences", "tick",       "tock",       "initialised",
        "with",      "constant",  "parameter", "of",       "set",         "value",      "assigned",   "and",
        "missed",    "for",       "time",      "unit",     "units",       "prob",       "property",   "Prob",
        "Reward",    "Finally",   "Reachable", "label",    "rewards",     "endrewards", "constants",  "by",
        "step",      "sleec",     "conforms",  "conform"};
    return words.contains(word);
}

/// Returns the positions of names without an occurrence, outside package and diagram clauses.
std::string uncovered(const std::string& path) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const auto model = load_project(sources, path, findings);
    std::set<std::pair<diagnostics::SourceId, std::uint32_t>> covered;
    for (const Occurrence& occurrence : find_occurrences(*model))
        covered.insert({occurrence.span.source, occurrence.span.begin});
    std::string missing;
    for (const auto& file : model->files) {
        if (file->is_library || file->has_syntax_errors) continue;
        // SLEEC rules are declared in separate files.
        for (const Assertion& assertion : file->assertions)
            if (assertion.kind == AssertionKind::conforms)
                for (const auto& span : assertion.other.spans) covered.insert({span.source, span.begin});
        diagnostics::Diagnostics ignored;
        Token before;
        const TokenStream stream = tokenize(sources, file->source, file->is_assertions, ignored);
        for (const Token& token : stream.tokens) {
            const bool diagram = before.is_word("diagram");
            const bool word = file->is_assertions && is_assertion_word(token.text);
            if (token.kind == TokenKind::identifier && !diagram && !word &&
                !covered.contains({file->source, token.span.begin}))
                missing += sources.path_and_line(token.span) + " " + std::string(token.text) + "\n";
            before = token;
        }
    }
    return missing;
}

TEST(OccurrencesOfAll, CoverEveryNameOfTheCorpus) {
    for (const auto& entry : std::filesystem::directory_iterator(tests::source_folder().string() + "/corpus"))
        EXPECT_EQ(uncovered(entry.path().string()), "") << entry.path();
}

TEST(OccurrencesOfAll, CoverEveryNameOfTheSuites) {
    const auto shared = testing::shared_folder();
    if (shared.empty()) GTEST_SKIP() << "the shared material is absent";
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(shared / "suite"))
        if (entry.path().extension() == ".rct") {
            const std::string missing = uncovered(entry.path().string());
            EXPECT_EQ(missing, "") << entry.path();
            ++files;
        }
    EXPECT_GT(files, 10U);
}

}  // namespace
}  // namespace robochart::frontend
