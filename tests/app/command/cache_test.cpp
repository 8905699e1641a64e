// SPDX-License-Identifier: Apache-2.0
// Tests that cached results of earlier runs make a run faster and change none of its answers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "tests/app/command.hpp"

namespace robochart::app::testing::cache_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Each of the two counters has at least 40 states, so their interleaving has at least 1,600.
const char* const script = R"(cat > s.csp <<'END'
channel up, down, left, right
N(a, b, n) = n < 40 & a -> N(a, b, n + 1) [] n > 0 & b -> N(a, b, n - 1)
Both = N(up, down, 0) ||| N(left, right, 1)
assert RUN({up, down, left, right}) [T= Both
assert STOP [T= Both |\ {left}
END
export XDG_CACHE_HOME="$PWD/cache"
)";

const std::string legend = "\nknown: an earlier run has decided it; --no-cache decides it again\n";

std::string without_times(std::string text) {
    if (const std::size_t at = text.find(legend); at != std::string::npos) text.erase(at, legend.size());
    text = std::regex_replace(text, std::regex("known|[0-9.,]+ (ms|s)\\b"), "TIME");
    return std::regex_replace(text, std::regex(" +TIME"), " TIME");
}

TEST(Cache, ASecondRunKnowsTheAnswers) {
    std::vector<std::string> outputs;
    for (const char* const runs : {"$verify cspm s.csp > first; $verify cspm s.csp", "$verify cspm s.csp",
                                   "$verify cspm s.csp > first; $verify cspm --no-cache s.csp"})
        outputs.push_back(run_shell(std::string(script) + runs).out);
    EXPECT_THAT(outputs[0], HasSubstr(" known\n"));
    EXPECT_THAT(outputs[0], HasSubstr(legend));
    EXPECT_THAT(outputs[1], Not(HasSubstr("known")));
    EXPECT_THAT(outputs[2], Not(HasSubstr("known")));
    EXPECT_THAT(outputs[0], HasSubstr("FAILS"));
    EXPECT_EQ(without_times(outputs[0]), without_times(outputs[1]));
    EXPECT_EQ(without_times(outputs[2]), without_times(outputs[1]));
}

TEST(Cache, WithoutOneNothingIsKept) {
    const Ran ran =
        run_shell(std::string(script) + "$verify cspm -q --no-cache s.csp > out; test ! -e cache && echo none");
    EXPECT_EQ(ran.out, "none\n") << ran.err;
}

TEST(Cache, ACacheThatCannotBeWrittenChangesNothing) {
    const Ran ran = run_shell(std::string(script) + "touch cache; $verify cspm -q s.csp | tail -n 1");
    EXPECT_THAT(ran.out, HasSubstr("1 of 2 checks hold, 1 fail"));
    EXPECT_EQ(ran.err, "");
}

TEST(Cache, CompiledCodeIsKept) {
    const std::string model = repository("corpus/aggregation");
    const Ran ran = run_shell("export XDG_CACHE_HOME=\"$PWD/cache\"; $verify conform -q " + model +
                              " && find cache -type f | wc -l && PATH= $verify conform -q " + model);
    // The second run finds no compiler whose version it could compare, so it must not use the cached object.
    EXPECT_THAT(ran.out, HasSubstr("1 of 1 controllers conform"));
    EXPECT_NE(ran.exit, 0);
    const Ran again = run_shell("export XDG_CACHE_HOME=\"$PWD/cache\"; for i in 1 2; do $verify conform -q " + model +
                                "; done; find cache -type f -size +8k | wc -l");
    EXPECT_THAT(again.out, HasSubstr("1 of 1 controllers conform\n1 of 1 controllers conform\n1\n"));
}

}  // namespace
}  // namespace robochart::app::testing::cache_test
