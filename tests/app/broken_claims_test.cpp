// An assertion file with errors does not stop the claims of others; what may depend on it is not decided.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "tests/app/command.hpp"

namespace robochart::app::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string model =
    "stm M {\n event go\n initial i state A { }\n transition t0 { from i to A }\n transition t1 { from A to A trigger "
    "go }\n}\n";
const std::string good = "untimed assertion Good : M is deadlock-free.\n";
const std::string syntax_error =
    "untimed assertion Broken : M is dedlock-free.\nuntimed assertion Beside : M is divergence-free.\n";
const std::string unknown_name = "untimed assertion Broken : N is deadlock-free.\n";

using Files = std::vector<std::pair<std::string, std::string>>;

/// Title to answer, of the JSON report; empty where there is none.
std::map<std::string, std::string> answers(const Files& files, int exit) {
    const Folder folder(files);
    const Ran ran = run({"check", folder.path(), "--format", "json"});
    EXPECT_EQ(ran.exit, exit) << ran.out << ran.err;
    const auto json = nlohmann::json::parse(ran.out);
    std::map<std::string, std::string> result;
    if (!json.contains("assertions")) return result;
    for (const auto& each : json.at("assertions")) {
        const std::string title = each.at("title");
        result[title.substr(0, title.find(' '))] = each.at("answer");
    }
    return result;
}

TEST(BrokenClaims, OfAnotherFileAreReportedAndTheRestIsDecided) {
    const auto unread = answers({{"m.rct", model}, {"a.assertions", good}, {"b.assertions", syntax_error}}, 2);
    EXPECT_EQ(unread, (std::map<std::string, std::string>{{"Good", "holds"}, {"Beside", "error"}}));
    const auto unresolved = answers({{"m.rct", model}, {"a.assertions", good}, {"b.assertions", unknown_name}}, 2);
    EXPECT_EQ(unresolved, (std::map<std::string, std::string>{{"Good", "holds"}, {"Broken", "error"}}));
    const Folder folder({{"m.rct", model}, {"a.assertions", good}, {"b.assertions", unknown_name}});
    const Ran text = run({"check", folder.path()});
    EXPECT_EQ(text.exit, 2);
    EXPECT_THAT(text.out, HasSubstr("holds        Good"));
    EXPECT_THAT(text.out, HasSubstr("error        Broken"));
    EXPECT_THAT(text.out, HasSubstr("refused, with errors: b"));
    EXPECT_THAT(text.err, HasSubstr("b.assertions:1"));
}

TEST(BrokenClaims, OfABlockAreThoseOfItsFileAndOfFilesWithBlocks) {
    const std::string block = "csp Wrong csp-begin\nWrong = undeclared -> STOP\ncsp-end\n";
    const std::string own = "untimed assertion Own : M refines Wrong in the traces model.\n";
    const std::string other_block =
        "csp Right csp-begin\nRight = M::go.in -> Right\ncsp-end\nuntimed assertion WithBlock : M refines Right in the "
        "traces model.\n";
    const auto found = answers(
        {{"m.rct", model}, {"a.assertions", good}, {"b.assertions", block + own}, {"c.assertions", other_block}}, 2);
    ASSERT_TRUE(found.contains("Good"));
    EXPECT_EQ(found.at("Good"), "holds");
    EXPECT_EQ(found.at("Own"), "error");
    EXPECT_EQ(found.at("WithBlock"), "error");
}

// The process of a broken block is named from another file; the only block that replaces the instantiation does so for
// all files; a text that was not understood may hold any block.
TEST(BrokenClaims, ThatOthersMayDependOnStopThem) {
    const std::string wrong = "csp Wrong csp-begin\nWrong = undeclared -> STOP\ncsp-end\n";
    const std::string uses = "untimed assertion Uses : M refines Wrong in the traces model.\n";
    const std::string values = "csp Instantiations csp-begin\nnametype core_nat = undeclared\ncsp-end\n";
    EXPECT_TRUE(answers({{"m.rct", model}, {"a.assertions", uses}, {"b.assertions", wrong}}, 2).empty());
    EXPECT_TRUE(answers({{"m.rct", model}, {"a.assertions", good}, {"b.assertions", values}}, 2).empty());
    EXPECT_TRUE(answers({{"m.rct", model}, {"a.assertions", good}, {"b.assertions", wrong + syntax_error}}, 2).empty());
}

TEST(BrokenClaims, OfAModelStopEverything) {
    const auto found = answers(
        {{"m.rct", "stm M { initial i state A { } transition t0 { from i to B } }\n"}, {"a.assertions", good}}, 2);
    EXPECT_TRUE(found.empty());
}

TEST(BrokenClaims, AloneAreRefusedAsBefore) {
    EXPECT_TRUE(answers({{"m.rct", model}, {"b.assertions", unknown_name}}, 2).empty());
}

}  // namespace
}  // namespace robochart::app::testing
