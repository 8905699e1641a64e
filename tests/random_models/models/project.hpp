// SPDX-License-Identifier: Apache-2.0
// Represents random models as texts, which are the input of parsers, editors, fuzzers and other tools.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "base/diagnostics/source.hpp"
#include "frontend/syntax/ast.hpp"

namespace robochart::random_models {

/// One file of a project.
struct Text {
    std::string path;  ///< relative; ends in `.rct` or `.assertions`
    std::string text;

    [[nodiscard]] bool is_assertions() const;
    friend bool operator==(const Text&, const Text&) = default;
};

/// The files of a project, in the order of their paths.
using Project = std::vector<Text>;

/// Returns the number of lines in all files that are not blank.
[[nodiscard]] std::size_t lines(const Project& project);
/// Returns all files in one text, each preceded by its path, for messages of failing tests.
[[nodiscard]] std::string listing(const Project& project);
/// Writes the files into a folder, which is created. Returns "", or the cause if this fails.
[[nodiscard]] std::string write(const Project& project, const std::string& folder);

/// A project that has been loaded and resolved, with its findings.
struct Loaded {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    frontend::Model model;

    /// Returns the distinct codes of the errors, sorted and separated by blanks, or "" if there is none.
    [[nodiscard]] std::string error_codes() const;
    /// Returns the findings in readable form.
    [[nodiscard]] std::string report() const;
};

/// Parses without resolving.
[[nodiscard]] std::unique_ptr<Loaded> parse(const Project& project);
/// Parses, adds the imported toolkits, and resolves.
[[nodiscard]] std::unique_ptr<Loaded> load(const Project& project);

}  // namespace robochart::random_models
