// SPDX-License-Identifier: Apache-2.0
// Tests how RoboTool's files are read as data, and how invalid files are rejected.
#include "frontend/diagrams/stored/aird.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/frontend/diagrams/stored/aird_text.hpp"

namespace robochart::diagrams {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

TEST(Aird, HasElementsShapesAndLines) {
    const Aird aird = read_aird(aird_text(aird_diagram(
        element(
            "e1", "S", "a.rct#//@machines.0", "StateMachineID",
            "<ownedElements xmi:id=\"e2\" name=\"A\"><target href=\"a.rct#//@machines.0/@nodes.0\"/></ownedElements>"
            "<ownedBorderedNodes uid=\"e3\" name=\"e: nat\"/>") +
            line_element("t", "x", "a.rct#//@machines.0/@transitions.0", "TransitionID", "e2", "e3"),
        shape(2002, "e1", "x=\"-3\" height=\"40\"", shape(3008, "e2", "y=\"7\" width=\"12\"")),
        line("t", "[1, -2, 3, 4]$[5, 6, 7, 8]",
             "<sourceAnchor id=\"(0.25,1.0)\"/><targetAnchor id=\"BOTTOM\"/>"
             "<children type=\"6001\"><layoutConstraint x=\"9\" y=\"-10\"/></children>"
             "<children type=\"6002\"><layoutConstraint x=\"1\" y=\"1\"/></children>"))));
    EXPECT_EQ(aird.error, "");
    ASSERT_THAT(aird.diagrams, SizeIs(1));
    const AirdDiagram& diagram = aird.diagrams[0];
    EXPECT_THAT(diagram.elements, SizeIs(4));
    EXPECT_EQ(diagram.elements.at("e1").mapping, "StateMachineID");
    EXPECT_EQ(diagram.elements.at("e2").href, "a.rct#//@machines.0/@nodes.0");
    EXPECT_EQ(diagram.elements.at("e3").name, "e: nat");
    EXPECT_EQ(diagram.elements.at("t").source, "e2");
    EXPECT_EQ(diagram.elements.at("t").target, "e3");
    ASSERT_THAT(diagram.shapes, SizeIs(2));
    EXPECT_EQ(diagram.shapes[0].x, -3);
    EXPECT_EQ(diagram.shapes[0].y, std::nullopt);
    EXPECT_EQ(diagram.shapes[0].height, 40);
    EXPECT_EQ(diagram.shapes[1].parent, 0U);
    EXPECT_EQ(diagram.shapes[1].width, 12);
    ASSERT_THAT(diagram.lines, SizeIs(1));
    const layout::DrawnEdge& route = diagram.lines[0].route;
    ASSERT_THAT(route.bends, SizeIs(2));
    EXPECT_EQ(route.bends[0].from_source, (layout::Point{1, -2}));
    EXPECT_EQ(route.bends[1].from_target, (layout::Point{7, 8}));
    EXPECT_EQ(route.source_anchor, (layout::Point{0.25, 1}));
    EXPECT_EQ(route.target_anchor, (layout::Point{0.5, 0.5}));
    EXPECT_EQ(route.label, (layout::Point{9, -10}));
    EXPECT_TRUE(route.right_angled);
}

/// Old files have `xsi:type`, and contain other elements of Sirius in between.
TEST(Aird, KnowsOldFiles) {
    const Aird aird = read_aird(
        "<x:XMI xmlns:x=\"x\" xmlns:xsi=\"i\"><d:DSemanticDiagram xmlns:d=\"d\" xmi:id=\"q\" xmlns:xmi=\"m\">"
        "<ownedAnnotationEntries><data xsi:type=\"diagram:Registry\"/></ownedAnnotationEntries>"
        "<ownedAnnotationEntries><data xsi:type=\"notation:Diagram\"><children type=\"2001\" element=\"a\"/></data>"
        "</ownedAnnotationEntries></d:DSemanticDiagram></x:XMI>");
    EXPECT_EQ(aird.error, "");
    ASSERT_THAT(aird.diagrams, SizeIs(1));
    EXPECT_THAT(aird.diagrams[0].shapes, SizeIs(1));
}

TEST(Aird, OfAnEmptyProjectHasNoDiagrams) {
    const Aird aird = read_aird(aird_text(""));
    EXPECT_EQ(aird.error, "");
    EXPECT_THAT(aird.diagrams, IsEmpty());
}

struct Hostile {
    const char* name;
    std::string text;
    const char* error;
};

void PrintTo(const Hostile& hostile, std::ostream* out) {
    *out << hostile.name;
}

std::string nested(std::size_t depth) {
    std::string text;
    for (std::size_t i = 0; i < depth; ++i) text += "<children type=\"3008\">";
    for (std::size_t i = 0; i < depth; ++i) text += "</children>";
    return text;
}

std::string many_points() {
    std::string points = "[1, 2, 3, 4]";
    for (int i = 0; i < 1000; ++i) points += "$[1, 2, 3, 4]";
    return points;
}

std::string with_points(const std::string& points) {
    return aird_text(aird_diagram("", "", line("t", points)));
}

class HostileAird : public ::testing::TestWithParam<Hostile> {};

TEST_P(HostileAird, IsRefusedWithTheCause) {
    const Aird aird = read_aird(GetParam().text);
    EXPECT_THAT(aird.error, HasSubstr(GetParam().error));
    EXPECT_THAT(aird.diagrams, IsEmpty());
    EXPECT_LE(aird.offset, GetParam().text.size());
}

INSTANTIATE_TEST_SUITE_P(
    Texts, HostileAird,
    ::testing::Values(
        Hostile{"entities",
                "<!DOCTYPE x [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;\">]><x>&b;</x>",
                "document type"},
        Hostile{"external", "<!DOCTYPE x SYSTEM \"file:///etc/passwd\"><x/>", "document type"},
        Hostile{"undeclared_entity", "<x>&passwd;</x>", "undefined entity"},
        Hostile{"depth", aird_text(aird_diagram("", nested(500))), "nested more than"},
        Hostile{"truncated", aird_text("").substr(0, 200), "ends before"},
        Hostile{"cut_in_a_tag", "<x><y a=\"1", "ends before"}, Hostile{"empty", "", "empty"},
        Hostile{"no_xml", "module M { }", "not XML"}, Hostile{"crossed", "<x><y></x></y>", "mismatched"},
        Hostile{"latin", "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?><x/>", "ISO-8859-1"},
        Hostile{"bytes", "<x a=\"\xff\xfe\"/>", "UTF-8"}, Hostile{"zero", std::string("<x>\0</x>", 8), "UTF-8"},
        Hostile{"huge_number", aird_text(aird_diagram("", shape(2002, "a", "x=\"99999999999999999999\""))),
                "out of range"},
        Hostile{"overflow", aird_text(aird_diagram("", shape(2002, "a", "x=\"1e999\""))), "out of range"},
        Hostile{"no_number", aird_text(aird_diagram("", shape(2002, "a", "x=\"nan\""))), "out of range"},
        Hostile{"word", aird_text(aird_diagram("", shape(2002, "a", "width=\"wide\""))), "number"},
        Hostile{"many_points", with_points(many_points()), "more than 1000 bends"},
        Hostile{"points", with_points("[1, 2, 3]"), "expected ','"},
        Hostile{"points_without_end", with_points("[1, 2, 3, 4"), "expected ']'"},
        Hostile{"points_apart", with_points("[1, 2, 3, 4][1, 2, 3, 4]"), "expected '$'"}),
    [](const auto& hostile) { return hostile.param.name; });

TEST(Aird, IsNotReadAboveItsLength) {
    EXPECT_THAT(read_aird(std::string(longest_aird + 1, ' ')).error, HasSubstr("longer than 64 MiB"));
}

TEST(Aird, SaysWhereItIsWrong) {
    const std::string text = aird_text(aird_diagram("", shape(2002, "a", "x=\"1e9\"")));
    const Aird aird = read_aird(text);
    EXPECT_THAT(text.substr(aird.offset), StartsWith("<layoutConstraint"));
}

TEST(Aird, ReadingPollsTheBudget) {
    diagnostics::Limits limits;
    limits.interrupted = [] { return true; };
    diagnostics::Budget budget(limits);
    EXPECT_THROW((void)read_aird(aird_text(""), &budget), diagnostics::LimitReached);
}

/// Ids that refer to themselves, to each other or to no element are only used as names.
TEST(Aird, FollowsNoIds) {
    const Aird aird = read_aird(aird_text(
        aird_diagram(line_element("a", "a", "#a", "a", "b", "a") + line_element("b", "b", "#b", "b", "a", "b"),
                     shape(2002, "a", "", shape(2002, "a", "", shape(2002, "b", ""))), line("a", "") + line("c", ""))));
    EXPECT_EQ(aird.error, "");
    EXPECT_THAT(aird.diagrams[0].elements, SizeIs(2));
}

}  // namespace
}  // namespace robochart::diagrams
