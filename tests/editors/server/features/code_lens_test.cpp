// SPDX-License-Identifier: Apache-2.0
// Tests the lenses: "check" above each assertion, "draw" and "step" above each component.
#include <gtest/gtest.h>

#include "tests/editors/server/client.hpp"

namespace robochart::lsp {
namespace {

using testing::Answer;
using testing::Client;

constexpr const char* lens_uri = "file:///p/a.assertions";
const Json lens_params = Json::object({{"textDocument", Json::object({{"uri", lens_uri}})}});

Json options(const char* command) {
    return Json::object({{"commands", Json::array({command})}});
}

TEST(CodeLens, IsOfferedToThoseWhoHaveTheCommand) {
    const auto offered = [](Json of) {
        const Client client(testing::usual_capabilities(), {}, std::move(of));
        return client.initialized()["capabilities"].has("codeLensProvider");
    };
    EXPECT_TRUE(offered(options("robochart.check")));
    EXPECT_TRUE(offered(options("robochart.step")));
    EXPECT_FALSE(offered(options("another")));
    EXPECT_FALSE(offered(nullptr));
    EXPECT_FALSE(offered("robochart.check"));
}

TEST(CodeLens, StandsAtEachAssertionAlsoInBrokenText) {
    Client client(testing::usual_capabilities(), {}, options("robochart.check"));
    client.open(lens_uri,
                "assertion /*^A1*/A1 : S is deadlock-free\n"
                "timed assertion /*^A2*/A2 : S terminates\n"
                "assertion : S is deadlock-free\n");
    const Answer lenses = client.request("textDocument/codeLens", lens_params);
    EXPECT_EQ(client.marks(Json::array({Json::object({{"uri", lens_uri}, {"range", lenses[0]["range"].json()}}),
                                        Json::object({{"uri", lens_uri}, {"range", lenses[1]["range"].json()}})})),
              "A1 A2");
    ASSERT_EQ(lenses.items().size(), 2U) << lenses.write();
    EXPECT_EQ(lenses[1]["command"],
              Json::object(
                  {{"title", "check"}, {"command", "robochart.check"}, {"arguments", Json::array({lens_uri, "A2"})}}));
}

/// Returns the title, command, name and place of each lens of a model.
std::vector<std::string> lenses_of(const std::string& text, Json commands) {
    Client client(testing::usual_capabilities(), {}, Json::object({{"commands", std::move(commands)}}));
    client.open("file:///p/a.rct", text);
    const Json params = Json::object({{"textDocument", Json::object({{"uri", "file:///p/a.rct"}})}});
    std::vector<std::string> result;
    for (const Answer& lens : client.request("textDocument/codeLens", params).items()) {
        const Json place = Json::object({{"uri", "file:///p/a.rct"}, {"range", lens["range"].json()}});
        EXPECT_EQ(lens["command"]["arguments"][0].text(), "file:///p/a.rct");
        result.push_back(lens["command"]["title"].text() + " " + lens["command"]["command"].text() + " " +
                         lens["command"]["arguments"][1].text() + " at " + client.marks(Json::array({place})));
    }
    return result;
}

constexpr const char* components = R"(package p
interface I { event e }
operation O() { initial i state A { } transition t { from i to A } }
stm /*^s*/S { initial i state A { } transition t { from i to A } }
controller /*^c*/C { stm /*^n*/N { initial i state A { } transition t { from i to A } } }
module /*^m*/M { robotic platform R { } cref c = C }
)";

TEST(CodeLens, DrawAndStepStandAtEachComponentWithAProcess) {
    EXPECT_EQ(lenses_of(components, Json::array({"robochart.draw", "robochart.step"})),
              (std::vector<std::string>{"draw robochart.draw p::S at s", "step robochart.step p::S at s",
                                        "draw robochart.draw p::C at c", "step robochart.step p::C at c",
                                        "draw robochart.draw p::C::N at n", "step robochart.step p::C::N at n",
                                        "draw robochart.draw p::M at m", "step robochart.step p::M at m"}));
}

TEST(CodeLens, AreThoseThatTheEditorHas) {
    EXPECT_EQ(lenses_of("stm /*^s*/S { }", Json::array({"robochart.step"})),
              (std::vector<std::string>{"step robochart.step S at s"}));
    EXPECT_TRUE(lenses_of("stm S { }", Json::array({"robochart.check"})).empty());
    EXPECT_EQ(lenses_of("stm /*^s*/S { initial", Json::array({"robochart.draw"})),
              (std::vector<std::string>{"draw robochart.draw S at s"}))
        << "also in broken text";
    EXPECT_TRUE(lenses_of("stm", Json::array({"robochart.draw"})).empty());
}

}  // namespace
}  // namespace robochart::lsp
