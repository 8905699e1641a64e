// SPDX-License-Identifier: Apache-2.0
// Parses, explores and queries PRISM texts for tests.
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "base/diagnostics/render.hpp"
#include "prism/checks/check.hpp"
#include "prism/explore/state_space.hpp"
#include "prism/session/session.hpp"
#include "prism/syntax/reader.hpp"

namespace robochart::prism::testing {

/// A parsed text with its findings.
struct Read {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;

    diagnostics::SourceId add(const std::string& text, const std::string& path = "model.prism") {
        return sources.add(path, text);
    }
    /// Returns codes with lines, in the order of the text: "PRISM-P01:3 PRISM-P02:7".
    [[nodiscard]] std::string findings() const {
        std::string text;
        for (const diagnostics::Diagnostic& finding : diagnostics.sorted_findings()) {
            if (!text.empty()) text += " ";
            text += finding.rule->code;
            if (finding.span.is_known())
                text += ":" + std::to_string(sources.position(finding.span.source, finding.span.begin).line);
        }
        return text;
    }
    [[nodiscard]] std::string report() const { return diagnostics::render_text(sources, diagnostics); }
};

/// A model that has been checked, and explored for values of its constants. Throws std::runtime_error with the
/// findings.
struct Explored {
    explicit Explored(const std::string& model, const Values& constants = {}, const ExploreOptions& options = {}) {
        const ModelFile file = read_model(read.sources, read.add(model), read.diagnostics);
        if (read.diagnostics.ok()) checked = check_model(file, read.diagnostics);
        if (!checked) throw std::runtime_error(read.report());
        try {
            space.emplace(*checked, constants, options, read.diagnostics);
        } catch (const EvaluationError& error) {
            error.report(read.diagnostics);
            throw std::runtime_error(read.report());
        }
    }

    /// Returns the answer to one property. Definitions may precede it in the text.
    Result ask(const std::string& text, const SessionOptions& options = {}, const Values& constants = {}) {
        const PropertyFile file = read_properties(read.sources, read.add(text, "model.props"), read.diagnostics);
        CheckedProperties properties;
        if (read.diagnostics.ok()) properties = check_properties(*checked, file, read.diagnostics);
        if (!read.diagnostics.ok()) throw std::runtime_error(read.report());
        try {
            return Session(*space, properties, options).check(properties.properties.size() - 1, constants);
        } catch (const EvaluationError& error) {
            error.report(read.diagnostics);
            throw std::runtime_error(read.report());
        }
    }

    Read read;
    std::optional<CheckedModel> checked;
    std::optional<StateSpace> space;
};

/// Returns the message of the exception that `piece` throws, or "" if it throws none.
template <class Piece>
std::string failure_text(const Piece& piece) {
    try {
        piece();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

}  // namespace robochart::prism::testing
