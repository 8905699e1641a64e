// SPDX-License-Identifier: Apache-2.0
// Tests components with a layout that was drawn in RoboTool. The coordinates follow from the file format
// (docs/diagrams.md). Places of nodes are relative to their area, whose border is 5 pixels away. Ends of lines are
// relative to anchors.
#include "frontend/diagrams/stored/stored_diagrams.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/diagnostics/splitmix64.hpp"
#include "frontend/diagrams/notation/subjects.hpp"
#include "frontend/diagrams/stored/rules.hpp"
#include "tests/frontend/diagrams/stored/aird_text.hpp"
#include "tests/random_models/models/project.hpp"
#include "tests/rounds.hpp"
#include "tests/temporary_folder.hpp"

namespace robochart::diagrams {
namespace {

using layout::Point;
using layout::Rectangle;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Pictures are shifted to their margins by widths of text, so sums of coordinates are not exact.
MATCHER_P(IsNear, point, "") {
    *result_listener << arg.x << ", " << arg.y;
    return std::abs(arg.x - point.x) < 0.001 && std::abs(arg.y - point.y) < 0.001;
}

/// A model with a file of diagrams next to it.
class Stored {
public:
    Stored(const std::string& model, const std::string& aird)
        : Stored(random_models::Project{{"p/a.rct", model}}, aird) {}
    Stored(const random_models::Project& project, const std::string& text)
        : loaded_(random_models::load(project)), elements_(loaded_->model) {
        const Aird aird = read_aird(text);
        EXPECT_EQ(aird.error, "");
        diagrams_.add(aird, "p/representations.aird", loaded_->model, loaded_->sources, nullptr);
    }

    [[nodiscard]] const frontend::Declaration* component(const std::string& name) const {
        for (const Subject& subject : find_subjects(loaded_->model, loaded_->sources))
            if (subject.name == name) return subject.component;
        ADD_FAILURE() << "no component " << name;
        return nullptr;
    }
    [[nodiscard]] const StoredDiagram* diagram(const std::string& name) const {
        return diagrams_.diagram_of(component(name));
    }
    [[nodiscard]] Picture draw(const std::string& name) const {
        for (const Subject& subject : find_subjects(loaded_->model, loaded_->sources))
            if (subject.name == name)
                return diagrams::draw_subject(subject,
                                              {elements_, nullptr, nullptr, diagrams_.find(subject.component)});
        ADD_FAILURE() << "no component " << name;
        return {};
    }
    /// Returns the codes and messages of the findings about a component.
    [[nodiscard]] std::vector<std::string> findings_about(const std::string& name) const {
        diagnostics::Diagnostics out;
        diagrams_.explain_mismatch(component(name), out);
        std::vector<std::string> result;
        for (const diagnostics::Diagnostic& finding : out.sorted_findings())
            result.push_back(std::string(finding.rule->code) + " " + finding.message());
        return result;
    }
    /// Returns the box of an element, by its name in the model.
    [[nodiscard]] const PictureBox& box(const Picture& picture, const std::string& name) const {
        for (const PictureBox& box : picture.boxes)
            if (box.element != none && elements_.all_elements()[box.element].name == name) return box;
        throw std::runtime_error("no box " + name);
    }
    [[nodiscard]] const PictureLine& line(const Picture& picture, const std::string& name) const {
        for (const PictureLine& line : picture.lines)
            if (line.element != none && elements_.all_elements()[line.element].name == name) return line;
        throw std::runtime_error("no line " + name);
    }

private:
    std::unique_ptr<random_models::Loaded> loaded_;
    Elements elements_;
    StoredDiagrams diagrams_;
};

constexpr const char* patrol =
    "interface Sensors { event obstacle: nat }\n"
    "stm Patrol {\n uses Sensors\n var speed: real\n initial start\n state Going { entry speed = 1.0 }\n"
    " state Avoiding {\n  initial inner\n  state Turning { }\n  transition t3 { from inner to Turning }\n }\n"
    " transition t0 { from start to Going }\n transition t1 { from Going to Avoiding trigger obstacle }\n"
    " transition t2 { from Avoiding to Going }\n}\n";

/// Returns a reference to an element of the machine.
std::string of_machine(const std::string& path) {
    return "a.rct#//@machines.0" + path;
}

std::string node(const std::string& id, const std::string& name, const std::string& path, const std::string& mapping,
                 const std::string& inner = "") {
    return element(id, name, of_machine(path), mapping, inner);
}

std::string state_areas(const std::string& id, const std::string& path) {
    return node(id + "a", "", path, "ActionsID") + node(id + "n", "", path, "NodesID");
}

std::string patrol_elements() {
    return node("m", "Patrol", "", "StateMachineID") + node("mc", "", "", "ContextID") + node("mn", "", "", "NodesID") +
           element("ev", "obstacle: nat", "a.rct#//@interfaces.0/@events.0", "BorderedEventID") +
           node("start", "start", "/@nodes.0", "InitialID") + node("going", "Going", "/@nodes.1", "StateID") +
           state_areas("going", "/@nodes.1") + node("avoiding", "Avoiding", "/@nodes.2", "StateID") +
           state_areas("avoiding", "/@nodes.2") + node("inner", "inner", "/@nodes.2/@nodes.0", "InitialID") +
           node("turning", "Turning", "/@nodes.2/@nodes.1", "StateID") +
           line_element("t0", "", of_machine("/@transitions.0"), "TransitionID", "start", "going") +
           line_element("t1", "obstacle", of_machine("/@transitions.1"), "TransitionID", "going", "avoiding") +
           line_element("t2", "", of_machine("/@transitions.2"), "TransitionID", "avoiding", "going") +
           line_element("t3", "", of_machine("/@nodes.2/@transitions.0"), "TransitionID", "inner", "turning");
}

std::string state_shape(const std::string& id, const std::string& bounds, const std::string& areas) {
    return shape(3008, id, bounds, container(areas));
}

/// Returns an area of 20 pixels for actions, and below it an area for nodes.
std::string areas(const std::string& id, int width, int height, const std::string& inner = "") {
    return shape(3009, id + "a", fmt::format("width=\"{}\" height=\"20\"", width)) +
           shape(3008, id + "n", fmt::format("y=\"20\" width=\"{}\" height=\"{}\"", width, height),
                 container(inner, false));
}

std::string patrol_shapes() {
    const std::string inside = shape(3007, "inner", "x=\"15\" y=\"40\" width=\"24\" height=\"24\"") +
                               state_shape("turning", "x=\"80\" y=\"30\" width=\"90\" height=\"70\"", "");
    const std::string nodes = shape(3007, "start", "x=\"20\" y=\"30\" width=\"24\" height=\"24\"") +
                              state_shape("going", "x=\"100\" y=\"10\"", areas("going", 160, 60)) +
                              state_shape("avoiding", "x=\"400\" y=\"200\"", areas("avoiding", 200, 120, inside));
    return shape(2002, "m", "x=\"50\" y=\"60\"",
                 shape(3012, "ev", "x=\"-22\" y=\"150\" width=\"30\" height=\"30\"",
                       "<children type=\"5010\"><layoutConstraint x=\"-7\" y=\"-13\"/></children>") +
                     container(shape(3009, "mc", "width=\"700\" height=\"60\"") +
                               shape(3008, "mn", "y=\"60\" width=\"700\" height=\"420\"", container(nodes, false))));
}

std::string patrol_lines() {
    return line("t0", "[12, 0, -80, 0]$[68, 0, -24, 0]") +
           line("t1", "[80, 0, -220, -200]$[320, 0, 20, -200]$[320, 84, 20, -84]") +
           line("t2", "[0, 0, 0, 0]$[0, 0, 0, 0]") + line("t3", "[12, 0, -74, -3]$[41, 0, -45, -3]");
}

std::string patrol_aird() {
    return aird_text(aird_diagram(patrol_elements(), patrol_shapes(), patrol_lines()));
}

/// Returns the text with one piece removed or replaced. The piece must exist.
std::string without(std::string text, const std::string& piece, const std::string& other = "") {
    const std::size_t at = text.find(piece);
    EXPECT_NE(at, std::string::npos) << piece;
    return at == std::string::npos ? text : text.replace(at, piece.size(), other);
}

Point corner(const PictureBox& box) {
    return {box.place.x, box.place.y};
}
Point between(const PictureBox& from, const PictureBox& to) {
    return {to.place.x - from.place.x, to.place.y - from.place.y};
}

TEST(StoredDiagrams, AreResolved) {
    const Stored model(patrol, patrol_aird());
    const StoredDiagram* diagram = model.diagram("Patrol");
    ASSERT_NE(diagram, nullptr);
    EXPECT_EQ(diagram->elements, 10U) << "a square, five nodes, four transitions";
    EXPECT_EQ(diagram->found, 10U);
    EXPECT_TRUE(diagram->fits_model());
    EXPECT_THAT(model.findings_about("Patrol"), IsEmpty());
}

TEST(StoredDiagrams, GiveNodesTheirPlaces) {
    const Stored model(patrol, patrol_aird());
    const Picture picture = model.draw("Patrol");
    const PictureBox& frame = picture.boxes.front();
    const PictureBox& going = model.box(picture, "Going");
    EXPECT_NEAR(frame.place.width, 700, 0.001);
    EXPECT_NEAR(going.place.x - frame.place.x, 105, 0.001) << "the area has a border of 5";
    EXPECT_THAT(between(going, model.box(picture, "start")), IsNear(Point{-80, 20}));
    EXPECT_THAT(between(going, model.box(picture, "Avoiding")), IsNear(Point{300, 190}));
    EXPECT_NEAR(going.place.width, 160, 0.001) << "the widest of its areas";
    EXPECT_NEAR(going.place.height, 28 + 20 + 60, 0.001) << "its title and its areas";
}

TEST(StoredDiagrams, GiveNodesInsideTheirPlaces) {
    const Stored model(patrol, patrol_aird());
    const Picture picture = model.draw("Patrol");
    const PictureBox& avoiding = model.box(picture, "Avoiding");
    const PictureBox& inner = model.box(picture, "inner");
    EXPECT_THAT(between(inner, model.box(picture, "Turning")), IsNear(Point{65, -10}));
    EXPECT_NEAR(inner.place.x - avoiding.place.x, 20, 0.001);
    EXPECT_NEAR(inner.place.y - avoiding.place.y, 24 + 45, 0.001) << "below our title: the state has no actions";
    EXPECT_NEAR(model.box(picture, "Turning").place.width, 90, 0.001);
    EXPECT_NEAR(model.box(picture, "Turning").place.height, 70, 0.001);
}

TEST(StoredDiagrams, GiveLinesTheirRoutes) {
    const Stored model(patrol, patrol_aird());
    const Picture picture = model.draw("Patrol");
    const Rectangle start = model.box(picture, "start").place;
    const Rectangle going = model.box(picture, "Going").place;
    const Rectangle avoiding = model.box(picture, "Avoiding").place;
    const PictureLine& t0 = model.line(picture, "t0");
    EXPECT_THAT(t0.points, SizeIs(2)) << "from the right of the circle to the left of the state";
    EXPECT_EQ(t0.points.back().x, going.x);
    EXPECT_EQ(t0.points.front().y, t0.points.back().y);
    EXPECT_NEAR(std::hypot(t0.points[0].x - start.centre().x, t0.points[0].y - start.centre().y), 12, 0.01);
    const PictureLine& t1 = model.line(picture, "t1");
    const double x = avoiding.centre().x + 20;
    EXPECT_THAT(t1.points,
                ElementsAre(Point{going.right(), going.centre().y}, Point{x, going.centre().y}, Point{x, avoiding.y}));
    // The corner of the second box is 300 to the right of that of the first box, and 190 below it. With half of the
    // sizes added, the middles are (320, 220) apart.
    EXPECT_NEAR(x - going.centre().x, 340, 0.001);
}

/// An edge without a stored route gets a new one from border to border.
TEST(StoredDiagrams, LeaveRoutesThatAreNotStoredToUs) {
    const Stored model(patrol, patrol_aird());
    const Picture picture = model.draw("Patrol");
    const PictureLine& t2 = model.line(picture, "t2");
    ASSERT_GE(t2.points.size(), 2U);
    const auto on_border = [](const Point& point, const Rectangle& box) {
        const bool side = point.x == box.x || point.x == box.right();
        const bool end = point.y == box.y || point.y == box.bottom();
        return (side && box.y <= point.y && point.y <= box.bottom()) ||
               (end && box.x <= point.x && point.x <= box.right());
    };
    EXPECT_TRUE(on_border(t2.points.front(), model.box(picture, "Avoiding").place));
    EXPECT_TRUE(on_border(t2.points.back(), model.box(picture, "Going").place));
}

/// The middle of the stored port is 7 pixels outside the border. In the picture, it is on the border. Elements below
/// the rows move down with the rows.
TEST(StoredDiagrams, PutSquaresOnTheirSide) {
    const Stored model(patrol, patrol_aird());
    const Picture picture = model.draw("Patrol");
    const PictureBox& frame = picture.boxes.front();
    const PictureBox& square = model.box(picture, "obstacle");
    EXPECT_EQ(square.event_of, 0U);
    EXPECT_NEAR(square.place.centre().x, frame.place.x, 0.001);
    const double inside = frame.rules.back() - frame.place.y;  // the stored area starts below title and rows: 28 + 60
    EXPECT_NEAR(square.place.centre().y - frame.place.y, 165 - 88 + inside, 0.001);
    EXPECT_LT(square.texts[0].at.y, square.place.centre().y) << "its label was above it";
}

TEST(StoredDiagrams, LeaveWhatIsOfAutomaticSizeToOurMetrics) {
    const Stored model(patrol, without(without(patrol_aird(), "width=\"160\" height=\"20\""),
                                       "y=\"20\" width=\"160\" height=\"60\"", "y=\"20\""));
    const Stored plain(patrol, aird_text(""));
    const Picture picture = model.draw("Patrol");
    const Picture own = plain.draw("Patrol");
    EXPECT_NEAR(model.box(picture, "Going").place.width, plain.box(own, "Going").place.width, 0.001);
    EXPECT_NEAR(model.box(picture, "Going").place.height, 46, 0.001) << "title 24, line 14, space 8";
}

/// An element needs more space than in the drawing, so the elements below it move down.
TEST(StoredDiagrams, MakeSpaceForText) {
    const std::string aird = without(patrol_aird(), "y=\"20\" width=\"160\" height=\"60\"",
                                     "y=\"0\" width=\"160\" height=\"2\"");  // 30 high
    const Stored model(patrol, aird);
    const Picture picture = model.draw("Patrol");
    EXPECT_NEAR(model.box(picture, "Going").place.height, 46, 0.001);
    EXPECT_THAT(between(model.box(picture, "Going"), model.box(picture, "Avoiding")), IsNear(Point{300, 190 + 16}));
}

TEST(StoredDiagrams, HiddenTitlesTakeNoSpace) {
    const std::string hidden = shape(3008, "going", "x=\"100\" y=\"10\"", container(areas("going", 160, 60), false));
    const Stored model(
        patrol, without(patrol_aird(), state_shape("going", "x=\"100\" y=\"10\"", areas("going", 160, 60)), hidden));
    EXPECT_NEAR(model.box(model.draw("Patrol"), "Going").place.height, 20 + 60, 0.001);
}

// ---------------------------------------------------------------- which diagrams are used

/// Returns a machine with states A0 to A19 in a row, and its diagram.
std::string row_of_states(int count) {
    std::string text = "stm S {\n initial A0\n";
    for (int i = 1; i < count; ++i) text += fmt::format(" state A{} {{ }}\n", i);
    return text + " transition t { from A0 to A1 }\n}\n";
}
std::string row_aird(int count, int renamed) {
    std::string elements = node("m", "S", "", "StateMachineID") + node("mn", "", "", "NodesID");
    std::string shapes;
    for (int i = 0; i < count; ++i) {
        elements += node(fmt::format("s{}", i), fmt::format("{}{}", i < renamed ? "Old" : "A", i),
                         fmt::format("/@nodes.{}", i), "StateID");
        shapes += shape(3008, fmt::format("s{}", i), fmt::format("x=\"{}\" y=\"9\"", i * 100));
    }
    return aird_text(
        aird_diagram(elements, shape(2002, "m", "", container(shape(3008, "mn", "", container(shapes, false))))));
}

TEST(StoredDiagrams, AreUsedFromNinetyFivePercentOn) {
    const Stored enough(row_of_states(20), row_aird(20, 1));
    EXPECT_EQ(enough.diagram("S")->found, 19U);
    EXPECT_TRUE(enough.diagram("S")->fits_model()) << "19 of 20 are 95 %";
    EXPECT_THAT(enough.findings_about("S"),
                ElementsAre("RC-D03 state machine S is drawn as in p/representations.aird, which does "
                            "not have initial junction A0, transition t"));
    const Stored little(row_of_states(19), row_aird(19, 1));
    EXPECT_FALSE(little.diagram("S")->fits_model()) << "18 of 19 are less";
    EXPECT_THAT(little.findings_about("S"),
                ElementsAre("RC-D02 the diagram of state machine S in p/representations.aird is not "
                            "used: only 18 of its 19 elements are in the model"));
    const Stored none_at_all(row_of_states(19), aird_text(""));
    const Picture own = none_at_all.draw("S");
    const Picture drawn = little.draw("S");
    EXPECT_EQ(corner(little.box(drawn, "A3")), corner(none_at_all.box(own, "A3"))) << "laid out as without it";
}

/// A stored line is used only if it has the same ends as in the model.
TEST(StoredDiagrams, CompareTheEndsOfLines) {
    for (const char* other :
         {"sourceNode=\"start\" targetNode=\"avoiding\"", "sourceNode=\"going\" targetNode=\"going\""}) {
        const Stored model(patrol, without(patrol_aird(), "sourceNode=\"going\" targetNode=\"avoiding\"", other));
        EXPECT_EQ(model.diagram("Patrol")->found, 9U) << other;
        EXPECT_FALSE(model.diagram("Patrol")->fits_model());
    }
}

/// Lines with the same ends are matched by their labels.
TEST(StoredDiagrams, TellLinesApartByTheirLabels) {
    const auto lost = [](const std::string& id, const std::string& label) {
        return line_element(id, label, of_machine("/@transitions.9"), "TransitionID", "a", "b");
    };
    const Stored model(
        "stm S { event e event f initial i state A { } state B { } transition te { from A to B trigger e }\n"
        " transition tf { from A to B trigger f } }\n",
        aird_text(aird_diagram(node("m", "S", "", "StateMachineID") + node("a", "A", "/@nodes.1", "StateID") +
                                   node("b", "B", "/@nodes.2", "StateID") + lost("l1", "f") + lost("l2", "e"),
                               shape(2002, "m", "",
                                     shape(3008, "a", "x=\"0\" width=\"100\" height=\"80\"") +
                                         shape(3008, "b", "x=\"300\" width=\"100\" height=\"80\"")),
                               line("l1", "[50, -20, -250, -20]$[250, -20, -50, -20]") +
                                   line("l2", "[50, 20, -250, 20]$[250, 20, -50, 20]"))));
    EXPECT_EQ(model.diagram("S")->found, 4U);
    const Picture picture = model.draw("S");
    const double middle = model.box(picture, "A").place.centre().y;
    EXPECT_NEAR(model.line(picture, "tf").points.front().y, middle - 20, 0.001);
    EXPECT_NEAR(model.line(picture, "te").points.front().y, middle + 20, 0.001);
}

/// The diagram has the initial layout, which RoboTool generates before a user moves an element.
TEST(StoredDiagrams, ThatNobodyDrewAreNotUsed) {
    std::string aird = row_aird(20, 0);
    for (int i = 1; i < 20; ++i) aird = without(aird, fmt::format("x=\"{}\" y=\"9\"", i * 100));
    aird = without(aird, "x=\"0\" y=\"9\"");
    const Stored model(row_of_states(20), aird);
    EXPECT_FALSE(model.diagram("S")->is_drawn());
    EXPECT_FALSE(model.diagram("S")->fits_model());
    EXPECT_THAT(model.findings_about("S"), IsEmpty());
}

/// If a declaration is inserted before others, the numbers in all references change.
TEST(StoredDiagrams, FindDeclarationsThatHaveMoved) {
    const std::string moved = without(without(patrol, " initial start\n", " state New { }\n initial start\n"),
                                      " transition t0", " transition t4 { from New to Going }\n transition t0");
    const Stored model("stm Other { initial i }\n" + moved, patrol_aird());
    EXPECT_EQ(model.diagram("Patrol")->found, 10U);
    EXPECT_THAT(model.findings_about("Patrol"),
                ElementsAre("RC-D03 state machine Patrol is drawn as in p/representations.aird, which does not have "
                            "state New, transition t4"));
    const Picture picture = model.draw("Patrol");
    EXPECT_THAT(between(model.box(picture, "Going"), model.box(picture, "Avoiding")), IsNear(Point{300, 190}));
    const PictureBox& fresh = model.box(picture, "New");
    EXPECT_NEAR(fresh.place.y, model.box(picture, "Avoiding").place.bottom() + 26, 0.001) << "below all others";
    EXPECT_GE(model.line(picture, "t4").points.size(), 2U);
}

/// Shapes that a user has hidden are treated as new elements.
TEST(StoredDiagrams, DoNotCountWhatIsHidden) {
    const Stored model(row_of_states(20), without(row_aird(20, 0), "type=\"3008\" element=\"s7\"",
                                                  "type=\"3008\" visible=\"false\" element=\"s7\""));
    EXPECT_EQ(model.diagram("S")->elements, 19U);
    EXPECT_THAT(model.findings_about("S"), ElementsAre(HasSubstr("which does not have state A7, transition t")));
}

TEST(StoredDiagrams, NameAFileOnlyByItsLastPart) {
    for (const char* path :
         {"../../../etc/a.rct", "/a.rct", "platform:/resource/p/a.rct", "http://h/a.rct", "%61.rct"}) {
        std::string aird = row_aird(20, 0);
        for (std::size_t at = 0; (at = aird.find("a.rct#", at)) != std::string::npos; at += std::string(path).size())
            aird.replace(at, 5, path);
        EXPECT_EQ(Stored(row_of_states(20), aird).diagram("S")->found, 20U) << path;
    }
}

/// If several files have the same name, the one next to the diagrams is used.
TEST(StoredDiagrams, PreferTheFileBesideThem) {
    const Stored model(random_models::Project{{"a/a.rct", "package q\nstm S { initial B }\n"},
                                              {"p/a.rct", "package p\n" + row_of_states(20)}},
                       row_aird(20, 0));
    EXPECT_EQ(model.diagram("q::S"), nullptr);
    EXPECT_EQ(model.diagram("p::S")->found, 20U);
}

TEST(StoredDiagrams, StandReferencesThatLeadNowhere) {
    for (const char* href :
         {"", "#", "a.rct", "a.rct#", "a.rct#/", "a.rct#//", "a.rct#//@machines", "a.rct#//@machines.",
          "a.rct#//machines.0", "a.rct#//@machines.99999999999999999999", "a.rct#//@machines.0/@nodes.20",
          "a.rct#//@machines.0/@nodes.0/@x.0", "a.rct#//@machines.0//@nodes.0", "a.rct#//@machines.-1",
          "a.rct#//@types.0", "%", "%4", "%zz#//@machines.0"}) {
        const std::string aird = without(row_aird(20, 0), "a.rct#//@machines.0\"", std::string(href) + "\"");
        EXPECT_EQ(Stored(row_of_states(20), aird).diagram("S"), nullptr) << href;
    }
}

// ---------------------------------------------------------------- parts

constexpr const char* controller =
    "stm T { event e: nat initial i }\n"
    "controller C {\n event inp: nat\n event out\n sref s = T\n"
    " stm Inside { event e: nat initial i state A { } transition t { from i to A } }\n"
    " connection C on inp to s on e\n connection s on e to Inside on e (_async)\n}\n";

std::string controller_aird() {
    const auto of = [](const std::string& path) { return "a.rct#//@controllers.0" + path; };
    const std::string inside = of("/@machines.1");
    const std::string elements =
        element("c", "C", of(""), "ControllerDefID") + element("cn", "C", of(""), "MachinesID") +
        element("in", "inp: nat", of("/@events.0"), "BorderedEventID") +
        element("s", "ref s = T\n", of("/@machines.0"), "StateMachineRefID") +
        element("se", "e: nat", "a.rct#//@machines.0/@events.0", "BorderedEventID") +
        element("i", "Inside", inside, "StateMachineID") + element("in2", "", inside, "NodesID") +
        element("ie", "e: nat", inside + "/@events.0", "BorderedEventID") +
        element("ii", "i", inside + "/@nodes.0", "InitialID") + element("ia", "A", inside + "/@nodes.1", "StateID") +
        line_element("k0", "", of("/@connections.0"), "ConnectionID", "in", "se") +
        line_element("k1", "async", of("/@connections.1"), "ConnectionID", "se", "ie") +
        line_element("it", "", inside + "/@transitions.0", "TransitionID", "ii", "ia");
    const std::string square = "width=\"30\" height=\"30\"";
    const std::string nodes = shape(3007, "ii", "x=\"10\" y=\"20\" width=\"24\" height=\"24\"") +
                              shape(3008, "ia", "x=\"90\" y=\"10\" width=\"80\" height=\"44\"");
    const std::string parts =
        shape(3007, "s", "x=\"40\" y=\"30\" width=\"150\" height=\"60\"",
              shape(3001, "se", "x=\"142\" y=\"15\" " + square)) +
        shape(3008, "i", "x=\"300\" y=\"10\"",
              shape(3012, "ie", "x=\"40\" y=\"-22\" " + square) +
                  container(shape(3008, "in2", "width=\"220\" height=\"90\"", container(nodes, false))));
    return aird_text(
        aird_diagram(elements,
                     shape(2002, "c", "",
                           shape(3012, "in", "x=\"-22\" y=\"58\" " + square) +
                               container(shape(3008, "cn", "width=\"600\" height=\"200\"", container(parts, false)))),
                     line("k0", "[0, 0, -200, 0]$[200, 0, 0, 0]") + line("k1", "[0, 0, 0, 0]") +
                         line("it", "[12, 0, -108, 0]$[80, 0, -40, 0]")));
}

TEST(StoredDiagrams, PlacePartsAndTheirSquares) {
    const Stored model(controller, controller_aird());
    EXPECT_EQ(model.diagram("C")->elements, 10U);
    EXPECT_EQ(model.diagram("C")->found, 10U);
    EXPECT_THAT(model.findings_about("C"), IsEmpty());
    const Picture picture = model.draw("C");
    const PictureBox& frame = picture.boxes.front();
    const PictureBox& reference = model.box(picture, "s");
    EXPECT_NEAR(frame.place.width, 600, 0.001);
    EXPECT_NEAR(frame.place.height, 26 + 200, 0.001) << "our title and their area";
    EXPECT_THAT(between(frame, reference), IsNear(Point{45, 26 + 35}));
    EXPECT_NEAR(reference.place.width, 150, 0.001);
    EXPECT_THAT(between(reference, model.box(picture, "Inside")), IsNear(Point{260, -20}));
    const PictureLine& first = picture.lines.back();
    ASSERT_EQ(picture.lines.size(), 3U);
    const PictureBox& target = picture.boxes[first.to];
    EXPECT_NEAR(target.place.centre().y, model.box(picture, "Inside").place.y, 0.001) << "on the upper side";
    EXPECT_NEAR(target.place.centre().x, model.box(picture, "Inside").place.x + 55, 0.001);
    const PictureBox& own = picture.boxes[picture.lines[1].from];
    EXPECT_NEAR(own.place.centre().x, frame.place.x, 0.001);
    EXPECT_NEAR(own.place.centre().y - frame.place.y, 73 - 28 + 26, 0.001) << "below the title, ours is 2 pixels lower";
}

/// An event that is missing in the diagram is placed on the right side.
TEST(StoredDiagrams, PlaceNewSquares) {
    const Stored model(controller, controller_aird());
    const Picture picture = model.draw("C");
    EXPECT_NEAR(model.box(picture, "out").place.centre().x, picture.boxes.front().place.right(), 0.001);
}

/// A machine that is defined inside the controller is drawn with its nodes, as in RoboTool.
TEST(StoredDiagrams, OpenMachinesInPlace) {
    const Stored model(controller, controller_aird());
    const Picture picture = model.draw("C");
    const PictureBox& inside = model.box(picture, "Inside");
    const PictureBox& state = model.box(picture, "A");
    EXPECT_NEAR(inside.place.width, 220, 0.001);
    EXPECT_THAT(between(inside, state), IsNear(Point{95, 26 + 15}));
    EXPECT_EQ(state.parent, static_cast<std::size_t>(&inside - picture.boxes.data()));
    const Picture alone = model.draw("C::Inside");
    EXPECT_THAT(between(model.box(alone, "i"), model.box(alone, "A")), IsNear(Point{80, -10}))
        << "as in its own diagram";
}

TEST(StoredDiagrams, GiveThePlatformItsSize) {
    const Stored model("robotic platform P { event e event f }\n",
                       aird_text(aird_diagram(element("p", "P", "a.rct#//@robots.0", "RoboticPlatformDefID") +
                                                  element("e", "e", "a.rct#//@robots.0/@events.0", "BorderedEventID"),
                                              shape(2003, "p", "x=\"7\" width=\"310\" height=\"140\"",
                                                    shape(3012, "e", "x=\"100\" y=\"132\"")))));
    const Picture picture = model.draw("P");
    const PictureBox& frame = picture.boxes.front();
    EXPECT_NEAR(frame.place.width, 310, 0.001);
    EXPECT_NEAR(frame.place.height, 140, 0.001);
    EXPECT_THAT(model.box(picture, "e").place.centre(), IsNear(Point{frame.place.x + 115, frame.place.bottom()}));
}

TEST(StoredDiagrams, OfTheSameTextAreTheSame) {
    const Stored a(patrol, patrol_aird());
    const Stored b(patrol, patrol_aird());
    const Picture first = a.draw("Patrol");
    const Picture second = b.draw("Patrol");
    for (std::size_t i = 0; i < first.boxes.size(); ++i) EXPECT_EQ(first.boxes[i].place, second.boxes[i].place);
    for (std::size_t i = 0; i < first.lines.size(); ++i) {
        EXPECT_EQ(first.lines[i].points, second.lines[i].points);
        EXPECT_EQ(first.lines[i].label, second.lines[i].label);
    }
}

/// After any damage to a file, its readable parts are drawn.
TEST(StoredDiagrams, StandChangesOfAnyPart) {
    const std::string whole = controller_aird();
    std::uint64_t state = 1;
    std::size_t read = 0;
    for (std::size_t round = 0; round < tests::rounds(600); ++round) {
        std::string text = whole;
        const auto random = [&](std::size_t below) { return diagnostics::splitmix64(state) % below; };
        const std::size_t at = random(text.size());
        const std::size_t other = random(text.size());
        if (round % 3 == 0) text[at] = static_cast<char>('!' + random(90));
        if (round % 3 == 1) text.erase(at, 1 + random(30));
        if (round % 3 == 2) text.insert(at, text, other, random(40));
        if (!read_aird(text).error.empty()) continue;
        ++read;
        const Stored model(controller, text);
        for (const char* name : {"C", "C::Inside", "T"}) EXPECT_FALSE(model.draw(name).boxes.empty());
    }
    EXPECT_GT(read, tests::rounds(600) / 12);
}

// ---------------------------------------------------------------- files

class StoredFiles : public ::testing::Test {
protected:
    StoredFiles() { std::filesystem::create_directory(path("models")); }

    void write(const std::string& name, const std::string& text) const { folder_.write(name, text); }
    /// Returns the findings for a model in the folders `models` and `.`.
    [[nodiscard]] std::vector<std::string> read() {
        loaded_ =
            random_models::load({{path("models/a.rct"), row_of_states(20)}, {path("b.rct"), "stm T { initial i }\n"}});
        diagnostics::Diagnostics out;
        diagrams_ = {};
        diagrams_.read(loaded_->model, loaded_->sources, out);
        diagrams_.read(loaded_->model, loaded_->sources, out);  // no finding is repeated
        std::vector<std::string> result;
        for (const diagnostics::Diagnostic& finding : out.sorted_findings())
            result.push_back(fmt::format("{} {} {}", finding.rule->code, loaded_->sources.path_and_line(finding.span),
                                         finding.message()));
        return result;
    }
    [[nodiscard]] std::size_t found() const {
        for (const Subject& subject : find_subjects(loaded_->model, loaded_->sources))
            if (const StoredDiagram* diagram = diagrams_.diagram_of(subject.component)) return diagram->found;
        return 0;
    }
    [[nodiscard]] std::string path(const std::string& name) const { return folder_.in(name); }

    std::unique_ptr<random_models::Loaded> loaded_;
    StoredDiagrams diagrams_;

private:
    tests::TemporaryFolder folder_;
};

TEST_F(StoredFiles, AreFoundBesideTheModel) {
    write("models/representations.aird", row_aird(20, 0));
    EXPECT_THAT(read(), IsEmpty());
    EXPECT_EQ(found(), 20U);
}

TEST_F(StoredFiles, AreFoundInTheFolderOfTheProject) {
    write("representations.aird", row_aird(20, 0));
    EXPECT_THAT(read(), IsEmpty());
    EXPECT_EQ(found(), 20U);
}

TEST_F(StoredFiles, ThatFitBetterComeFirst) {
    write("models/representations.aird", row_aird(20, 5));
    write("representations.aird", row_aird(20, 1));
    EXPECT_THAT(read(), IsEmpty());
    EXPECT_EQ(found(), 19U);
}

TEST_F(StoredFiles, MayBeMissing) {
    EXPECT_THAT(read(), IsEmpty());
    EXPECT_EQ(found(), 0U);
}

TEST_F(StoredFiles, ThatCannotBeReadAreANote) {
    write("models/representations.aird", "<x>\n<y></x>");
    std::filesystem::create_directories(path("representations.aird"));
    EXPECT_EQ(rules::unreadable_diagrams.severity, diagnostics::Severity::note);
    EXPECT_THAT(read(),
                ElementsAre(fmt::format("RC-D01 {0}:2 the diagrams of {0} are not used: it is not XML in UTF-8: "
                                        "mismatched tag",
                                        path("models/representations.aird")),
                            HasSubstr("is a folder, not a file")));
    EXPECT_EQ(found(), 0U);
}

TEST_F(StoredFiles, AreNeverWritten) {
    write("models/representations.aird", row_aird(20, 3));
    const auto before = std::filesystem::last_write_time(path("models/representations.aird"));
    EXPECT_THAT(read(), IsEmpty());
    EXPECT_EQ(std::filesystem::last_write_time(path("models/representations.aird")), before);
}

}  // namespace
}  // namespace robochart::diagrams
