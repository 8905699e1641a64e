// SPDX-License-Identifier: Apache-2.0
// Tests the whole command with random scripts, and compares it with the naive checker. The command reads a file,
// decides it, and reports as JSON and in a second format. Each script combines several processes. Each process is in
// its own module and is written in several ways.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/app/command.hpp"
#include "tests/checker/processes/random_cases.hpp"

namespace robochart::app::testing {
namespace {

using Json = nlohmann::json;
using refine::Case;
using refine::Question;
using refine::RandomCases;

constexpr std::size_t cases_a_script = 4;

/// Returns false if a compression may change which tau `chase` follows.
bool has_one_meaning(const Case& test_case) {
    std::string text = show(test_case.script);
    text.erase(0, text.find("channel"));
    const auto used = [&](const std::string& word) { return text.find(word) != std::string::npos; };
    const std::vector<std::string> compressions{"normal(",    "bisim(",     "diamond(",      "_factor(",
                                                "_compress(", "explicate(", "lazyenumerate("};
    return !used("chase(") || std::ranges::none_of(compressions, used);
}

/// Writes the statement that a name is a process in one of several ways. Some contain text that FDR never evaluates, or
/// a name with another meaning.
std::string written(std::mt19937_64& numbers, const std::string& name, const std::string& module,
                    const std::string& body) {
    switch (numbers() % 8) {
        case 0:
            return fmt::format("{0}_(1) = STOP\n{0}_(0) = {1}\n{0} = {0}_(0)\n", name, body);
        case 1:
            return fmt::format("{} = head(<{}, error(\"never\")>)\n", name, body);
        case 2:
            return fmt::format("({0}, {0}_) = ({1}, error(\"never\"))\n", name, body);
        case 3:
            return fmt::format("{} = mapLookup(mapFromList(<(0, error(\"never\")), (1, {})>), 1)\n", name, body);
        case 4:
            return fmt::format("{0} = let {1} = 1 within if {1} == 1 then {2} else STOP\n", name, module, body);
        case 5:
            return fmt::format("{0}_(<>) = error(\"none\")\n{0}_(<x> ^ _) = x\n{0} = {0}_(<{1}> ^ error(\"never\"))\n",
                               name, body);
        default:
            return fmt::format("{} = {}\n", name, body);
    }
}

/// Returns the process of the case as a module, or as an instance of a parameterised module.
std::string module_of(std::mt19937_64& numbers, const Case& test_case, const std::string& name) {
    std::string text;
    for (std::size_t i = 0; i < test_case.script.definitions.size(); ++i)
        text += fmt::format("P{} = {}\n", i, show(test_case.script.definitions[i]));
    std::string exported;
    for (std::size_t i = 0; i < test_case.script.mains.size(); ++i)
        exported += written(numbers, fmt::format("M{}", i), name, show(test_case.script.mains[i]));
    if (numbers() % 3 != 0) return fmt::format("module {}\n{}exports\n{}endmodule\n", name, text, exported);
    return fmt::format("module Of{0}(unused)\n{1}exports\n{2}endmodule\ninstance {0} = Of{0}(0)\n", name, text,
                       exported);
}

std::string in_module(std::string assertion, const std::string& module) {
    for (std::size_t at = 0; (at = assertion.find(" M", at)) != std::string::npos; at += 2)
        assertion.insert(at + 1, module + "::");
    return assertion;
}

struct Assertion {
    std::string text;
    bool holds;
};

class Scripts {
public:
    explicit Scripts(std::uint64_t purpose) : cases_(purpose), numbers_(purpose) {}

    void next() {
        refine::naive::Script none;
        script = show(none);
        // Which tau `chase` follows depends on the order in which events first occur. This assertion mentions them in
        // alphabetical order first.
        assertions = {{"assert RUN({a, b, c}) [T= STOP", true}};
        for (std::size_t i = 0; i < cases_a_script;) {
            const RandomCases::Explored explored = cases_.next();
            if (!has_one_meaning(explored.test_case)) continue;
            const std::string module = fmt::format("Case{}", i++);
            script += module_of(numbers_, explored.test_case, module);
            for (const Question& question : refine::questions())
                assertions.push_back({in_module(assertion(question, explored.test_case.trace), module),
                                      expected(question, explored.graphs, explored.test_case.trace)});
        }
        for (const Assertion& line : assertions) script += line.text + "\n";
    }
    std::vector<std::string> another_format() {
        switch (numbers_() % 5) {
            case 0:
                return {"--format", "plain"};
            case 1:
                return {"--format", "framed_json"};
            case 2:
                return {"--split"};
            case 3:
                return {"--split", "--reveal-taus", "--format", "plain"};
            default:
                return {"--reveal-taus", "--format", "json"};
        }
    }

    std::string script;
    std::vector<Assertion> assertions;

private:
    RandomCases cases_;
    std::mt19937_64 numbers_;
};

Ran run_on(const TemporaryFile& file, const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"cspm", file.path(), "--timeout", "60"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run(arguments);
}

TEST(RandomScripts, AreDecidedByTheCommandAsByDefinition) {
    const int script_count = refine::wanted_scripts(12);
    Scripts scripts(7);
    std::size_t checks = 0;
    for (int i = 0; i < script_count; ++i) {
        scripts.next();
        const bool all_hold = std::ranges::all_of(scripts.assertions, [](const Assertion& line) { return line.holds; });
        const TemporaryFile file("random.csp", scripts.script);
        const Ran ran = run_on(file, {"--format", "json"});
        ASSERT_EQ(ran.exit, all_hold ? 0 : 1) << ran.err << scripts.script;
        const Json reported = Json::parse(ran.out);
        ASSERT_EQ(reported["results"].size(), scripts.assertions.size()) << ran.out << scripts.script;
        for (std::size_t at = 0; at < scripts.assertions.size(); ++at) {
            const Json& result = reported["results"][at];
            const bool holds = scripts.assertions[at].holds;
            ASSERT_EQ(result["result"], holds ? 1 : 0) << scripts.assertions[at].text << "\n" << scripts.script;
            ASSERT_EQ(result["counterexamples"].size(), holds ? 0U : 1U) << scripts.assertions[at].text << "\n"
                                                                         << scripts.script;
            ++checks;
        }
        const std::vector<std::string> format = scripts.another_format();
        const Ran again = run_on(file, format);
        ASSERT_EQ(again.exit, ran.exit) << fmt::format("{}\n", format.front()) << again.err << scripts.script;
        ASSERT_FALSE(again.out.empty());
    }
    std::cout << checks << " checks of " << script_count << " scripts agree\n";
}

}  // namespace
}  // namespace robochart::app::testing
