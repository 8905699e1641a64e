// SPDX-License-Identifier: Apache-2.0
// Parses and resolves model text for tests.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>

#include "base/diagnostics/diagnostic.hpp"
#include "base/diagnostics/render.hpp"
#include "frontend/project/project.hpp"
#include "frontend/syntax/parse.hpp"
#include "frontend/toolkits/toolkits.hpp"
#include "tests/contents.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::frontend::testing {

using tests::read_contents;

/// A parsed text with its model, sources and findings.
struct Reading {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    Model model;

    /// Returns the findings in readable form.
    [[nodiscard]] std::string report() const { return diagnostics::render_text(sources, findings); }
    [[nodiscard]] std::string dumped(bool resolved = false) const { return dump_model(model, sources, resolved); }
    /// Returns "CODE@line" of each finding, in order and joined by blanks.
    [[nodiscard]] std::string codes() const {
        std::string out;
        for (const auto& d : findings.sorted_findings()) {
            const std::uint32_t line = d.span.is_known() ? sources.position(d.span.source, d.span.begin).line : 0;
            out += (out.empty() ? "" : " ") + std::string(d.rule->code) + "@" + std::to_string(line);
        }
        return out;
    }
    [[nodiscard]] const File& file() const { return *model.files.front(); }
};

/// Parses without resolving.
inline std::unique_ptr<Reading> read(std::string text, bool is_assertions = false) {
    auto reading = std::make_unique<Reading>();
    const auto id = reading->sources.add(is_assertions ? "t.assertions" : "t.rct", std::move(text));
    reading->model.files.push_back(parse(reading->sources, id, is_assertions, reading->findings));
    return reading;
}

/// Parses and resolves, with the imported toolkits.
inline std::unique_ptr<Reading> resolved(std::string text, bool is_assertions = false) {
    auto reading = read(std::move(text), is_assertions);
    add_toolkits(reading->sources, reading->model, reading->findings);
    resolve(reading->model, reading->findings);
    return reading;
}

using robochart::tests::shared_folder;

}  // namespace robochart::frontend::testing
