// SPDX-License-Identifier: Apache-2.0
// Tests that every choice in a snippet inserts valid text.
#include <gtest/gtest.h>

#include <map>
#include <regex>

#include "base/diagnostics/render.hpp"
#include "extension.hpp"
#include "frontend/project/project.hpp"
#include "frontend/syntax/parse.hpp"

namespace robochart::editors {
namespace {

using nlohmann::json;

std::string joined(const json& body) {
    std::string text;
    for (const json& line : body) text += line.get<std::string>() + "\n";
    return text;
}

/// Returns the snippet with the defaults of its placeholders. Each choice gets the option with this number, or its
/// first option.
std::string filled(const std::string& body, std::size_t choice) {
    static const std::regex field(R"(\$\{(\d+):([^}]*)\}|\$\{(\d+)\|([^|]*)\|\}|\$(\d+))");
    std::map<std::string, std::string> defaults;
    std::string out;
    auto last = body.cbegin();
    for (std::sregex_iterator it(body.begin(), body.end(), field); it != std::sregex_iterator(); ++it) {
        const std::smatch& found = *it;
        out.append(last, found[0].first);
        last = found[0].second;
        if (found[1].matched) {
            out += defaults.emplace(found[1], found[2]).first->second;
        } else if (found[3].matched) {
            std::vector<std::string> options;
            std::stringstream list(found[4]);
            for (std::string option; std::getline(list, option, ',');) options.push_back(option);
            out += defaults.emplace(found[3], options[choice < options.size() ? choice : 0]).first->second;
        } else {
            out += defaults[found[5]];
        }
    }
    return out.append(last, body.cend());
}

/// Returns the syntax errors of the text. With `resolve`, also returns errors of names, types and rules.
std::string errors(const std::string& text, bool is_assertions, bool resolve) {
    frontend::Model model;
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const auto id = sources.add(is_assertions ? "t.assertions" : "t.rct", text);
    model.files.push_back(frontend::parse(sources, id, is_assertions, findings));
    if (resolve) frontend::resolve(model, findings);
    return findings.ok() ? "" : diagnostics::render_text(sources, findings);
}

/// The context for each snippet of models, in which `%` stands for the snippet.
const std::map<std::string, std::string> places = {
    {"state", "stm M { % }"},   {"composite", "stm M { % }"}, {"transition", "stm M { % }"},
    {"trigger", "stm M { % }"}, {"after", "stm M { % }"},     {"stm", "%"},
    {"operation", "%"},         {"controller", "%"},          {"module", "%"},
    {"interface", "%"},         {"opinterface", "%"},         {"function", "%"},
};

std::string placed(const std::string& place, const std::string& snippet) {
    const std::size_t at = place.find('%');
    return place.substr(0, at) + snippet + place.substr(at + 1);
}

TEST(Snippets, FillingIn) {
    EXPECT_EQ(filled("${1:a} $1 ${2|x,y|}$2$0\n", 1), "a a yy\n");
    EXPECT_EQ(filled("${1:a} ${1:a} ${2|x,y|}", 7), "a a x");
}

TEST(Snippets, ModelsParse) {
    const json snippets = load_json("snippets/robochart.json");
    EXPECT_EQ(snippets.size(), places.size());
    for (const auto& [name, snippet] : snippets.items()) {
        SCOPED_TRACE(name);
        const std::string prefix = snippet.at("prefix");
        ASSERT_TRUE(places.contains(prefix)) << prefix;
        EXPECT_GE(snippet.at("description").get<std::string>().size(), 10U);
        EXPECT_EQ(errors(placed(places.at(prefix), filled(joined(snippet.at("body")), 0)), false, false), "");
    }
}

TEST(Snippets, AssertionsParseWithEveryChoice) {
    const json snippets = load_json("snippets/assertions.json");
    EXPECT_GE(snippets.size(), 7U);
    for (const auto& [name, snippet] : snippets.items())
        for (std::size_t choice = 0; choice < 4; ++choice) {
            SCOPED_TRACE(name);
            EXPECT_GE(snippet.at("description").get<std::string>().size(), 10U);
            EXPECT_EQ(errors(filled(joined(snippet.at("body")), choice), true, false), "");
        }
}

/// Snippets of whole elements satisfy all rules, not only the syntax.
TEST(Snippets, WholeElementsAreWellFormed) {
    const json snippets = load_json("snippets/robochart.json");
    for (const char* name :
         {"State machine", "Operation", "Interface of events", "Interface of operations", "Function"})
        EXPECT_EQ(errors(filled(joined(snippets.at(name).at("body")), 0), false, true), "") << name;
}

}  // namespace
}  // namespace robochart::editors
