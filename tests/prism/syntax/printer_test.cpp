// SPDX-License-Identifier: Apache-2.0
// Tests that printed text parses to the same tree.
#include "prism/syntax/printer.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "base/diagnostics/splitmix64.hpp"
#include "tests/needed.hpp"
#include "tests/prism/support.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::prism {
namespace {

using testing::Read;

void expect_same(const std::string& text) {
    Read read;
    const ExprPtr first = read_expression(read.sources, read.add(text), read.diagnostics);
    ASSERT_TRUE(first) << read.report();
    const std::string printed = print(first);
    const ExprPtr second = read_expression(read.sources, read.add(printed), read.diagnostics);
    ASSERT_TRUE(second) << printed << "\n" << read.report();
    EXPECT_TRUE(same_expr(first, second)) << text << "\n" << printed;
}

/// Returns a random expression with all constructs of the language, fully parenthesised.
std::string random_text(std::uint64_t& seed, int depth) {
    const auto sub = [&] { return "(" + random_text(seed, depth - 1) + ")"; };
    if (depth == 0) {
        const char* leaves[] = {"x", "1", "0.5", "true", "\"l\"", "max(x, 1)"};
        return leaves[diagnostics::splitmix64(seed) % 6];
    }
    const char* operators[] = {"=>", "<=>", "|", "&", "=", "!=", "<", "<=",   ">",   ">=",    "+",
                               "-",  "*",   "/", "^", "U", "W",  "R", "U<=3", "W>2", "R[1,2]"};
    switch (diagnostics::splitmix64(seed) % 8) {
        case 0:
            return "!" + sub();
        case 1:
            return "-" + sub();
        case 2:
            return sub() + "?" + sub() + ":" + sub();
        case 3:
            return "P>=0.5 [" + sub() + "]";
        case 4:
            return "F<(x+1) " + sub();
        default:
            return sub() + " " + operators[diagnostics::splitmix64(seed) % 21] + " " + sub();
    }
}

TEST(PrismPrinter, RandomExpressionsReadBack) {
    std::uint64_t seed = 7;
    for (int i = 0; i < 2000; ++i) expect_same(random_text(seed, 1 + i % 5));
}

TEST(PrismPrinter, QuestionsReadBack) {
    for (const char* text :
         {"Pmin<0.5 [ a U<=(k+1) b ]", "R{\"r\"}max=? [ F s=2 ]", "R{2}=? [ C<=k*2 ]", "R=? [ C ]", "R=? [ I=3 ]",
          "R=? [ S ]", "S>0.7 [ s=3 ]", "filter(+, P=? [ F=2 a ], \"init\")", "filter(forall, a)", "A [ G !E [ F a ] ]",
          "P=? [ X X a ]", "P=? [ a {b}{max} ]", "P>=1-p [ G>3 a ]"})
        expect_same(text);
}

TEST(PrismPrinter, TheModelsAtHandReadBack) {
    const std::filesystem::path shared = tests::shared_folder();
    ROBOCHART_NEEDS(!shared.empty(), "../shared");
    std::size_t models = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(shared / "suite/prism")) {
        if (entry.path().extension() != ".prism" || entry.path().filename().string().starts_with("Transition_system"))
            continue;
        Read read;
        std::string error;
        const auto source = read.sources.load_file(entry.path().string(), error);
        ASSERT_TRUE(source) << error;
        const std::string once = print(read_model(read.sources, *source, read.diagnostics));
        const std::string twice = print(read_model(read.sources, read.add(once), read.diagnostics));
        EXPECT_TRUE(read.diagnostics.ok()) << read.report();
        EXPECT_EQ(once, twice);
        ++models;
    }
    EXPECT_GT(models, 30U);
}

}  // namespace
}  // namespace robochart::prism
