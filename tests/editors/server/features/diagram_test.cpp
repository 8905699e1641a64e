// SPDX-License-Identifier: Apache-2.0
// Tests diagrams next to the text: the selected component, the same picture as `draw`, and the last valid picture while
// the text has errors.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <set>

#include "frontend/diagrams/notation/subjects.hpp"
#include "frontend/diagrams/svg/svg.hpp"
#include "tests/editors/server/client.hpp"

namespace robochart::lsp {
namespace {

using testing::Answer;
using testing::Client;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* diagram_uri = "file:///p/a.rct";
constexpr const char* diagram_text = R"(package p
/*^import*/
interface /*^interface*/I { event go event halt }
controller C {
  uses I
  connection C on go to S on go
  /*^controller*/
  stm S {
    uses I
    initial i0
    state /*^state*/Idle { }
    state Busy { entry /*^action*/halt }
    transition t0 { from i0 to Idle }
    transition t1 { from Idle to Busy trigger go }
  }
  operation op() {
    initial j0
    final /*^operation*/f0
    transition u0 { from j0 to f0 }
  }
}
)";

Json diagram_request(const char* key = "component", Json value = nullptr) {
    return Json::object({{"textDocument", Json::object({{"uri", diagram_uri}})}, {key, std::move(value)}});
}

Answer drawn_at(Client& client, const std::string& mark) {
    return client.request("robochart/diagram", client.at(mark));
}

std::string text_with(std::string text, const std::string& old, const std::string& with) {
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return at == std::string::npos ? text : text.replace(at, old.size(), with);
}

/// Returns the picture of a component, drawn with the functions that `draw` uses.
std::string drawn_apart(const std::string& name, diagrams::Theme theme) {
    Workspace workspace;
    Project& project = *workspace.open_document(diagram_uri, diagram_text).project;
    const diagrams::Elements elements(project.current_model());
    for (const diagrams::Subject& subject : diagrams::find_subjects(project.current_model(), project.sources()))
        if (subject.name == name)
            return diagrams::render_svg(diagrams::draw_subject(subject, {elements}), elements, {theme, ""});
    return "";
}

std::int64_t notifications_of(const Client& client, std::size_t from = 0) {
    std::int64_t count = 0;
    for (std::size_t i = from; i < client.messages.size(); ++i)
        count += client.messages[i]["method"].text() == "robochart/diagramChanged" ? 1 : 0;
    return count;
}

/// Returns the element of this kind and name, or null if there is none.
Answer element_of(const Answer& diagram, const std::string& kind, const std::string& name) {
    for (const Answer& element : diagram["elements"].items())
        if (element["kind"].text() == kind && element["name"].text() == name) return element;
    return {};
}

/// Returns the start of the SVG line with this id, without the id's number. It contains the element's position.
std::string box_of(const Answer& diagram, const Answer& element) {
    const std::string svg = diagram["svg"].text();
    const std::size_t group = svg.find("id=\"" + element["id"].text() + "\"");
    const std::size_t box = svg.find("<rect", group);
    return svg.substr(box, svg.find("/>", box) - box);
}

TEST(Diagram, IsAnnounced) {
    const Client client;
    const Answer experimental = client.initialized()["capabilities"]["experimental"]["robochart"];
    EXPECT_TRUE(experimental["diagram"].truth());
    EXPECT_TRUE(experimental["diagramChanged"].truth());
}

TEST(Diagram, IsThatOfDraw) {
    Client client;
    client.open(diagram_uri, diagram_text);
    const Answer machine = client.request("robochart/diagram", diagram_request("component", "p::C::S"));
    EXPECT_EQ(machine["component"].text(), "p::C::S");
    EXPECT_EQ(machine["version"].number(), 1);
    EXPECT_FALSE(machine["stale"].truth(true));
    const std::string expected = drawn_apart("p::C::S", diagrams::Theme::automatic);
    ASSERT_THAT(expected, HasSubstr("Idle"));
    EXPECT_EQ(machine["svg"].text(), expected);
    Json dark = diagram_request("component", "p::C");
    dark["theme"] = "dark";
    EXPECT_EQ(client.request("robochart/diagram", dark)["svg"].text(), drawn_apart("p::C", diagrams::Theme::dark));
}

TEST(Diagram, ElementsAreInThePictureAndAtTheirText) {
    Client client;
    client.open(diagram_uri, diagram_text);
    const Answer machine = drawn_at(client, "state");
    std::set<std::string> listed;
    for (const Answer& element : machine["elements"].items()) {
        EXPECT_THAT(machine["svg"].text(), HasSubstr("data-element=\"" + element["id"].text() + "\""));
        EXPECT_EQ(element["uri"].text(), diagram_uri);
        listed.insert(element["id"].text());
    }
    const std::string svg = machine["svg"].text();
    const std::string key = "data-element=\"";
    for (std::size_t at = svg.find(key); at != std::string::npos; at = svg.find(key, at + 1)) {
        const std::size_t begin = at + key.size();
        EXPECT_TRUE(listed.contains(svg.substr(begin, svg.find('"', begin) - begin)));
    }
    const Answer state = element_of(machine, "state", "Idle");
    EXPECT_EQ(state["selectionRange"]["start"], client.at("state")["position"]);
    EXPECT_EQ(state["selectionRange"]["end"]["character"].number(),
              state["selectionRange"]["start"]["character"].number() + 4);
    EXPECT_THAT(client.text_before(diagram_uri, state["range"]["end"]), ::testing::EndsWith("Idle { }"));
    EXPECT_FALSE(element_of(machine, "transition", "t1").is_null());
    EXPECT_TRUE(element_of(machine, "operation", "op").is_null()) << "not in this diagram";
}

TEST(Diagram, TheInnermostComponentAtAPlace) {
    Client client;
    client.open(diagram_uri, diagram_text);
    EXPECT_EQ(drawn_at(client, "state")["component"].text(), "p::C::S");
    EXPECT_EQ(drawn_at(client, "action")["component"].text(), "p::C::S");
    EXPECT_EQ(drawn_at(client, "operation")["component"].text(), "p::C::op");
    EXPECT_EQ(drawn_at(client, "controller")["component"].text(), "p::C");
    EXPECT_EQ(drawn_at(client, "interface")["component"].text(), "p") << "its package";
    EXPECT_EQ(drawn_at(client, "import")["component"].text(), "p::C") << "the first of the file";
    Json with_name = client.at("import");
    with_name["component"] = "S";
    EXPECT_EQ(client.request("robochart/diagram", with_name)["component"].text(), "p::C::S");
}

TEST(Diagram, OfANameOrOfTheFile) {
    Client client;
    client.open(diagram_uri, diagram_text);
    EXPECT_EQ(client.request("robochart/diagram", diagram_request())["component"].text(), "p::C");
    EXPECT_EQ(client.request("robochart/diagram", diagram_request("component", "op"))["component"].text(), "p::C::op");
    EXPECT_TRUE(client.request("robochart/diagram", diagram_request("component", "nobody")).is_null());
    EXPECT_TRUE(client.request("robochart/diagram", diagram_request("component", "::S")).is_null());
}

TEST(Diagram, NothingToDrawIsNull) {
    Client client;
    client.open(diagram_uri, "package p\n");
    EXPECT_TRUE(client.request("robochart/diagram", diagram_request()).is_null());
    client.open("file:///q/a.assertions", "assertion A1 : S is deadlock-free\n");
    client.open("file:///q/a.csp", "P = STOP\n");
    for (const char* uri : {"file:///q/a.assertions", "file:///q/a.csp"}) {
        const Json document = Json::object({{"uri", uri}});
        EXPECT_TRUE(client.request("robochart/diagram", Json::object({{"textDocument", document}})).is_null()) << uri;
    }
}

TEST(Diagram, BrokenTextHasTheLastPicture) {
    Client client;
    client.open(diagram_uri, diagram_text);
    const Answer good = drawn_at(client, "state");
    const std::string broken = text_with(diagram_text, "from Idle to Busy trigger", "from from to trigger");
    client.change(diagram_uri, broken);
    const Answer stale = drawn_at(client, "state");
    EXPECT_TRUE(stale["stale"].truth());
    EXPECT_EQ(stale["svg"], good["svg"]);
    EXPECT_EQ(stale["elements"], good["elements"]);
    EXPECT_EQ(stale["version"].number(), 1) << "that of the text in the picture";
    const Answer other = drawn_at(client, "controller");
    EXPECT_FALSE(other["stale"].truth(true)) << "there is no earlier one: as far as it is understood";
    EXPECT_EQ(other["component"].text(), "p::C");
    client.change(diagram_uri, text_with(diagram_text, "Busy", "Active"));
    const Answer again = drawn_at(client, "state");
    EXPECT_FALSE(again["stale"].truth(true));
    EXPECT_EQ(again["version"].number(), 3);
    EXPECT_THAT(again["svg"].text(), HasSubstr("Active"));
}

TEST(Diagram, TextWithoutAnyComponentLeftHasTheLastPicture) {
    Client client;
    client.open(diagram_uri, diagram_text);
    const Answer good = drawn_at(client, "state");
    client.change(diagram_uri, "package p\n}} /*^here*/");
    EXPECT_EQ(drawn_at(client, "here")["svg"], good["svg"]);
    EXPECT_TRUE(drawn_at(client, "here")["stale"].truth());
    client.change(diagram_uri, "package p\n/*^here*/");
    EXPECT_TRUE(drawn_at(client, "here").is_null()) << "it was really taken away";
}

TEST(Diagram, NamesThatMeanNothingAreDrawn) {
    Client client;
    client.open(diagram_uri, diagram_text);
    EXPECT_FALSE(drawn_at(client, "state")["stale"].truth(true));
    client.change(diagram_uri, text_with(diagram_text, "from Idle to Busy", "from Idle to Gone"));
    const Answer drawn = drawn_at(client, "state");
    EXPECT_FALSE(drawn["stale"].truth(true));
    EXPECT_THAT(drawn["svg"].text(), HasSubstr("Gone"));
}

/// Returns states that are connected in a ring and declared in the order of `order`. The layout follows the order of
/// the text.
std::string ring(const std::string& order, const std::string& extra = "") {
    std::string text = "stm R { event e initial i0 ";
    for (const char name : order) text += std::string("state ") + name + " { } ";
    text += extra + "transition t { from i0 to A } ";
    const std::string arrows = "ABACADBECECEDE";
    for (std::size_t i = 0; i + 1 < arrows.size(); i += 2)
        text += fmt::format("transition t{} {{ from {} to {} trigger e }} ", i, arrows[i], arrows[i + 1]);
    return text + "}\n";
}

TEST(Diagram, EditsKeepTheLayout) {
    Client client;
    client.open(diagram_uri, ring("ABCDE"));
    const Answer before = client.request("robochart/diagram", diagram_request());
    client.change(diagram_uri, ring("ADCBE"));
    const Answer after = client.request("robochart/diagram", diagram_request());
    Client other;
    other.open(diagram_uri, ring("ADCBE"));
    const Answer fresh = other.request("robochart/diagram", diagram_request());
    bool moves = false;
    for (const char* name : {"A", "B", "C", "D", "E"}) {
        EXPECT_EQ(box_of(before, element_of(before, "state", name)), box_of(after, element_of(after, "state", name)));
        moves = moves ||
                box_of(before, element_of(before, "state", name)) != box_of(fresh, element_of(fresh, "state", name));
    }
    EXPECT_TRUE(moves) << "without a memory some state would have moved";
}

TEST(Diagram, ChangesAreAnnouncedAfterDiagnosticsToThoseWhoAsked) {
    Client client;
    client.open(diagram_uri, diagram_text);
    client.change(diagram_uri, text_with(diagram_text, "Busy", "Active"));
    EXPECT_EQ(notifications_of(client), 0) << "nobody asked";
    (void)client.request("robochart/diagram", diagram_request());
    const std::size_t before = client.messages.size();
    client.change(diagram_uri, text_with(diagram_text, "state Busy", "state state"));
    EXPECT_EQ(notifications_of(client, before), 1);
    const Answer last = client.messages.back();
    EXPECT_EQ(last["method"].text(), "robochart/diagramChanged") << "diagnostics come first";
    EXPECT_EQ(last["params"]["uri"].text(), diagram_uri);
    EXPECT_EQ(last["params"]["version"].number(), 3);
    const std::size_t asked_again = client.messages.size();
    (void)client.request("robochart/diagram", diagram_request());
    EXPECT_EQ(notifications_of(client, asked_again), 0) << "asking changes nothing";
    client.close(diagram_uri);
    client.open("file:///q/b.rct", diagram_text);
    EXPECT_EQ(notifications_of(client, asked_again), 0) << "another project, and the document is gone";
}

TEST(Diagram, WrongParametersAreRefused) {
    Client client;
    client.open(diagram_uri, diagram_text);
    constexpr std::int64_t invalid = -32602;
    const auto refused = [&](const Json& params) {
        return client.ask("robochart/diagram", params)["error"]["code"].number() == invalid;
    };
    EXPECT_TRUE(refused(nullptr));
    EXPECT_TRUE(refused(Json::array({1, 2})));
    EXPECT_TRUE(refused(Json::object({{"textDocument", Json::object({{"uri", "file:///p/none.rct"}})}})));
    for (const Json& component : {Json(7), Json::array({"S"}), Json::object({}), Json(true)})
        EXPECT_TRUE(refused(diagram_request("component", component)));
    for (const Json& position : {Json("here"), Json(7), Json::object({}), Json::object({{"line", "x"}})})
        EXPECT_TRUE(refused(diagram_request("position", position)));
    for (const Json& theme : {Json("red"), Json(7), Json(""), Json::array()})
        EXPECT_TRUE(refused(diagram_request("theme", theme)));
    const Json far = Json::object({{"line", 1LL << 40}, {"character", -(1LL << 40)}});
    EXPECT_TRUE(client.request("robochart/diagram", diagram_request("position", far)).is_object());
    EXPECT_TRUE(client.request("robochart/diagram", diagram_request("component", std::string(100000, ':'))).is_null());
}

TEST(Diagram, TooLargeOnesAreRefusedAndTheServerGoesOn) {
    Client client;
    std::string text = "stm R { event e initial i0 ";
    // A chain of states. From each state, a transition leads directly to the last one.
    for (int i = 0; i < 500; ++i) text += fmt::format("state S{} {{ }} ", i);
    for (int i = 0; i < 499; ++i)
        for (const int to : {i + 1, 499})
            text += fmt::format("transition t{}_{} {{ from S{} to S{} trigger e }} ", i, to, i, to);
    client.open(diagram_uri, text + "}\nstm Q { initial i0 state A { } transition t { from i0 to A } }\n");
    constexpr std::int64_t failed = -32803;
    EXPECT_EQ(client.ask("robochart/diagram", diagram_request("component", "R"))["error"]["code"].number(), failed);
    EXPECT_EQ(client.request("robochart/diagram", diagram_request("component", "Q"))["component"].text(), "Q");
}

TEST(Diagram, TextOfTheModelIsEscaped) {
    Client client;
    client.open(diagram_uri,
                "stm S { var s : string initial i0 state A { entry s = \"</svg><script>&\" } "
                "transition t { from i0 to A } }\n");
    const std::string svg = client.request("robochart/diagram", diagram_request())["svg"].text();
    EXPECT_THAT(svg, HasSubstr("&lt;script&gt;"));
    EXPECT_THAT(svg, Not(HasSubstr("<script")));
}

}  // namespace
}  // namespace robochart::lsp
