// SPDX-License-Identifier: Apache-2.0
// Tests which files belong together (frontend/project/units.hpp).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "frontend/project/project.hpp"
#include "frontend/project/units.hpp"
#include "frontend/syntax/parse.hpp"
#include "frontend/toolkits/toolkits.hpp"

namespace robochart::frontend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

struct Text {
    std::string path, text;
};

/// Returns the paths of each unit's files. A prefix marks files with `again`.
std::vector<std::vector<std::string>> units_of(const std::vector<Text>& texts) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    Model model;
    for (const Text& text : texts)
        model.files.push_back(
            parse(sources, sources.add(text.path, text.text), text.path.ends_with(".assertions"), diagnostics));
    add_toolkits(sources, model, diagnostics);
    resolve(model, diagnostics);
    EXPECT_TRUE(diagnostics.ok());
    std::vector<std::vector<std::string>> result;
    for (const Unit& unit : split_into_units(model)) {
        result.emplace_back();
        if (unit.again) result.back().emplace_back("again");
        for (const std::size_t file : unit.files) result.back().push_back(sources.path(model.files[file]->source));
    }
    return result;
}

const std::string body = "initial i state A { } transition t { from i to A } }";
const std::string s = "stm S { " + body;
const std::string t = "stm T { " + body;

TEST(Units, WhatRefersToNothingElseIsApart) {
    EXPECT_THAT(units_of({{"a.rct", s}, {"b.rct", t}}), ElementsAre(ElementsAre("a.rct"), ElementsAre("b.rct")));
    // Files that share only a library of the tool are not connected.
    EXPECT_THAT(units_of({{"a.rct", "import set_toolkit::* " + s}, {"b.rct", "import set_toolkit::* " + t}}),
                ElementsAre(ElementsAre("a.rct"), ElementsAre("b.rct")));
}

TEST(Units, ReferencesImportsAndPackagesTie) {
    EXPECT_THAT(units_of({{"a.rct", s}, {"b.rct", t}, {"c.rct", "controller C { sref s = S }"}}),
                ElementsAre(ElementsAre("a.rct", "c.rct"), ElementsAre("b.rct")));
    EXPECT_THAT(units_of({{"a.rct", "package P " + s}, {"b.rct", "package P " + t}}),
                ElementsAre(ElementsAre("a.rct", "b.rct")));
    EXPECT_THAT(units_of({{"a.rct", "package P " + s}, {"b.rct", "import P::* " + t}, {"c.rct", "stm U { " + body}}),
                ElementsAre(ElementsAre("a.rct", "b.rct"), ElementsAre("c.rct")));
}

TEST(Units, AssertionFilesBelongToWhatTheyAreAbout) {
    EXPECT_THAT(units_of({{"a.rct", s}, {"b.rct", t}, {"x.assertions", "assertion A : T is deadlock-free"}}),
                ElementsAre(ElementsAre("a.rct"), ElementsAre("b.rct", "x.assertions")));
    EXPECT_THAT(units_of({{"a.rct", s}, {"b.rct", t}, {"x.assertions", "csp Q csp-begin\nQ = T::D__(0)\ncsp-end"}}),
                ElementsAre(ElementsAre("a.rct"), ElementsAre("b.rct", "x.assertions")));
    // An assertion file that names no component applies to all models.
    EXPECT_THAT(units_of({{"a.rct", s},
                          {"b.rct", t},
                          {"x.assertions", "csp Instantiations csp-begin\nnametype core_nat = {0..3}\ncsp-end"}}),
                ElementsAre(ElementsAre("a.rct", "b.rct", "x.assertions")));
}

// Independent projects may use the same names. A name denotes the nearest element.
TEST(Units, TheNearestOfOneNameIsMeant) {
    const std::string claim = "assertion A : S is deadlock-free";
    EXPECT_THAT(
        units_of({{"/p/a/m.rct", s}, {"/p/a/m.assertions", claim}, {"/p/b/m.rct", s}, {"/p/b/m.assertions", claim}}),
        ElementsAre(ElementsAre("/p/a/m.rct", "/p/a/m.assertions"), ElementsAre("/p/b/m.rct", "/p/b/m.assertions")));
    EXPECT_THAT(units_of({{"/p/a/m.rct", "package P " + s},
                          {"/p/b/m.rct", "package P " + s},
                          {"/p/b/x/n.rct", "import P::S controller C { sref s = S }"}}),
                ElementsAre(ElementsAre("/p/a/m.rct"), ElementsAre("/p/b/m.rct", "/p/b/x/n.rct")));
    EXPECT_THAT(
        units_of(
            {{"/p/a/m.rct", s}, {"/p/b/m.rct", s}, {"/p/b/x.assertions", "csp Q csp-begin\nQ = S::D__(0)\ncsp-end"}}),
        ElementsAre(ElementsAre("/p/a/m.rct"), ElementsAre("/p/b/m.rct", "/p/b/x.assertions")));
    EXPECT_THAT(units_of({{"/p/a/m.rct", s},
                          {"/p/b/m.rct", t},
                          {"/p/b/x.assertions", "csp Instantiations csp-begin\nnametype core_nat = {0..3}\ncsp-end"}}),
                ElementsAre(ElementsAre("/p/a/m.rct"), ElementsAre("/p/b/m.rct", "/p/b/x.assertions")));
    // A controller refers to its own machine, not to a machine of another controller with the same name.
    EXPECT_THAT(units_of({{"/p/a/m.rct", "controller C { sref s = S } " + s},
                          {"/p/b/m.rct", "controller C { stm S { " + body + " }"}}),
                ElementsAre(ElementsAre("/p/a/m.rct"), ElementsAre("/p/b/m.rct")));
    // A nearby element that is imported has precedence over a more distant element outside packages.
    EXPECT_THAT(
        units_of({{"/p/a/m.rct", s}, {"/p/b/m.rct", "package P " + s}, {"/p/b/m.assertions", "import P::* " + claim}}),
        ElementsAre(ElementsAre("/p/a/m.rct"), ElementsAre("/p/b/m.rct", "/p/b/m.assertions")));
    EXPECT_THAT(units_of({{"/p/a/m.rct", s},
                          {"/p/b/m.rct", "controller C { stm S { " + body + " }"},
                          {"/p/b/x.assertions", "csp Q csp-begin\nQ = C::S::D__(0)\ncsp-end"}}),
                ElementsAre(ElementsAre("/p/a/m.rct"), ElementsAre("/p/b/m.rct", "/p/b/x.assertions")));
    // The name is ambiguous, so all these files form one unit, and the rules report the name.
    EXPECT_THAT(units_of({{"/p/a.rct", s}, {"/p/b.rct", s}, {"/p/x.assertions", claim}}),
                ElementsAre(ElementsAre("/p/a.rct", "/p/b.rct", "/p/x.assertions")));
}

TEST(Units, AFileWithMistakesBelongsToThoseBesideIt) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    Model model;
    for (const Text& text : {Text{"/p/a/m.rct", "stm S { initial"}, Text{"/p/a/n.rct", t}, Text{"/p/b/m.rct", t}})
        model.files.push_back(parse(sources, sources.add(text.path, text.text), false, diagnostics));
    resolve(model, diagnostics);
    EXPECT_THAT(group_files(model), ElementsAre(ElementsAre(0U, 1U), ElementsAre(2U)));
}

TEST(Units, EachInstantiationIsAUnit) {
    const auto given = [](int most) {
        return "csp Instantiations csp-begin\nnametype core_nat = {0.." + std::to_string(most) +
               "}\ncsp-end\nassertion A : S is deadlock-free";
    };
    const std::string plain = "assertion B : S is deterministic";
    EXPECT_THAT(units_of({{"a.rct", s}, {"x.assertions", given(1)}, {"y.assertions", plain}}),
                ElementsAre(ElementsAre("a.rct", "x.assertions", "y.assertions")));
    EXPECT_THAT(units_of({{"a.rct", s}, {"x.assertions", given(1)}, {"y.assertions", given(1)}}),
                ElementsAre(ElementsAre("a.rct", "x.assertions", "y.assertions")));
    EXPECT_THAT(
        units_of({{"a.rct", s}, {"x.assertions", given(1)}, {"y.assertions", plain}, {"z.assertions", given(2)}}),
        ElementsAre(ElementsAre("a.rct", "x.assertions"), ElementsAre("again", "a.rct", "y.assertions"),
                    ElementsAre("again", "a.rct", "z.assertions")));
    EXPECT_THAT(units_of({}), IsEmpty());
}

}  // namespace
}  // namespace robochart::frontend
