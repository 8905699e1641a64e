// SPDX-License-Identifier: Apache-2.0
// Tests that the extension's manifest names only existing files, and that its lock file names no server.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "extension.hpp"

namespace robochart::editors {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

void expect_file(const json& path) {
    EXPECT_TRUE(std::filesystem::is_regular_file(extension_folder() / path.get<std::string>())) << path;
}

TEST(Manifest, NamesFilesThatExist) {
    const json manifest = load_json("package.json");
    expect_file(manifest.at("main"));
    for (const char* file : {"README.md", "CHANGELOG.md", "LICENSE"}) expect_file(file);
    const json& contributes = manifest.at("contributes");
    expect_file(manifest.at("icon"));
    for (const json& walkthrough : contributes.at("walkthroughs"))
        for (const json& step : walkthrough.at("steps")) expect_file(step.at("media").at("markdown"));
    for (const json& language : contributes.at("languages")) expect_file(language.at("configuration"));
    for (const json& snippets : contributes.at("snippets")) expect_file(snippets.at("path"));
    for (const json& grammar : contributes.at("grammars")) expect_file(grammar.at("path"));
}

TEST(Manifest, LanguagesCoverTheFilesOfTheProgram) {
    std::map<std::string, std::string> languages;
    const json manifest = load_json("package.json");
    for (const json& language : manifest.at("contributes").at("languages"))
        languages[language.at("extensions").at(0)] = language.at("id");
    const std::map<std::string, std::string> expected{
        {".rct", "robochart"},         {".assertions", "robochart-assertions"}, {".csp", "cspm"},
        {".sleec", "sleec"},           {".claims", "robochart-claims"},         {".rst", "robosim"},
        {".rsa", "robosim-assertions"}};
    EXPECT_EQ(languages, expected);
}

TEST(Manifest, GrammarsHaveTheirScopesAndLanguages) {
    const json contributes = load_json("package.json").at("contributes");
    std::set<std::string> languages;
    for (const json& language : contributes.at("languages")) languages.insert(language.at("id"));
    for (const json& grammar : contributes.at("grammars")) {
        EXPECT_EQ(load_json(grammar.at("path")).at("scopeName"), grammar.at("scopeName"));
        EXPECT_TRUE(languages.contains(grammar.at("language"))) << grammar;
        for (const json& embedded : grammar.value("embeddedLanguages", json::object()))
            EXPECT_TRUE(languages.contains(embedded)) << embedded;
    }
    for (const json& snippets : contributes.at("snippets")) EXPECT_TRUE(languages.contains(snippets.at("language")));
}

/// Checks that every `#name` that a grammar includes is in its repository, and that every other scope belongs to one of
/// the project's grammars.
void expect_includes(const json& node, const std::map<std::string, json>& grammars, const json& own) {
    if (node.is_object() && node.contains("include")) {
        const std::string target = node.at("include");
        const std::size_t hash = target.find('#');
        const std::string scope = target.substr(0, std::min(hash, target.size()));
        if (target == "$self") return;
        ASSERT_TRUE(scope.empty() || grammars.contains(scope)) << target;
        const json& grammar = scope.empty() ? own : grammars.at(scope);
        if (hash != std::string::npos) {
            EXPECT_TRUE(grammar.at("repository").contains(target.substr(hash + 1))) << target;
        }
    }
    if (node.is_structured())
        for (const json& child : node) expect_includes(child, grammars, own);
}

TEST(Manifest, GrammarsIncludeWhatExists) {
    std::map<std::string, json> grammars;
    const json manifest = load_json("package.json");
    for (const json& grammar : manifest.at("contributes").at("grammars"))
        grammars[grammar.at("scopeName")] = load_json(grammar.at("path"));
    EXPECT_EQ(grammars.size(), 7U);
    for (const auto& [scope, grammar] : grammars) expect_includes(grammar, grammars, grammar);
}

TEST(Manifest, CommandsAndSettingsAreUsedAndDocumented) {
    const json contributes = load_json("package.json").at("contributes");
    const std::string client = read_contents(extension_folder() / "client/extension.js");
    const std::string readme = read_contents(extension_folder() / "README.md");
    for (const json& command : contributes.at("commands")) {
        EXPECT_THAT(client, HasSubstr(command.at("command").get<std::string>()));
        EXPECT_THAT(readme, HasSubstr(command.at("title").get<std::string>()));
    }
    for (const auto& [name, setting] : contributes.at("configuration").at("properties").items()) {
        EXPECT_THAT(client, HasSubstr(name));
        EXPECT_THAT(readme, HasSubstr("`" + name + "`"));
    }
}

TEST(Manifest, TheLockFileNamesNoServerAndThePinnedVersions) {
    const std::string text = read_contents(extension_folder() / "package-lock.json");
    EXPECT_THAT(text, Not(HasSubstr("\"resolved\"")));
    EXPECT_THAT(text, Not(HasSubstr("registry.")));
    const json lock = json::parse(text);
    const json manifest = load_json("package.json");
    EXPECT_EQ(lock.at("version"), manifest.at("version"));
    for (const char* kind : {"dependencies", "devDependencies"})
        for (const auto& [name, version] : manifest.at(kind).items())
            EXPECT_EQ(lock.at("packages").at("node_modules/" + name).at("version"), version) << name;
    for (const auto& [name, package] : lock.at("packages").items())
        EXPECT_TRUE(name.empty() || package.contains("integrity")) << name;
}

}  // namespace
}  // namespace robochart::editors
