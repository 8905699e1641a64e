// SPDX-License-Identifier: Apache-2.0
// Compares the processes of the published scripts with published systems of equations. NAME-procTestK-expected.txt
// contains equations for procTestK, which must be strongly bisimilar to them. If a file has alternatives, one of them
// must be equal.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/build.hpp"
#include "tests/checker/cspm/support.hpp"
#include "tests/checker/lts/bisimilar.hpp"
#include "tests/contents.hpp"

namespace robochart::cspm::test {
namespace {

using tests::read_contents;

struct Equation {
    std::string name;
    std::string body;
};

/// Returns the sections between empty lines that contain an equals sign. The last section repeats the name of the
/// process.
std::vector<Equation> equations_in(const std::string& text) {
    std::vector<Equation> result;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find("\n\n", from), text.size());
        std::string part = std::regex_replace(text.substr(from, end - from), std::regex("\\s+"), " ");
        const std::size_t equals = part.find(" = ");
        if (equals != std::string::npos) result.push_back({part.substr(0, equals), part.substr(equals + 3)});
        from = end + 2;
    }
    return result;
}

bool in_a_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '\'' || c == ':' || c == '(';
}

/// Replaces every name in the text. Longer names are replaced first, because they may contain shorter ones.
std::string replaced(const std::string& text, const std::vector<std::pair<std::string, std::string>>& names) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const auto fits = [&](const auto& name) {
            const std::size_t end = at + name.first.size();
            return text.compare(at, name.first.size(), name.first) == 0 &&
                   (at == 0 || !in_a_name(text[at - 1]) || text[at - 1] == '(') &&
                   (end >= text.size() || !in_a_name(text[end]));
        };
        const auto name = std::ranges::find_if(names, fits);
        result += name == names.end() ? text.substr(at, 1) : name->second;
        at += name == names.end() ? 1 : name->first.size();
    }
    return result;
}

/// Converts the order of prioritisepo back to the four arguments of the language. In these files, the order is already
/// closed under transitivity.
std::string with_four_arguments(const std::string& body) {
    const std::size_t order = body.rfind(", {");
    std::set<std::string> events;
    std::set<std::string> below_tau;
    std::string pairs;
    const std::regex pair("\\(([^(),]+), ([^(),]+)\\)");
    for (auto match = std::sregex_iterator(body.begin() + static_cast<std::ptrdiff_t>(order), body.end(), pair);
         match != std::sregex_iterator(); ++match) {
        const std::string high = (*match)[1];
        events.insert((*match)[2]);
        if (high == "τ" || high == "✓") {
            below_tau.insert((*match)[2]);
            continue;
        }
        events.insert(high);
        pairs += (pairs.empty() ? "" : ", ") + match->str();
    }
    const auto list = [](const std::set<std::string>& set, const std::set<std::string>& without) {
        std::string text;
        for (const std::string& event : set)
            if (!without.contains(event)) text += (text.empty() ? "" : ", ") + event;
        return "{" + text + "}";
    };
    return body.substr(0, order) + ", " + list(events, {}) + ", {" + pairs + "}, " + list(events, below_tau) + ")";
}

/// Returns the equations as definitions of a script. The requested one is named `Equation_0`.
std::string definitions(std::vector<Equation> equations, const std::string& requested) {
    std::erase_if(equations,
                  [](const Equation& equation) { return equation.name == equation.body; });  // RUN({}) = RUN({})
    std::stable_partition(equations.begin(), equations.end(),
                          [&](const auto& equation) { return equation.name == requested; });
    std::vector<std::pair<std::string, std::string>> names{{"STOP(tock)", "Timed_stop"},
                                                           {"chase_no_cache(STOP)", "chase_nocache(STOP)"}};
    for (std::size_t i = 0; i < equations.size(); ++i)
        names.emplace_back(equations[i].name, "Equation_" + std::to_string(i));
    std::ranges::stable_sort(names, [](const auto& a, const auto& b) { return a.first.size() > b.first.size(); });
    std::string text;
    for (std::size_t i = 0; i < equations.size(); ++i) {
        std::string body = equations[i].body;
        if (body == "✓ -> STOP")
            body = "SKIP";
        else if (body.find("τ") != std::string::npos)
            body = with_four_arguments(body);
        else
            body = replaced(body, names);
        body = std::regex_replace(body, std::regex("^(\\{.*\\}) -> (.*)$"), "[] e_ : $1 @ e_ -> $2");
        text += "\nEquation_" + std::to_string(i) + " = " + body;
    }
    if (text.find("Timed_stop") != std::string::npos) text += "\nTimed_stop = tock -> Timed_stop";
    return text + "\n";
}

constexpr std::size_t most_states = 20'000;

lts::Graph graph_of(lts::TransitionSystem& system) {
    return lts::graph_of(system, most_states);
}

/// Compares the unfolded terms first, because the engine rejects the steps of some operators.
bool equal(Session& session, const ExprPtr& a, const ExprPtr& b) {
    constexpr int deepest_look = 100;
    const auto unfolded = [&](const ExprPtr& process) {
        return session.terms().unfold_calls(session.process(process), deepest_look);
    };
    if (unfolded(a) == unfolded(b)) return true;
    return lts::are_bisimilar(graph_of(*session.system(a)), graph_of(*session.system(b)));
}

/// Describes how the process differs from the file. Returns "" if it does not.
std::string find_difference(const std::filesystem::path& script, const std::string& process,
                            const std::filesystem::path& expected) {
    const std::string equations = definitions(equations_in(read_contents(expected)), process);
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics found;
    const Script read_script =
        read(sources, sources.add(script.string(), read_contents(script) + "\n" + equations), found);
    if (!found.ok()) return diagnostics::render_text(sources, found) + equations;
    try {
        Session session(read_script);
        return equal(session, build::name(process), build::name("Equation_0")) ? "" : "differs from" + equations;
    } catch (const EvaluationError& error) {
        return error.what() + equations;
    }
}

TEST(EquationsTest, PublishedProcessesAreWhatIsWrittenBeside) {
    const auto shared = shared_folder();
    if (shared.empty()) GTEST_SKIP() << "the folder of shared scripts is absent";
    const auto suite = shared / "suite" / "cspm";
    // In the first test two different lambda functions have the same name, and the file of the second test is empty.
    const std::set<std::string> unusable{"function_processes.csp procTest1", "event_channels.csp procTest1"};
    int compared = 0;
    for (const PublishedScript& published : published_scripts(suite)) {
        if (published.phase != "evaluator" || published.expectation != "accept") continue;
        const std::filesystem::path script = suite / published.file;
        for (int k = 1; k < 20; ++k) {
            const std::string process = "procTest" + std::to_string(k);
            const std::string stem = script.stem().string() + "-" + process + "-expected";
            std::string differences;
            bool fits = false;
            for (const std::string suffix : {"", "1", "2"}) {
                const auto file = script.parent_path() / (stem + suffix + ".txt");
                if (!std::filesystem::exists(file)) continue;
                const std::string found = find_difference(script, process, file);
                fits = fits || found.empty();
                differences += found + "\n";
            }
            if (differences.empty() || unusable.contains(script.filename().string() + " " + process)) continue;
            EXPECT_TRUE(fits) << published.file << " " << process << ": " << differences;
            ++compared;
        }
    }
    EXPECT_GT(compared, 30);
    RecordProperty("processes", compared);
}

}  // namespace
}  // namespace robochart::cspm::test
