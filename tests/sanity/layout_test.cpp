// SPDX-License-Identifier: Apache-2.0
// Tests that the source tree has the structure of docs/architecture.md: folders, permitted includes, no cycles.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sanity/source_tree.hpp"

namespace robochart::sanity {
namespace {

using Edges = std::map<std::string, std::set<std::string>>;

std::string unit_of(const std::string& file) {
    return file.substr(0, file.rfind('.'));
}

/// Returns the includes from folder to folder, or from unit (header and source with the same name) to unit.
Edges edges_between(std::string (*node_of)(const std::string&)) {
    Edges edges;
    for (const std::string& file : program_files()) {
        Edges::mapped_type& to = edges[node_of(file)];
        for (const std::string& other : included(file))
            if (node_of(other) != node_of(file)) to.insert(node_of(other));
    }
    return edges;
}

TEST(Layout, AFileIncludesWhatTheRowOfItsFolderAllows) {
    const auto table = folder_table();
    EXPECT_GT(table.size(), 40U);
    for (const std::string& file : program_files()) {
        const std::string folder = folder_of(file);
        const auto row = table.find(folder);
        ASSERT_NE(row, table.end()) << "docs/architecture.md has no row for " << folder;
        for (const std::string& other : included(file)) {
            const std::string of = folder_of(other);
            if (of == folder || of == "base/diagnostics") continue;
            EXPECT_TRUE(may_include(row->second, of)) << file << " includes " << other << ", which the row of "
                                                      << folder << " in docs/architecture.md does not allow";
        }
    }
}

TEST(Layout, TheTableHasNoFolderThatIsNotThere) {
    for (const auto& [folder, row] : folder_table()) {
        EXPECT_TRUE(std::filesystem::is_directory(root() / folder)) << folder;
        for (const std::string& name : row.allowed) {
            const std::string there = name.ends_with("/*") ? name.substr(0, name.size() - 2) : name;
            EXPECT_TRUE(std::filesystem::is_directory(root() / there)) << folder << " may include " << name;
        }
    }
}

TEST(Layout, FoldersHaveNoCycle) {
    EXPECT_THAT(cycles(edges_between(folder_of)), ::testing::IsEmpty());
}

/// The permitted includes contain no cycle, so no later include can close one.
TEST(Layout, TheTableHasNoCycle) {
    const auto table = folder_table();
    Edges allowed;
    for (const auto& [folder, row] : table)
        for (const auto& [other, unused] : table)
            if (other != folder && may_include(row, other)) allowed[folder].insert(other);
    EXPECT_THAT(cycles(allowed), ::testing::IsEmpty());
}

/// A class with its own parts may consist of two units that include each other, but not more.
TEST(Layout, AtMostTwoUnitsIncludeEachOther) {
    for (const std::vector<std::string>& group : cycles(edges_between(unit_of)))
        EXPECT_LE(group.size(), 2U) << ::testing::PrintToString(group);
}

TEST(Layout, CyclesAreFound) {
    EXPECT_THAT(cycles({{"a", {"b"}}, {"b", {"c"}}, {"c", {"a", "d"}}, {"d", {}}}),
                ::testing::ElementsAre(std::vector<std::string>{"a", "b", "c"}));
    EXPECT_THAT(cycles({{"a", {"b", "c"}}, {"b", {"c"}}}), ::testing::IsEmpty());
}

}  // namespace
}  // namespace robochart::sanity
