// SPDX-License-Identifier: Apache-2.0
// Tests that every construct of the grammar (constructs.hpp) gives the expected tree, or is rejected by the rule that
// it violates.
#include <gtest/gtest.h>

#include <array>

#include "constructs.hpp"
#include "frontend/syntax/print.hpp"
#include "tests/frontend/fixture.hpp"
#include "tests/frontend/tree.hpp"

namespace robochart::frontend {
namespace {

using testing::read;
using testing::Row;
using testing::tree;

class Expressions : public ::testing::TestWithParam<Row> {};

const Machine& machine_of(const testing::Reading& reading) {
    return dynamic_cast<const Machine&>(*reading.file().declarations.at(0));
}

TEST_P(Expressions, GiveTheTree) {
    const auto reading = read(testing::as_guard(GetParam().text));
    EXPECT_TRUE(reading->findings.empty()) << reading->report();
    const Expr& condition = *machine_of(*reading).transitions.at(0)->condition;
    EXPECT_EQ(tree(condition), GetParam().expected);
    if (std::string_view(GetParam().text).starts_with("^")) return;  // escapes: the formatter writes them
    const auto again = read(testing::as_guard(to_text(condition)));
    EXPECT_EQ(tree(*machine_of(*again).transitions.at(0)->condition), GetParam().expected) << to_text(condition);
}

INSTANTIATE_TEST_SUITE_P(Atoms, Expressions, ::testing::ValuesIn(testing::atoms()));

INSTANTIATE_TEST_SUITE_P(Operators, Expressions, ::testing::ValuesIn(testing::operators()));

class Types : public ::testing::TestWithParam<Row> {};

TEST_P(Types, GiveTheTree) {
    const auto type_of = [](const testing::Reading& reading) -> const TypeExpr& {
        return *dynamic_cast<const Context&>(*reading.file().declarations.at(0)).variables.at(0)->type_expr;
    };
    const auto reading = read(testing::as_type(GetParam().text));
    EXPECT_TRUE(reading->findings.empty()) << reading->report();
    EXPECT_EQ(tree(type_of(*reading)), GetParam().expected);
    if (std::string_view(GetParam().text).starts_with("^")) return;  // escapes: the formatter writes them
    const auto again = read(testing::as_type(to_text(type_of(*reading))));
    EXPECT_EQ(tree(type_of(*again)), GetParam().expected) << to_text(type_of(*reading));
}

INSTANTIATE_TEST_SUITE_P(Grammar, Types, ::testing::ValuesIn(testing::types()));

class Statements : public ::testing::TestWithParam<Row> {};

TEST_P(Statements, GiveTheTree) {
    const auto statement_of = [](const testing::Reading& reading) -> const Stmt& {
        return *machine_of(reading).nodes.at(0)->actions.at(0).statement;
    };
    const auto reading = read(testing::as_entry(GetParam().text));
    EXPECT_TRUE(reading->findings.empty()) << reading->report();
    EXPECT_EQ(tree(statement_of(*reading)), GetParam().expected);
    if (std::string_view(GetParam().text).starts_with("^")) return;  // escapes: the formatter writes them
    const auto again = read(testing::as_entry(to_text(statement_of(*reading))));
    EXPECT_EQ(tree(statement_of(*again)), GetParam().expected) << to_text(statement_of(*reading));
}

INSTANTIATE_TEST_SUITE_P(Grammar, Statements, ::testing::ValuesIn(testing::statements()));

class Clauses : public ::testing::TestWithParam<Row> {};

/// Compares the clauses of a transition after `from a to b`, as `dump` shows them.
TEST_P(Clauses, GiveTheTree) {
    const auto reading = read(testing::as_clauses(GetParam().text));
    EXPECT_TRUE(reading->findings.empty()) << reading->report();
    const std::string dumped = reading->dumped();
    std::string clauses;
    for (std::size_t at = dumped.find('\n', dumped.find("transition t: a -> b")); at + 1 < dumped.size();) {
        const std::size_t end = dumped.find('\n', at + 1);
        const std::string line = dumped.substr(at + 1, end - at - 1);
        clauses += (clauses.empty() ? "" : "; ") + line.substr(line.find_first_not_of(' '));
        at = end;
    }
    EXPECT_EQ(clauses, GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(Grammar, Clauses, ::testing::ValuesIn(testing::clauses()));

class Declarations : public ::testing::TestWithParam<Row> {};

/// Compares the dump of a file without its first line, with `/` for line ends.
TEST_P(Declarations, GiveTheTree) {
    const auto reading = read(GetParam().text);
    EXPECT_TRUE(reading->findings.empty()) << reading->report();
    const std::string dumped = reading->dumped();
    std::string flat;
    for (std::size_t at = dumped.find('\n') + 1; at < dumped.size(); at = dumped.find('\n', at) + 1) {
        const std::string line = dumped.substr(at, dumped.find('\n', at) - at);
        const std::size_t indent = line.find_first_not_of(' ');
        flat += (flat.empty() ? "" : " / ") + std::string(indent / 2 - 1, '>') + line.substr(indent);
    }
    EXPECT_EQ(flat, GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(Grammar, Declarations, ::testing::ValuesIn(testing::declarations()));

class Assertions : public ::testing::TestWithParam<Row> {};

std::string shown(const Assertion& a) {
    constexpr std::array kinds = {"deadlock-free", "divergence-free", "deterministic", "timelock-free",
                                  "terminates",    "refines",         "equals",        "reachable",
                                  "clock",         "event",           "conforms"};
    constexpr std::array times = {"", "timed ", "untimed "};
    constexpr std::array models = {"FD", "T", "F", "TT"};
    std::string out = times.at(static_cast<std::size_t>(a.time)) + a.name + ": " + a.subject.text();
    out += std::string(a.subject.empty() ? "" : " ") + (a.negated ? "not " : "") +
           kinds.at(static_cast<std::size_t>(a.kind));
    if (!a.event.empty()) out += " " + a.event.text();
    if (!a.other.empty()) out += " " + a.other.text();
    if (a.time_units) out += " for " + std::to_string(*a.time_units);
    if (a.model) out += std::string(" in ") + models.at(static_cast<std::size_t>(*a.model));
    for (const AssertionParameter& p : a.parameters)
        out += (p.kind == ParameterKind::constant ? " c:" : " p:") + p.name.text() + "@" + p.context.text() + "=" +
               tree(*p.value);
    return out;
}

TEST_P(Assertions, GiveTheTree) {
    const auto reading = read(GetParam().text, true);
    EXPECT_TRUE(reading->findings.empty()) << reading->report();
    std::string out;
    for (const Assertion& a : reading->file().assertions) out += (out.empty() ? "" : " / ") + shown(a);
    for (const CspBlock& b : reading->file().csp_blocks) {
        out += (out.empty() ? "" : " / ") + std::string("csp ") + b.name + " [" + b.text + "]";
        for (const QualifiedName& name : b.associated) out += " " + name.text();
    }
    const auto add = [&](const std::string& text) { out += (out.empty() ? "" : " / ") + text; };
    const auto add_line = [&](const std::string& text) { add(text.substr(0, text.size() - 1)); };
    for (const auto& definition : reading->file().probabilistic_definitions) add_line(to_text(definition));
    for (const auto& assertion : reading->file().probabilistic_assertions) add_line(to_text(assertion));
    for (const KeptPart& part : reading->file().kept) add(part.text);
    EXPECT_EQ(out, GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(Grammar, Assertions, ::testing::ValuesIn(testing::assertions()));

// ---------------------------------------------------------------- texts that the grammar forbids

class Refused : public ::testing::TestWithParam<Row> {};

TEST_P(Refused, WithOneMessage) {
    const bool is_assertions =
        std::string(GetParam().text).starts_with("assertion") || std::string(GetParam().text).starts_with("timed");
    const auto reading = read(GetParam().text, is_assertions);
    EXPECT_EQ(reading->codes(), GetParam().expected) << GetParam().text << "\n" << reading->report();
}

INSTANTIATE_TEST_SUITE_P(Grammar, Refused, ::testing::ValuesIn(testing::refused()));

TEST(Constructs, ArtificialNeuralNetworksDoNotHideWhatFollows) {
    const auto reading = read(
        "module M { anncontroller N { params { event e } } controller C { } }\nannoperation O(x:real) { }\ntype T");
    EXPECT_EQ(reading->codes(), "RC-P27@1 RC-P27@2");
    ASSERT_EQ(reading->file().declarations.size(), 2U);
    EXPECT_EQ(dynamic_cast<const Component&>(*reading->file().declarations[0]).controllers.size(), 1U);
}

}  // namespace
}  // namespace robochart::frontend
