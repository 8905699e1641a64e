// SPDX-License-Identifier: Apache-2.0
// Tests the five libraries of the language (language reference 1.3), and that the order of files and declarations does
// not matter.
#include "frontend/toolkits/toolkits.hpp"
#include "frontend/syntax/parse.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <sstream>

#include "tests/frontend/fixture.hpp"

namespace robochart::frontend {
namespace {

namespace fs = std::filesystem;

std::set<std::string> words(const std::string& text) {
    std::istringstream in(text);
    return {std::istream_iterator<std::string>(in), {}};
}

/// The published names, including their spelling.
const std::map<std::string_view, std::string> published = {
    {"core", "nat int real boolean string"},
    {"set_toolkit", "notin subseteq subset union inter diff symetric_diff Union Inter"},
    {"relation_toolkit",
     "first second maplet dom ran id relcomp funcomp dres rres dsub rsub rinv rimage override tr_closure "
     "refl_tr_closure"},
    {"function_toolkit",
     "isTotal isInjection isTotalInjection isSurjection isTotalSurjection isBijection isFinite isFiniteFunction "
     "isFiniteInjection disjoint partitions"},
    {"sequence_toolkit",
     "range iter size hasMin hasMax min max isNonEmpty isInjectiveSequence concat reverse head last tail front squash "
     "extract filter prefix suffix infix dconcat"}};

TEST(Library, HasEveryPublishedName) {
    ASSERT_EQ(all_toolkits().size(), published.size());
    for (const Toolkit& toolkit : all_toolkits()) {
        const auto reading = testing::read(std::string(toolkit.text));
        EXPECT_TRUE(reading->findings.empty()) << toolkit.package << "\n" << reading->report();
        EXPECT_EQ(reading->file().package.text(), toolkit.package);
        std::set<std::string> declared;
        for (const auto& declaration : reading->file().declarations) declared.insert(declaration->name);
        EXPECT_EQ(declared, words(published.at(toolkit.package))) << toolkit.package;
    }
}

TEST(Library, ResolvesWithoutAFinding) {
    const auto reading = testing::resolved(
        "import set_toolkit::* import relation_toolkit::* import function_toolkit::* import sequence_toolkit::* type "
        "T");
    EXPECT_TRUE(reading->findings.empty()) << reading->report();
    EXPECT_EQ(reading->model.files.size(), 1 + published.size());
}

/// `last(<>)` has an unknown type, which fits everywhere, also for matrices.
TEST(Library, WhatMayBeOfEveryTypeCanBeTurned) {
    const auto reading = testing::resolved(
        "import sequence_toolkit::* function f() : matrix(real, 2, 2) { "
        "postcondition result == inverse(last(<>)) postcondition result == transpose(last(<>)) }");
    EXPECT_EQ(reading->findings.error_count(), 0U) << reading->report();
    const auto wrong = testing::resolved(
        "import sequence_toolkit::* function f() : matrix(real, 2, 2) { "
        "postcondition result == inverse(last(<1>)) postcondition result == transpose(last(<1>)) }");
    EXPECT_EQ(wrong->findings.error_count(), 0U) << wrong->report();
    EXPECT_EQ(wrong->findings.warning_count(), reading->findings.warning_count() + 2) << wrong->report();  // RC-T36
}

TEST(Library, CoreNeedsNoImportAndIsDeclaredSomewhere) {
    const auto reading = testing::resolved("interface I { var a:nat, b:core::boolean }");
    EXPECT_TRUE(reading->findings.empty()) << reading->report();
    const auto& interface = dynamic_cast<const Context&>(*reading->file().declarations.at(0));
    ASSERT_NE(interface.variables[0]->type_expr->target, nullptr);
    EXPECT_EQ(interface.variables[0]->type_expr->target->name, "nat");
    EXPECT_EQ(interface.variables[1]->type_expr->target->name, "boolean");
    EXPECT_TRUE(reading->model.files.back()->is_library);
}

// ---------------------------------------------------------------- order

/// A project as the declarations of its files. Some declarations contain mistakes, so that there are findings.
const std::vector<std::pair<std::string, std::vector<std::string>>> project = {
    {"package a\nimport b::*\n",
     {"interface I { event e:T var v:nat }",
      "stm S { uses I initial i state s { entry v = 1.5 } transition t { from i to s } }",
      "interface J { var w:Unknown }", "function f(x:T):T { postcondition result == x }"}},
    {"package b\n", {"type T", "enumeration E { L M }", "interface K { event g:E const k:E = L }"}},
    {"",
     {"stm U { requires b::K initial i state s { } transition t { from i to s condition k == M } }", "type V",
      "controller C { sref r = S connection C on e to r on e }", "type V"}},
};

using Order = std::vector<std::vector<std::size_t>>;

/// Returns the findings as text without places, for files and declarations in the given order.
std::multiset<std::string> findings_of(const std::vector<std::size_t>& files, const Order& order) {
    testing::Reading reading;
    for (const std::size_t f : files) {
        std::string text = project[f].first;
        for (const std::size_t d : order[f]) text += project[f].second[d] + "\n";
        const auto id = reading.sources.add("f" + std::to_string(f) + ".rct", std::move(text));
        reading.model.files.push_back(parse(reading.sources, id, false, reading.findings));
    }
    add_toolkits(reading.sources, reading.model, reading.findings);
    resolve(reading.model, reading.findings);
    std::multiset<std::string> result;
    for (const auto& d : reading.findings.sorted_findings())
        result.insert(std::string(d.rule->code) + " " + d.message());
    return result;
}

TEST(Order, FilesAndDeclarationsHaveNoOrder) {
    std::vector<std::size_t> files(project.size());
    Order order(project.size());
    for (std::size_t f = 0; f < project.size(); ++f) {
        files[f] = f;
        for (std::size_t d = 0; d < project[f].second.size(); ++d) order[f].push_back(d);
    }
    const auto expected = findings_of(files, order);
    EXPECT_GE(expected.size(), 4U);
    std::mt19937 random(7);  // a fixed seed: the same shuffles in every run
    for (int round = 0; round < 200; ++round) {
        std::shuffle(files.begin(), files.end(), random);
        for (auto& list : order) std::shuffle(list.begin(), list.end(), random);
        EXPECT_EQ(findings_of(files, order), expected);
    }
}

}  // namespace
}  // namespace robochart::frontend
