// SPDX-License-Identifier: Apache-2.0
// Tests that every type of a namespace is defined only once in a program. No compiler reports a violation across files
// (C++20, [basic.def.odr]), and the linker chooses one of the definitions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "tests/sanity/source_tree.hpp"

namespace robochart::sanity {
namespace {

/// A definition at the left margin.
struct Definition {
    std::string name;      ///< qualified with its named namespaces
    bool unnamed = false;  ///< true if it is in a namespace without name
};

/// Returns the definitions of a source that match the pattern. Its first group is the name. Relies on the layout of
/// clang-format: namespaces and what they contain start at the left margin. Nested and local definitions are left out.
std::vector<Definition> definitions(const std::string& text, const std::regex& pattern) {
    static const std::regex opening(R"((?:inline )?namespace ?([\w:]*) ?\{.*)");
    static const std::regex closing(R"(\}  // namespace.*)");
    std::vector<Definition> found;
    std::vector<std::string> namespaces;
    std::istringstream lines(text);
    std::smatch match;
    for (std::string line; std::getline(lines, line);) {
        if (std::regex_match(line, match, opening)) {
            namespaces.push_back(match[1]);
        } else if (std::regex_match(line, closing) && !namespaces.empty()) {
            namespaces.pop_back();
        } else if (std::regex_match(line, match, pattern)) {
            Definition definition;
            for (const std::string& part : namespaces)
                if (!part.empty()) definition.name += part + "::";
            definition.name += match[1].str();
            definition.unnamed = std::ranges::find(namespaces, "") != namespaces.end();
            found.push_back(std::move(definition));
        }
    }
    return found;
}

/// Returns the types that a source defines in named namespaces, with these namespaces.
std::set<std::string> defined_types(const std::string& text) {
    static const std::regex type(R"((?:class|struct|union|enum|enum class) (\w+)(?: final)?(?: :[^;]*| \{.*)?)");
    std::set<std::string> found;
    for (const Definition& definition : definitions(text, type))
        if (!definition.unnamed) found.insert(definition.name);
    return found;
}

std::vector<Definition> defined_constants(const std::string& text) {
    static const std::regex constant(
        R"((?:inline |static )?(?:constexpr|const) [\w:<>,*& ]*?[ *&](\w+)(?:\[\w*\])?(?: = |\{).*)");
    return definitions(text, constant);
}

/// Returns false for the projects for simulators. They have separate main programs, which are never linked together.
bool is_linked(const std::string& file) {
    return file.find("cpp_emit/projects/") == std::string::npos && file.find("/golden/") == std::string::npos;
}

TEST(Types, AreDefinedOnceInANamespace) {
    std::map<std::string, std::vector<std::string>> places;
    for (const std::filesystem::path& path : files(root(), {".hpp", ".cpp"})) {
        const std::string file = path.lexically_relative(root()).string();
        if (!is_linked(file)) continue;
        for (const std::string& type : defined_types(read_contents(path))) places[type].push_back(file);
    }
    EXPECT_GT(places.size(), 1000U);
    for (const auto& [type, files] : places) EXPECT_THAT(files, ::testing::SizeIs(1)) << type;
}

/// Builds compile several sources of a component together. Then a constant without linkage would hide the constant of a
/// header in all sources after it, and no compiler reports this.
TEST(Constants, OfSourcesHaveOtherNamesThanThoseOfHeaders) {
    std::set<std::string> of_headers;
    for (const std::string& file : program_files())
        if (file.ends_with(".hpp"))
            for (const Definition& constant : defined_constants(read_contents(root() / file)))
                of_headers.insert(constant.name);
    EXPECT_GT(of_headers.size(), 100U);
    for (const std::string& file : program_files()) {
        if (!file.ends_with(".cpp")) continue;
        for (const Definition& constant : defined_constants(read_contents(root() / file)))
            EXPECT_FALSE(constant.unnamed && of_headers.contains(constant.name)) << file << ": " << constant.name;
    }
}

TEST(Constants, AreFoundWithTheirNamespaces) {
    const auto found = defined_constants(
        "namespace a {\ninline constexpr std::size_t most = 3;\nnamespace {\nconstexpr const char* word = \"x\";\n"
        "const std::vector<int> list{1};\n    constexpr int local = 1;\n}  // namespace\n}  // namespace a\n");
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(found[0].name, "a::most");
    EXPECT_FALSE(found[0].unnamed);
    EXPECT_EQ(found[1].name, "a::word");
    EXPECT_TRUE(found[1].unnamed);
    EXPECT_EQ(found[2].name, "a::list");
}

TEST(Types, AreFoundInNamedNamespaces) {
    const std::string text =
        "struct Global {\n};\nnamespace a::b {\nclass First;\nclass Second final : public First {\n    struct Inner {\n"
        "};\nnamespace {\nstruct Hidden {};\n}  // namespace\nenum class Third { x };\n"
        "class Second::Part {\n};\n}  // namespace a::b\n";
    EXPECT_EQ(defined_types(text), (std::set<std::string>{"Global", "a::b::Second", "a::b::Third"}));
}

}  // namespace
}  // namespace robochart::sanity
