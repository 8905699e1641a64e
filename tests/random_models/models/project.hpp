// Random models as texts: the form that readers, editors, fuzzers and other tools take.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "diagnostics/source.hpp"
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

/// Lines of all files.
[[nodiscard]] std::size_t lines(const Project& project);
/// All files in one text, each under its path: for messages of failing tests.
[[nodiscard]] std::string listing(const Project& project);
/// Writes the files below a folder, which is made. On failure returns the cause in words, otherwise "".
[[nodiscard]] std::string write(const Project& project, const std::string& folder);

/// A project read and resolved, with what was found.
struct Loaded {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    frontend::Model model;

    /// The distinct codes of the errors, sorted and separated by blanks; "" if there is none.
    [[nodiscard]] std::string error_codes() const;
    /// What was found, as people see it.
    [[nodiscard]] std::string report() const;
};

/// Reads without resolving.
[[nodiscard]] std::unique_ptr<Loaded> parse(const Project& project);
/// Reads, adds the toolkits that are imported, resolves.
[[nodiscard]] std::unique_ptr<Loaded> load(const Project& project);

}  // namespace robochart::random_models
