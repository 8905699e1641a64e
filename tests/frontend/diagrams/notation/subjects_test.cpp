// SPDX-License-Identifier: Apache-2.0
// Tests which elements of a model have a diagram, and the names of the files.
#include "frontend/diagrams/notation/subjects.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "tests/random_models/models/project.hpp"

namespace robochart::diagrams {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

std::vector<std::pair<std::string, std::string>> names_of(const random_models::Project& project) {
    const auto loaded = random_models::load(project);
    std::vector<std::pair<std::string, std::string>> names;
    for (const Subject& subject : find_subjects(loaded->model, loaded->sources))
        names.emplace_back(subject.name, subject.file);
    return names;
}

TEST(Subjects, AreComponentsAndPackages) {
    EXPECT_THAT(names_of({{"a.rct",
                           "package p\ninterface I { event e }\nstm S { initial i }\noperation op() { initial i }\n"
                           "controller C { stm Inner { initial i } sref s = S }\nmodule M { robotic platform P { } "
                           "cref c = C }\n"}}),
                ElementsAre(Pair("p::S", "S"), Pair("p::op", "op"), Pair("p::C", "C"), Pair("p::C::Inner", "Inner"),
                            Pair("p::M", "M"), Pair("p::M::P", "P"), Pair("p", "p_types")));
}

/// The file names differ even on file systems that ignore case.
TEST(Subjects, HaveFilesOfTheirOwn) {
    EXPECT_THAT(names_of({{"a.rct", "package p\nstm S { initial i }\nstm T { initial i }\n"},
                          {"b.rct", "package q\nstm s { initial i }\n"}}),
                ElementsAre(Pair("p::S", "p__S"), Pair("p::T", "T"), Pair("q::s", "q__s")));
}

TEST(Subjects, OfPackagesWithoutANameAreCalledByTheirFile) {
    EXPECT_THAT(names_of({{"folder/types.rct", "enumeration E { one }\n"}}), ElementsAre(Pair("types", "types_types")));
}

TEST(Elements, HaveOneIdInTheOrderOfTheText) {
    const auto loaded =
        random_models::load({{"a.rct", "stm S { initial i state s { entry skip } transition t { from i to s } }\n"}});
    const Elements elements(loaded->model);
    std::vector<std::pair<std::string, std::string>> found;
    for (const Element& element : elements.all_elements())
        found.emplace_back(element.id, element.kind + " " + element.name);
    EXPECT_THAT(found, ElementsAre(Pair("e1", "state machine S"), Pair("e2", "initial junction i"),
                                   Pair("e3", "state s"), Pair("e4", "entry action "), Pair("e5", "transition t")));
    EXPECT_EQ(Elements(loaded->model, 10).all_elements().front().id, "e10");
}

}  // namespace
}  // namespace robochart::diagrams
