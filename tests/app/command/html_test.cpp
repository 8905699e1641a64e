// `--html`: the page says what the JSON says, marks elements that are there, and lets nothing of the model act.
#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>

#include "diagnostics/cache/digest.hpp"
#include "tests/app/command.hpp"

namespace robochart::app::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string contents(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> all(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    std::vector<std::string> result;
    for (auto at = std::sregex_iterator(text.begin(), text.end(), regex); at != std::sregex_iterator(); ++at)
        result.push_back((*at)[1]);
    return result;
}

/// What stands between these marks, each time.
std::vector<std::string> between(const std::string& text, const std::string& begin, const std::string& end) {
    std::vector<std::string> result;
    for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
        at += begin.size();
        result.push_back(text.substr(at, text.find(end, at) - at));
    }
    return result;
}

struct Both {
    std::string page;
    nlohmann::json json;
};

Both reported(const std::vector<std::string>& models) {
    const Folder folder;
    std::vector<std::string> words{"check", "--format", "json", "--no-cache", "--html", folder / "page.html"};
    words.insert(words.end(), models.begin(), models.end());
    const Ran ran = run(words);
    return {contents(folder / "page.html"), nlohmann::json::parse(ran.out)};
}

TEST(Html, HasTheStepsOfEachCounterexample) {
    for (const std::string study : {"aggregation", "swarm_taxis"}) {
        const Both both =
            reported({repository("corpus/" + study), repository("corpus/false_claims/" + study + ".assertions")});
        std::size_t failing = 0;
        const std::vector<std::string> claims = between(both.page, "<section class=\"claim\"", "</section>");
        for (const auto& assertion : both.json["assertions"]) {
            if (!assertion.contains("counterexample")) continue;
            ASSERT_LT(failing, claims.size());
            const std::string& claim = claims[failing++];
            EXPECT_EQ(between(claim, "<tr class=\"step\"", ">").size(),
                      assertion["counterexample"]["steps"].size() + 1);
        }
        EXPECT_GT(failing, 0U);
        EXPECT_EQ(claims.size(), failing);
        EXPECT_EQ(between(both.page, "<td class=\"answer", ">").size(), both.json["assertions"].size());
    }
}

// "0:e5 1:e9" in `data-on` and `data-fired`: element e5 of the first figure of the claim.
TEST(Html, MarksElementsOfItsDiagrams) {
    const Both both =
        reported({repository("corpus/aggregation"), repository("corpus/false_claims/aggregation.assertions")});
    std::size_t marks = 0;
    for (const std::string& claim : between(both.page, "<section class=\"claim\"", "</section>"))
        for (const std::string& list : all(claim, "data-(?:on|fired)=\"([^\"]*)\""))
            for (const std::string& mark : all(list, "([0-9]+:e[0-9]+)")) {
                ++marks;
                EXPECT_THAT(claim, HasSubstr("data-element=\"" + mark.substr(mark.find(':') + 1) + "\"")) << mark;
            }
    EXPECT_GT(marks, 10U);
}

TEST(Html, ActiveStatesAreThoseOfTheRun) {
    const Folder folder(
        {{"m.rct", R"(package p stm S { event e initial i state A { } state B { }
transition t0 { from i to A } transition t1 { from A to B trigger e } })"},
         {"m.assertions", "package q import p::* untimed assertion X : p::S::B is not reachable in p::S"}});
    const Both both = reported({folder.path()});
    const std::string claim = between(both.page, "<section class=\"claim\"", "</section>").at(0);
    const auto id_of = [&](const std::string& name) {
        return all(claim, "data-element=\"(e[0-9]+)\"><title>" + name + "</title>").at(0);
    };
    const auto on = all(claim, "data-on=\"([^\"]*)\"");
    EXPECT_EQ(on.front(), "") << "at the initial junction";
    EXPECT_EQ(on.back(), "0:" + id_of("state B"));
    EXPECT_THAT(claim, HasSubstr("data-fired=\"0:" +
                                 all(claim, "class=\"edge\" id=\"[^\"]*\" data-element=\"(e[0-9]+)\"").at(1)));
}

TEST(Html, IdsAreUnique) {
    const Both both =
        reported({repository("corpus/swarm_taxis"), repository("corpus/false_claims/swarm_taxis.assertions")});
    std::set<std::string> ids;
    for (const std::string& id : all(both.page, " id=\"([^\"]*)\"")) EXPECT_TRUE(ids.insert(id).second) << id;
}

TEST(Html, ItsPolicyNamesItsStylesAndItsScriptAlone) {
    const Both both =
        reported({repository("corpus/aggregation"), repository("corpus/false_claims/aggregation.assertions")});
    const std::string policy = between(both.page, "Content-Security-Policy\" content=\"", "\"").at(0);
    EXPECT_THAT(policy, HasSubstr("default-src 'none'"));
    EXPECT_THAT(policy, Not(HasSubstr("unsafe")));
    const auto scripts = between(both.page, "<script>", "</script>");
    ASSERT_EQ(scripts.size(), 1U);
    EXPECT_THAT(policy, HasSubstr("'" + diagnostics::policy_hash(scripts.front()) + "'"));
    for (const std::string& style : between(both.page, "<style>", "</style>"))
        EXPECT_THAT(policy, HasSubstr("'" + diagnostics::policy_hash(style) + "'"));
    EXPECT_TRUE(all(both.page, "( style=\"[^\"]*\")").empty()) << "the policy forbids attributes";
    EXPECT_TRUE(all(both.page, "((?:src|href)=\"[^#\"][^\"]*\")").empty()) << "nothing is fetched";
}

// FIPS 180-2, appendix B.1: SHA-256 of "abc".
TEST(Html, HashesAreThoseOfTheStandard) {
    EXPECT_EQ(diagnostics::policy_hash("abc"), "sha256-ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0=");
}

TEST(Html, NothingOfTheModelActs) {
    const std::string evil = "</script><img src=x onerror=alert(1)>\\\"'";
    const Folder folder({{"<b>x.rct", "package p stm S { event e : string initial i state A { entry send e!\"" + evil +
                                          "\" } transition t0 { from i to A } }"},
                         {"m.assertions",
                          "package q import p::* untimed assertion X : p::S is not deadlock-free\n"
                          "untimed assertion Y : p::S is deadlock-free"}});
    const Both both = reported({folder.path()});
    EXPECT_THAT(both.page, Not(HasSubstr("<img")));
    EXPECT_THAT(both.page, Not(HasSubstr("<b>")));
    EXPECT_EQ(between(both.page, "<script", "</script>").size(), 1U);
    EXPECT_THAT(both.page, HasSubstr("&lt;img"));
}

TEST(Html, ThatCannotBeWrittenIsAnError) {
    const Ran ran = run({"check", repository("corpus/aggregation"), "--untimed", "--html", "/proc/page.html"});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.err, HasSubstr("/proc/page.html"));
    EXPECT_THAT(ran.out, HasSubstr("checks hold")) << "what was found is printed all the same";
}

// The script in a browser: the step in the address is current, and its states are marked.
TEST(Html, StepsInABrowser) {
    if (std::system("command -v chromium > /dev/null 2>&1") != 0) GTEST_SKIP() << "chromium is not on PATH";
    const Ran ran = run_shell("\"$verify\" check " + repository("corpus/aggregation") + " " +
                              repository("corpus/false_claims/aggregation.assertions") +
                              " --html page.html > out.txt; timeout 60 chromium --headless --no-sandbox --disable-gpu "
                              "--enable-logging=stderr "
                              "--user-data-dir=profile --dump-dom \"file://$PWD/page.html#a11/s/4\"");
    EXPECT_THAT(ran.out, HasSubstr("<html lang=\"en\" class=\"scripted\">"));
    EXPECT_THAT(ran.out, HasSubstr("step 4 of 8: entered S1"));
    EXPECT_FALSE(all(ran.out, "<g (class=\"node on fired\")").empty());
    EXPECT_THAT(ran.err, Not(HasSubstr("CONSOLE")));
}

}  // namespace
}  // namespace robochart::app::testing
