// SPDX-License-Identifier: Apache-2.0
// Tests that the grammars of the extension contain exactly the words of the languages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <algorithm>

#include "assertion_words.hpp"
#include "checker/cspm/syntax/lexer.hpp"
#include "checker/cspm/types/builtins.hpp"
#include "claims/sleec/syntax/lexer.hpp"
#include "extension.hpp"
#include "frontend/project/project.hpp"
#include "frontend/syntax/lexer.hpp"
#include "frontend/syntax/parse.hpp"

namespace robochart::editors {
namespace {

using Words = std::set<std::string>;

bool starts_with_any(const std::string& scope, const std::vector<std::string>& prefixes) {
    return std::ranges::any_of(prefixes, [&](const std::string& prefix) { return scope.starts_with(prefix); });
}

TEST(GrammarWords, PlainTextLeavesOutWhatOnlyLooksAhead) {
    const auto grammar = nlohmann::json::parse(R"json({"patterns": [
        {"name": "keyword.x", "match": "(?<![\\w:])(?:one|two-way)(?!\\s*three|(?:four))\\b"},
        {"name": "entity.x", "match": "five"},
        {"begin": "(six)\\s+([A-Za-z_]\\w*)", "end": "seven", "beginCaptures": {"1": {"name": "keyword.y"}}}]})json");
    const auto keyword = [](const std::string& scope) { return scope.starts_with("keyword"); };
    EXPECT_EQ(grammar_words(grammar, keyword), (Words{"one", "two-way", "six", "seven"}));
}

TEST(GrammarWords, RoboChartIsTheTableOfReservedWords) {
    Words expected(frontend::reserved_words().begin(), frontend::reserved_words().end());
    expected.insert({"Set", "Seq"});  // `Set(` and `Seq(` are symbols
    const auto scope = [](const std::string& name) {
        return !name.starts_with("support.type.primitive") &&
               starts_with_any(name, {"keyword", "storage", "support", "constant.language", "variable.language"});
    };
    EXPECT_EQ(grammar_words(load_json("syntaxes/robochart.tmLanguage.json"), scope), expected);
}

TEST(GrammarWords, RoboSimIsTheTableOfItsWords) {
    const auto scope = [](const std::string& name) { return name == "keyword.other.robosim"; };
    Words expected(frontend::robosim_words().begin(), frontend::robosim_words().end());
    EXPECT_EQ(grammar_words(load_json("syntaxes/robosim.tmLanguage.json"), scope), expected);
    expected.insert({"schedulable", "simulation"});
    EXPECT_EQ(grammar_words(load_json("syntaxes/robosim-assertions.tmLanguage.json"), scope), expected);
}

/// `core` declares these types, which need no import.
TEST(GrammarWords, PrimitiveTypesAreThoseOfCore) {
    const auto scope = [](const std::string& name) { return name.starts_with("support.type.primitive"); };
    const Words words = grammar_words(load_json("syntaxes/robochart.tmLanguage.json"), scope);
    EXPECT_EQ(words, (Words{"nat", "int", "real", "boolean", "string"}));
    for (const std::string& word : words) {
        frontend::Model model;
        diagnostics::SourceManager sources;
        diagnostics::Diagnostics findings;
        const auto id = sources.add("t.rct", "interface I { event e: " + word + " }");
        model.files.push_back(frontend::parse(sources, id, false, findings));
        frontend::resolve(model, findings);
        EXPECT_TRUE(findings.ok()) << word << " is no type of core";
    }
}

Words parts(const Words& words) {
    Words result;
    for (const std::string& word : words)
        for (std::size_t begin = 0; begin <= word.size();) {
            const std::size_t end = std::min(word.find('-', begin), word.size());
            result.insert(word.substr(begin, end - begin));
            begin = end + 1;
        }
    return result;
}

TEST(GrammarWords, AssertionsAreTheWordsOfTheirParser) {
    Words expected = parts(assertion_words());
    ASSERT_THAT(expected, ::testing::IsSupersetOf({"assertion", "deadlock", "timelock", "csp", "rewards"}));
    // The included RoboChart grammar colours the first two words. The third word occurs only in the title of a fix.
    for (const char* word : {"import", "package", "write"}) expected.erase(word);
    const auto scope = [](const std::string& name) { return starts_with_any(name, {"keyword", "storage", "support"}); };
    const Words coloured = parts(grammar_words(load_json("syntaxes/robochart-assertions.tmLanguage.json"), scope));
    for (const std::string& word : expected) EXPECT_TRUE(coloured.contains(word)) << word;
    for (const std::string& word : coloured) EXPECT_TRUE(expected.contains(word)) << word;
}

bool is_cspm_keyword(const std::string& scope) {
    return !scope.starts_with("keyword.operator.refinement") && !scope.starts_with("support") &&
           starts_with_any(scope, {"keyword", "storage", "constant.language"});
}

TEST(GrammarWords, CspmIsTheTableOfItsWords) {
    Words expected{"print", "include"};  // are words only at the start of a line
    for (int kind = static_cast<int>(cspm::Tok::kw_false); kind <= static_cast<int>(cspm::Tok::kw_timed); ++kind)
        expected.emplace(cspm::spelling(static_cast<cspm::Tok>(kind)));
    EXPECT_EQ(grammar_words(load_json("syntaxes/cspm.tmLanguage.json"), is_cspm_keyword), expected);
}

TEST(GrammarWords, CspmBuiltInsAreTheTableOfBuiltIns) {
    const auto scope = [](const std::string& name) {
        return starts_with_any(name, {"support.function", "support.constant.process"});
    };
    const Words words = grammar_words(load_json("syntaxes/cspm.tmLanguage.json"), scope);
    for (const std::string& word : words) EXPECT_NE(cspm::find_builtin(word), nullptr) << word << " is not built in";
    for (int i = 0; i <= static_cast<int>(cspm::Builtin::dbisim); ++i) {
        const std::string name(cspm::builtin_name(static_cast<cspm::Builtin>(i)).name);
        EXPECT_TRUE(words.contains(name) || name == "true" || name == "false") << name << " is missing";
    }
}

TEST(GrammarWords, SleecIsTheTableOfItsWords) {
    const auto scope = [](const std::string& name) {
        return starts_with_any(name, {"keyword", "storage", "support", "constant.language"}) &&
               name != "keyword.operator.sleec";
    };
    const auto words = sleec::language_words();
    EXPECT_EQ(grammar_words(load_json("syntaxes/sleec.tmLanguage.json"), scope), Words(words.begin(), words.end()));
}

}  // namespace
}  // namespace robochart::editors
