// SPDX-License-Identifier: Apache-2.0
// Finds the sources of the project, their folders and their includes.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/contents.hpp"

namespace robochart::sanity {

/// Returns the root folder of the project.
[[nodiscard]] const std::filesystem::path& root();
using tests::read_contents;
/// Returns files below a folder with one of these extensions, sorted, without build trees.
[[nodiscard]] std::vector<std::filesystem::path> files(const std::filesystem::path& folder,
                                                       const std::set<std::string>& extensions);
/// Returns the top folders with sources of the program.
[[nodiscard]] std::vector<std::string> components();
/// Returns sources of the program, relative to the root, without those of generated projects and of tests.
[[nodiscard]] std::vector<std::string> program_files();
/// Returns the project's files that a source includes, relative to the root.
[[nodiscard]] std::vector<std::string> included(const std::string& file);
[[nodiscard]] std::string folder_of(const std::string& file);

/// A row of the table of folders in docs/architecture.md. It contains the folders that its files may include, in
/// addition to `base/diagnostics` and its own folder.
struct FolderRow {
    std::set<std::string> allowed;   ///< "a/b", or "a/*" for the folders below a
    std::set<std::string> excluded;  ///< "everything but": components or folders
    bool everything = false;
};
/// Returns the rows by folder.
[[nodiscard]] std::map<std::string, FolderRow> folder_table();
[[nodiscard]] bool may_include(const FolderRow&, const std::string& folder);

/// Returns the strongly connected components with more than one node. Each of them is sorted.
[[nodiscard]] std::vector<std::vector<std::string>> cycles(const std::map<std::string, std::set<std::string>>& edges);

}  // namespace robochart::sanity
