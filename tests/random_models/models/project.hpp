// SPDX-License-Identifier: Apache-2.0
// Random models as texts, the input of parsers, editors, fuzzers and other tools.
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

/// The number of lines that are not blank, in all files.
[[nodiscard]] std::size_t lines(const Project& project);
/// All files in one text, each preceded by its path, for messages of failing tests.
[[nodiscard]] std::string listing(const Project& project);
/// Writes the files into a folder, which is created. Returns "" or the cause of a failure.
[[nodiscard]] std::string write(const Project& project, const std::string& folder);

/// A project that is loaded and resolved, with the findings.
struct Loaded {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    frontend::Model model;

    /// The distinct codes of the errors, sorted and separated by blanks; "" if there is none.
    [[nodiscard]] std::string error_codes() const;
    /// The findings in readable form.
    [[nodiscard]] std::string report() const;
};

/// Parses without resolving.
[[nodiscard]] std::unique_ptr<Loaded> parse(const Project& project);
/// Parses, adds the imported toolkits, and resolves.
[[nodiscard]] std::unique_ptr<Loaded> load(const Project& project);

}  // namespace robochart::random_models
