// SPDX-License-Identifier: Apache-2.0
// Reads scripts in the tests of the CSPM language.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "base/diagnostics/render.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/refine/verdict/verdict.hpp"
#include "tests/shared_folder.hpp"

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
    /// Returns the code of the first finding, or "".
    [[nodiscard]] std::string code() const {
        const auto all = diagnostics.sorted_findings();
        return all.empty() ? "" : std::string(all.front().rule->code);
    }
};

/// Returns h for holds, f for fails, and ? for inconclusive.
inline char outcome_letter(refine::Outcome outcome) {
    switch (outcome) {
        case refine::Outcome::holds:
            return 'h';
        case refine::Outcome::fails:
            return 'f';
        case refine::Outcome::inconclusive:
            break;
    }
    return '?';
}

using tests::shared_folder;

/// A row of suite/cspm/EXPECTED.tsv.
struct PublishedScript {
    std::string phase;        ///< parser, typechecker, evaluator …
    std::string expectation;  ///< accept or reject
    std::string file;         ///< below suite/cspm
};

/// Returns all rows, in order, without the heading.
inline std::vector<PublishedScript> published_scripts(const std::filesystem::path& suite) {
    std::vector<PublishedScript> result;
    std::ifstream table(suite / "EXPECTED.tsv");
    std::string line;
    std::getline(table, line);
    while (std::getline(table, line)) {
        std::istringstream row(line);
        PublishedScript& script = result.emplace_back();
        std::getline(row, script.phase, '\t');
        std::getline(row, script.expectation, '\t');
        std::getline(row, script.file, '\t');
    }
    return result;
}

}  // namespace robochart::cspm::test
