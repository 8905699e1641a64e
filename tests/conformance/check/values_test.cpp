// SPDX-License-Identifier: Apache-2.0
// Tests every kind of expression over composite values, in generated code and in the model: quantifiers,
// comprehensions, lambdas, functions and relations as values, the toolkit libraries, ranges, strings, vectors and
// matrices.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "conformance/check/conform.hpp"
#include "tests/conformance/bench.hpp"
#include "tests/conformance/check/expect_conforming.hpp"

namespace robochart::conformance {
namespace {

struct Case {
    const char* type;
    const char* text;  ///< over x : nat; each evaluation receives a new x
};

constexpr Case cases[] = {
    {"boolean", "forall v : nat @ v >= x"},
    {"boolean", "forall v : nat, b : boolean | v > x @ b \\/ v > 1"},
    {"boolean", "exists v : nat | v > x @ v > 1"},
    {"boolean", "exists1 v : nat @ v > x"},
    {"nat", "the v : nat | v == x @ v + 1"},
    {"Set(nat)", "{ v : nat | v >= x }"},
    {"Set(nat)", "{ v : nat | v >= x @ v + 1 }"},
    {"nat", "(lambda v : nat @ v + x)(1)"},
    {"nat", "(lambda v : nat, w : nat @ v + w)(x, 1)"},
    {"nat", "(table(x))(1)"},
    {"nat -> boolean", "lambda v : nat @ v > x"},
    {"Set(nat)", "union({x}, {0, 1})"},
    {"Set(nat)", "inter({x, 1}, {0, 1})"},
    {"Set(nat)", "diff({0, 1, 2}, {x})"},
    {"Set(nat)", "symetric_diff({0, 1}, {x, 1})"},
    {"Set(nat)", "Union({{x}, {1}})"},
    {"Set(nat)", "Inter({{x, 1}, {1, 2}})"},
    {"boolean", "notin(x, {0, 2})"},
    {"boolean", "subseteq({x}, {0, 1})"},
    {"boolean", "subset({x}, {0, 1})"},
    {"Set(nat)", "dom({(| x, true |), (| 1, false |)})"},
    {"Set(boolean)", "ran({(| x, true |), (| 1, false |)})"},
    {"nat <-> boolean", "dres({x}, {(| 0, true |), (| 1, false |)})"},
    {"nat <-> boolean", "rres({(| 0, true |), (| x, false |)}, {false})"},
    {"nat <-> boolean", "dsub({x}, {(| 0, true |), (| 1, false |)})"},
    {"nat <-> boolean", "rsub({(| 0, true |), (| x, false |)}, {false})"},
    {"nat <-> boolean", "override({(| 0, true |), (| 1, true |)}, {(| x, false |)})"},
    {"boolean <-> nat", "rinv({(| x, true |), (| 1, false |)})"},
    {"Set(boolean)", "rimage({(| x, true |), (| 1, false |)}, {1})"},
    {"boolean", "(| 0, 2 |) in relcomp({(| 0, x |)}, {(| 1, 2 |)})"},
    {"boolean", "(| 0, 2 |) in tr_closure({(| 0, x |), (| 1, 2 |)})"},
    {"boolean", "(| x, x |) in refl_tr_closure({(| 0, 1 |)})"},
    {"boolean", "(| 0, 2 |) in iter(2, {(| 0, x |), (| 1, 2 |)})"},
    {"boolean", "isInjection({(| 0, x |), (| 1, 2 |)} as nat -> nat)"},
    {"boolean", "isTotal({(| 0, true |), (| 1, true |), (| x, true |)} as nat -> boolean)"},
    {"nat", "first((| x, true |))"},
    {"nat", "size({x, 1})"},
    {"int", "min({x, 1})"},
    {"int", "max({x, 1})"},
    {"boolean", "hasMin({x})"},
    {"Seq(nat)", "reverse(<x, 1>)"},
    {"nat", "head(<x, 1>)"},
    {"nat", "last(<1, x>)"},
    {"Seq(nat)", "tail(<1, x>)"},
    {"Seq(nat)", "front(<1, x>)"},
    {"Seq(nat)", "concat(<x>, <1>)"},
    {"Seq(nat)", "filter(<x, 1>, {1, 2})"},
    {"Seq(nat)", "dconcat(<<x>, <1>>)"},
    {"Seq(nat)", "extract({2}, <1, x>)"},
    {"boolean", "prefix(<x>, <1, 2>)"},
    {"boolean", "suffix(<x>, <1, 2>)"},
    {"boolean", "infix(<x>, <0, 1, 1>)"},
    {"boolean", "isInjectiveSequence(<x, 1>)"},
    {"boolean", "x in {0 to 1}"},
    {"int", "size({x to 2}) - 1"},
    {"Seq(nat)", "<x> ^ <1>"},
    {"boolean", "<x> == <1>"},
    {"boolean", "{x, 1} == {1}"},
    {"string", "if x > 1 then \"far\" else \"near\" end"},
    {"boolean", "(if x > 0 then \"a\" else \"b\" end) == \"a\""},
    {"vector(nat, 2)", "[| x, 1 |] + [| 1, 1 |]"},
    {"vector(nat, 2)", "[| 2, 1 |] - [| x, 1 |]"},
    {"vector(nat, 2)", "x * [| 1, 0 |]"},
    {"vector(nat, 2)", "[| 1, 0 |] * x"},
    {"vector(nat, 2)", "[| 0, 1; 1, 0 |] * [| x, 1 |]"},
    {"vector(int, 2)", "- [| x, 1 |]"},
    {"nat", "[| x, 1 |] * [| 1, 1 |]"},
    {"nat", "[| 0, x; 1, 2 |][1, 2]"},
    {"boolean", "[| 0, x |] == [| 0, 1 |]"},
    {"boolean", "isBijection({(| true, x > 0 |), (| false, false |)} as boolean -> boolean)"},
    {"boolean", "partitions({(| 0, {x} |), (| 1, {1, 2} |)}, {0, 1, 2})"},
    {"boolean", "disjoint({(| 0, {x} |), (| 1, {1, 2} |)})"},
    {"Seq(nat)", "squash({(| 2 as int, x |), (| 1 as int, 1 |)} as int -> nat)"},
    {"Seq(int)", "range(1, 2)"},
    {"nat", "maplet(x, 1)[1]"},
    {"boolean", "(override(succ, {(| x, 0 |)}) as nat -> nat)(x) == 0"},
    {"boolean", "x in {0 to 1} /\\ x + 0 in {y : nat | y < 2}"},
    {"nat", "max({x, 1})"},
    {"real", "min({x, 0.5})"},
    {"real", "max({x, 0.5})"},
    {"real", "min({x, 1})"},
    {"boolean", "hasMax({x, 0.5})"},
};

/// Returns a machine that answers the first `go?x` with the first expression, the next `go?x` with the second, and so
/// on.
std::string model(std::size_t first, std::size_t last) {
    std::map<std::string, std::string> events;
    std::string states, transitions = "transition begin { from i to s0 }\n";
    for (std::size_t c = first; c < last; ++c) {
        const std::string event = events.emplace(cases[c].type, fmt::format("out{}", events.size())).first->second;
        states += fmt::format("state s{} {{ }}\n", c - first);
        transitions += fmt::format("transition t{0} {{ from s{0} to s{1} trigger go?x action {2}!({3}) }}\n", c - first,
                                   c + 1 == last ? 0 : c - first + 1, event, cases[c].text);
    }
    std::string text =
        "import set_toolkit::*\nimport relation_toolkit::*\nimport function_toolkit::*\nimport sequence_toolkit::*\n"
        "function table(n : nat) : nat -> nat { }\n"
        "function succ(n : nat) : nat { postcondition n < 2 => result == n + 1 postcondition n == 2 => result == 0 }\n"
        "stm Values {\nevent go : nat\nvar x : nat\ninitial i\n";
    for (const auto& [type, event] : events) text += fmt::format("event {} : {}\n", event, type);
    return text + states + transitions + "}\n";
}

void expect_cases(std::size_t first, std::size_t last) {
    test::Model read(test::ModelFolder(model(first, last)).path());
    if (!read.diagnostics.ok()) return;
    Options options;
    options.flags = "-std=c++17 -O0 -fno-exceptions -fno-rtti -Wall -Wextra -Wpedantic -Wconversion -Werror";
    (void)test::expect_conforming(read, read.machine_named("Values"), options);
}

TEST(Values, EveryExpressionIsThatOfTheModel) {
    if (const char* only = std::getenv("ROBOCHART_VALUE")) {
        const std::size_t c = std::strtoul(only, nullptr, 10);
        return expect_cases(c, c + 1);
    }
    constexpr std::size_t at_once = 14;
    for (std::size_t c = 0; c < std::size(cases); c += at_once)
        expect_cases(c, std::min(c + at_once, std::size(cases)));
}

/// The machine receives every set of reals, including the empty set, which has no minimum or maximum.
TEST(Values, LeastAndGreatestOfTheRealsReceived) {
    const test::ModelFolder folder(R"(
        import set_toolkit::*
        import sequence_toolkit::*
        stm Values {
            event go : Set(real) event least : real event greatest : real event none
            var s : Set(real)
            initial i state A { } state B { }
            transition t0 { from i to A }
            transition t1 { from A to B trigger go?s }
            transition t2 { from B to A condition hasMin(s) action least!(min(s)) ; greatest!(max(union(s, {-0.5}))) }
            transition t3 { from B to A condition not hasMax(s) action none }
        })");
    test::Model read(folder.path());
    std::string report;
    for (const auto& finding : read.diagnostics.sorted_findings())
        report += std::string(finding.rule->code) + " " + finding.message() + "\n";
    ASSERT_TRUE(read.diagnostics.ok()) << report;
    test::Bench bench(read, read.machine_named("Values"));
    const Result result = bench.check_code();
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
}

}  // namespace
}  // namespace robochart::conformance
