// SPDX-License-Identifier: Apache-2.0
// Tests that the syntax generator produces every construct of the grammar, with and without its optional parts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>

#include "frontend/syntax/lexer.hpp"
#include "frontend/syntax/print.hpp"
#include "tests/random_models/models/random.hpp"
#include "tests/random_models/syntax/any_syntax.hpp"
#include "tests/random_models/syntax/structure.hpp"

namespace robochart::random_models {
namespace {

constexpr std::uint64_t tried = 400;

/// Returns the frequency of each word in the output of `structure_text`. Names are in backquotes and are not counted.
std::map<std::string, std::size_t> words_of(const std::string& text) {
    static const std::regex quoted("`[^`]*`|«[^»]*»");
    static const std::regex word("[A-Za-z0-9-]+");
    const std::string bare = std::regex_replace(text, quoted, "");
    std::map<std::string, std::size_t> counts;
    for (std::sregex_iterator at(bare.begin(), bare.end(), word), end; at != end; ++at) ++counts[at->str()];
    return counts;
}

void expect_all(const std::string& text, const std::vector<std::string>& words) {
    const auto counts = words_of(text);
    for (const std::string& word : words) {
        const auto found = counts.find(word);
        EXPECT_TRUE(found != counts.end() && found->second >= 10) << word << " is made too seldom";
    }
}

std::string many_files() {
    std::string all;
    for (std::uint64_t seed = 0; seed < tried; ++seed) all += structure_text(*any_syntax(seed));
    return all;
}

TEST(Coverage, EveryTypeAndExpression) {
    expect_all(many_files(), {"named",
                              "type-variable",
                              "Seq",
                              "Set",
                              "product",
                              "function",
                              "relation",
                              "vector",
                              "matrix",
                              "integer",
                              "real",
                              "string",
                              "boolean",
                              "name",
                              "result",
                              "to",
                              "from",
                              "unary",
                              "binary",
                              "if",
                              "let",
                              "forall",
                              "exists",
                              "exists1",
                              "lambda",
                              "the",
                              "as",
                              "is",
                              "member",
                              "index",
                              "call",
                              "tuple",
                              "record",
                              "sequence",
                              "set",
                              "range",
                              "set-range",
                              "matrix-of",
                              "inverse",
                              "transpose",
                              "comprehension",
                              "since",
                              "negate",
                              "not",
                              "iff",
                              "implies",
                              "or",
                              "and",
                              "eq",
                              "ne",
                              "gt",
                              "ge",
                              "lt",
                              "le",
                              "in",
                              "plus",
                              "minus",
                              "times",
                              "divide",
                              "modulus",
                              "concat",
                              "sinceEntry",
                              "closed",
                              "open",
                              "parenthesised"});
}

TEST(Coverage, EveryStatementAndCommunication) {
    expect_all(many_files(),
               {"skip",          "sequence-of", "if-statement",  "assignment", "communication", "call-of", "wait",
                "wait-interval", "reset",       "deadline",      "group",      "send",          "simple",  "input",
                "output",        "sync",        "from-variable", "predicate",  "value",         "upper",   "target"});
}

TEST(Coverage, EveryDeclaration) {
    expect_all(many_files(), {"package",
                              "import",
                              "all",
                              "diagram",
                              "given",
                              "record-type",
                              "record-word",
                              "field",
                              "enumeration",
                              "literal",
                              "function-declaration",
                              "precondition",
                              "postcondition",
                              "signature",
                              "parameter",
                              "terminates-flag",
                              "var",
                              "const",
                              "initially",
                              "event",
                              "broadcast",
                              "clock",
                              "interface",
                              "platform",
                              "operation",
                              "no-body",
                              "stm",
                              "controller",
                              "module",
                              "reference",
                              "connection",
                              "async",
                              "mult",
                              "uses",
                              "requires",
                              "provides",
                              "state",
                              "initial",
                              "final",
                              "junction",
                              "probabilistic",
                              "entry",
                              "during",
                              "exit",
                              "transition",
                              "trigger",
                              "legacy-trigger",
                              "probability",
                              "clock-reset",
                              "transition-deadline",
                              "else-condition",
                              "condition",
                              "action",
                              "bound"});
}

TEST(Coverage, EveryAssertion) {
    std::string all;
    for (std::uint64_t seed = 0; seed < tried; ++seed) all += structure_text(*any_assertions(seed));
    expect_all(all, {"deadlock-free", "divergence-free", "deterministic",
                     "timelock-free", "terminates",      "refines",
                     "equals",        "reachable",       "clock-initialised",
                     "event-missed",  "negated",         "both",
                     "timed",         "untimed",         "model",
                     "traces",        "failures",        "failures-divergences",
                     "tick-tock",     "constant-of",     "parameter-of",
                     "csp",           "verbatim",        "import",
                     "package"});
}

TEST(Coverage, EveryReservedWordIsUsedAsAName) {
    std::string all;
    for (std::uint64_t seed = 0; seed < tried; ++seed) all += frontend::to_text(*any_syntax(seed));
    for (const std::string_view word : frontend::reserved_words())
        EXPECT_THAT(all, ::testing::HasSubstr("^" + std::string(word)));
}

/// The expected numbers are the reference implementation's first numbers for the seed 1234567 (Vigna, splitmix64.c).
TEST(Coverage, RandomNumbersAreThoseOfSplitMix64) {
    Random random(1234567);
    EXPECT_EQ(random.next(), 6457827717110365317U);
    EXPECT_EQ(random.next(), 3203168211198807973U);
    EXPECT_EQ(random.next(), 9817491932198370423U);
}

}  // namespace
}  // namespace robochart::random_models
