// SPDX-License-Identifier: Apache-2.0
// One name, one type: every type of a namespace must be defined once in a program. No compiler reports a violation
// across files (C++20, [basic.def.odr]), and the linker chooses one of the two.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <algorithm>

#include <regex>
#include <sstream>

#include "tests/sanity/source_tree.hpp"

namespace robochart::sanity {
namespace {

/// The types that a source defines in named namespaces, with these namespaces, without nested and local types. Relies
/// on the layout of clang-format: namespaces and their types start at the left margin.
std::set<std::string> defined_types(const std::string& text) {
    static const std::regex opening(R"((?:inline )?namespace ?([\w:]*) ?\{.*)");
    static const std::regex closing(R"(\}  // namespace.*)");
    static const std::regex type(R"((class|struct|union|enum|enum class) (\w+)( final)?( :[^;]*| \{.*)?)");
    std::set<std::string> found;
    std::vector<std::string> namespaces;
    std::istringstream lines(text);
    std::smatch match;
    for (std::string line; std::getline(lines, line);) {
        if (std::regex_match(line, match, opening)) {
            namespaces.push_back(match[1]);
        } else if (std::regex_match(line, closing) && !namespaces.empty()) {
            namespaces.pop_back();
        } else if (std::regex_match(line, match, type)) {
            std::string name;
            for (const std::string& part : namespaces) name += part + "::";
            const bool unnamed = std::ranges::find(namespaces, "") != namespaces.end();
            if (!unnamed) found.insert(name + match[2].str());
        }
    }
    return found;
}

/// The projects for simulators have separate main programs, which are never linked together.
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

TEST(Types, AreFoundInNamedNamespaces) {
    const std::string text =
        "struct Global {\n};\nnamespace a::b {\nclass First;\nclass Second final : public First {\n    struct Inner {\n"
        "};\nnamespace {\nstruct Hidden {};\n}  // namespace\nenum class Third { x };\n"
        "class Second::Part {\n};\n}  // namespace a::b\n";
    EXPECT_EQ(defined_types(text), (std::set<std::string>{"Global", "a::b::Second", "a::b::Third"}));
}

}  // namespace
}  // namespace robochart::sanity
