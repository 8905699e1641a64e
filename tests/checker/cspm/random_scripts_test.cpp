// SPDX-License-Identifier: Apache-2.0
// Compares whole scripts with the naive reference. Random processes are printed as CSPM, then parsed, type checked,
// evaluated, compiled and compressed like a user's script. Then their assertions are decided one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "checker/cspm/session.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "tests/checker/cspm/support.hpp"
#include "tests/checker/processes/random_cases.hpp"

namespace robochart::cspm::test {
namespace {

using refine::Case;
using refine::Graphs;
using refine::Outcome;
using refine::RandomCases;

/// Returns false if a compression may change which tau `chase` follows.
bool has_one_meaning(const Case& test_case) {
    std::string text = show(test_case.script);
    text.erase(0, text.find("channel"));  // skip the declarations, which the script may not use
    const auto used = [&](const std::string& word) { return text.find(word) != std::string::npos; };
    const std::vector<std::string> compressions{"normal(",    "bisim(",     "diamond(",      "_factor(",
                                                "_compress(", "explicate(", "lazyenumerate("};
    return !used("chase(") || std::ranges::none_of(compressions, used);
}

/// How a script is decided. Processes that remain terms are either packed from the start, or never.
struct Way {
    const char* name;
    bool reduction;
    Packing packing;
};
const Way ways[] = {{"", false, {1U << 30U, std::nullopt, false}},
                    {", reduced", true, {}},
                    {", packed", false, {0, 1, false}},
                    {", packed by terms alone", false, {0, std::nullopt, true}}};

/// Returns the first wrong answer of the script, if any.
std::optional<std::string> fault(const Case& test_case, const Graphs& graphs, int& checks) {
    Reading reading(refine::script_with_assertions(test_case));
    if (reading.ok()) (void)check_types(reading.script, reading.diagnostics);
    if (!reading.ok()) return reading.report();
    for (const Way& way : ways) {
        Session session(reading.script);
        session.set_packing(way.packing);
        const std::vector<DeclPtr> assertions = session.assertions();
        for (std::size_t i = 0; i < assertions.size(); ++i) {
            const refine::Question& question = refine::questions()[i];
            const bool holds = expected(question, graphs, test_case.trace);
            refine::Limits limits;
            limits.reduction = way.reduction;
            refine::Verdict verdict;
            try {
                verdict = session.check(*assertions[i], limits).verdict;
            } catch (const std::logic_error& error) {
                return assertion(question, test_case.trace) + way.name + ": " + error.what();
            }
            if (verdict.outcome != (holds ? Outcome::holds : Outcome::fails))
                return assertion(question, test_case.trace) + (holds ? " should hold" : " should fail") + way.name;
            ++checks;
        }
    }
    return std::nullopt;
}

TEST(RandomScriptsTest, AgreeWithTheDefinitions) {
    const int required_checks = refine::wanted_checks(3'000);
    RandomCases cases(3);
    int checks = 0;
    while (checks < required_checks) {
        const RandomCases::Explored explored = cases.next();
        if (!has_one_meaning(explored.test_case) || !fault(explored.test_case, explored.graphs, checks)) continue;
        int ignored = 0;
        const auto wrong = [&](const Case& test_case) -> std::optional<std::string> {
            const auto graphs = has_one_meaning(test_case) ? explore(test_case, refine::largest_graph) : std::nullopt;
            return graphs ? fault(test_case, *graphs, ignored) : std::nullopt;
        };
        const Case least =
            refine::shrink(explored.test_case, [&](const Case& test_case) { return wrong(test_case).has_value(); });
        FAIL() << wrong(least).value_or("?") << "\n" << refine::script_with_assertions(least);
    }
    std::cout << checks << " random checks of scripts agree\n";
    RecordProperty("checks", checks);
}

}  // namespace
}  // namespace robochart::cspm::test
