// "check" above each assertion.
#include <gtest/gtest.h>

#include "tests/lsp/client.hpp"

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

}  // namespace
}  // namespace robochart::lsp
