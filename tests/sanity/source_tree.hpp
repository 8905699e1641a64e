// SPDX-License-Identifier: Apache-2.0
// The sources of the project: their folders and their includes.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/contents.hpp"

namespace robochart::sanity {

/// The root folder of the project.
[[nodiscard]] const std::filesystem::path& root();
using tests::read_contents;
/// Files below a folder with one of these extensions, sorted, without build trees.
[[nodiscard]] std::vector<std::filesystem::path> files(const std::filesystem::path& folder,
                                                       const std::set<std::string>& extensions);
/// The top folders with sources of the program.
[[nodiscard]] std::vector<std::string> components();
/// Sources of the program, relative to the root, without those of generated projects and of tests.
[[nodiscard]] std::vector<std::string> program_files();
/// The project's files that a source includes, relative to the root.
[[nodiscard]] std::vector<std::string> included(const std::string& file);
[[nodiscard]] std::string folder_of(const std::string& file);

/// A row of the table of folders in docs/architecture.md: the folders that its files may include, in addition to
/// `base/diagnostics` and its own folder.
struct FolderRow {
    std::set<std::string> allowed;   ///< "a/b"; "a/*": the folders below a
    std::set<std::string> excluded;  ///< "everything but": components or folders
    bool everything = false;
};
/// The rows by folder.
[[nodiscard]] std::map<std::string, FolderRow> folder_table();
[[nodiscard]] bool may_include(const FolderRow&, const std::string& folder);

/// Strongly connected components with more than one node; each of them sorted.
[[nodiscard]] std::vector<std::vector<std::string>> cycles(const std::map<std::string, std::set<std::string>>& edges);

}  // namespace robochart::sanity
