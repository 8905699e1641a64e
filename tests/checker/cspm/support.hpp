// Helpers for the tests of the CSPM language.
#pragma once

#include <filesystem>
#include <string>

#include "checker/cspm/reader.hpp"
#include "diagnostics/diagnostic.hpp"
#include "diagnostics/render.hpp"

namespace robochart::cspm::test {

struct Reading {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    Script script;

    explicit Reading(std::string text) {
        script = read(sources, sources.add("test.csp", std::move(text)), diagnostics);
    }
    [[nodiscard]] bool ok() const { return diagnostics.ok(); }
    [[nodiscard]] std::string report() const { return diagnostics::render_text(sources, diagnostics); }
    /// The code of the first finding, or "".
    [[nodiscard]] std::string code() const {
        const auto all = diagnostics.sorted();
        return all.empty() ? "" : std::string(all.front().rule->code);
    }
};

/// The folder of scripts laid beside the repository; empty if it is absent.
inline std::filesystem::path shared_folder() {
    if (const char* given = std::getenv("ROBOCHART_SHARED")) return given;
    const std::filesystem::path beside = std::filesystem::path(ROBOCHART_SOURCE_DIR) / ".." / "shared";
    const std::filesystem::path worktree = std::filesystem::path(ROBOCHART_SOURCE_DIR) / ".." / ".." / "shared";
    if (std::filesystem::exists(beside)) return beside;
    return std::filesystem::exists(worktree) ? worktree : std::filesystem::path();
}

}  // namespace robochart::cspm::test
