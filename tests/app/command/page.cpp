// SPDX-License-Identifier: Apache-2.0
#include "tests/app/command/page.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdlib>
#include <regex>
#include <set>
#include <sstream>

#include "base/cache/digest.hpp"
#include "tests/app/command.hpp"

namespace robochart::app::testing {

using ::testing::HasSubstr;
using ::testing::Not;

std::vector<std::string> all_matches(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    std::vector<std::string> result;
    for (auto at = std::sregex_iterator(text.begin(), text.end(), regex); at != std::sregex_iterator(); ++at)
        result.push_back((*at)[1]);
    return result;
}

std::vector<std::string> texts_between(const std::string& text, const std::string& begin, const std::string& end) {
    std::vector<std::string> result;
    for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
        at += begin.size();
        result.push_back(text.substr(at, text.find(end, at) - at));
    }
    return result;
}

void expect_closed(const std::string& page) {
    const auto policies = texts_between(page, "Content-Security-Policy\" content=\"", "\"");
    ASSERT_EQ(policies.size(), 1U);
    const std::string& policy = policies.front();
    EXPECT_THAT(policy, HasSubstr("default-src 'none'"));
    EXPECT_THAT(policy, Not(HasSubstr("unsafe")));
    const auto scripts = texts_between(page, "<script>", "</script>");
    ASSERT_EQ(scripts.size(), 1U);
    EXPECT_THAT(policy, HasSubstr("'" + diagnostics::policy_hash(scripts.front()) + "'"));
    for (const std::string& style : texts_between(page, "<style>", "</style>"))
        EXPECT_THAT(policy, HasSubstr("'" + diagnostics::policy_hash(style) + "'"));
    EXPECT_TRUE(all_matches(page, "( style=\"[^\"]*\")").empty()) << "the policy forbids attributes";
    EXPECT_TRUE(all_matches(page, "((?:src|href)=\"[^#\"][^\"]*\")").empty()) << "nothing is fetched";
    std::set<std::string> ids;
    for (const std::string& id : all_matches(page, " id=\"([^\"]*)\"")) EXPECT_TRUE(ids.insert(id).second) << id;
}

std::vector<std::string> play_page(const std::string& written, const std::string& commands, const std::string& how) {
    const Ran ran =
        run_shell(written + " > out.txt && timeout 500 node " + repository("tests/app/command/browser.mjs") +
                  " page.html " + how + " <<'EOT'\n" + commands + "EOT\n");
    EXPECT_EQ(ran.exit, 0) << ran.err;
    std::vector<std::string> result;
    std::istringstream lines(ran.out);
    for (std::string line; std::getline(lines, line);) result.push_back(line);
    return result;
}

void InABrowser::SetUp() {
    for (const char* const program : {"chromium", "node"})
        if (std::system(fmt::format("command -v {} > /dev/null 2>&1", program).c_str()) != 0)
            GTEST_SKIP() << program << " is not on PATH";
}

}  // namespace robochart::app::testing
