// SPDX-License-Identifier: Apache-2.0
// Lowers the text of models to IR, for tests.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "frontend/project/project.hpp"
#include "semantics/ir/ir.hpp"
#include "semantics/lower/lower.hpp"

namespace robochart::ir::samples {

/// A project in memory that is parsed, resolved and lowered.
struct Lowered {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    frontend::Model model;
    System system;

    [[nodiscard]] std::vector<std::string> codes() const;  ///< the codes of all findings except advice (RC-W), by place
    [[nodiscard]] std::string messages() const;
    [[nodiscard]] const Machine& machine(const std::string& path) const;
    [[nodiscard]] const Controller& controller(const std::string& path) const;
    [[nodiscard]] const Node& node(const std::string& machine, const std::string& path) const;
    [[nodiscard]] const Transition& transition(const std::string& machine, const std::string& name) const;
    /// Returns the guard of a transition as text.
    [[nodiscard]] std::string guard(const std::string& machine, const std::string& name) const;
    [[nodiscard]] std::string text(const std::string& machine, const ExprPtr&) const;
};

struct SourceText {
    std::string path;
    std::string text;
};

[[nodiscard]] std::unique_ptr<Lowered> lower_files(const std::vector<SourceText>& files);
/// Lowers one .rct text and, if not empty, one .assertions text. Errors fail the test.
[[nodiscard]] std::unique_ptr<Lowered> lower_text(const std::string& rct, const std::string& assertions = "");
/// Lowers a file or folder. Errors fail the test.
[[nodiscard]] std::unique_ptr<Lowered> lower_path(const std::string& path);
/// Returns the machine `S` with this body and a state `A` after the initial node.
[[nodiscard]] std::string machine_text(const std::string& body);

}  // namespace robochart::ir::samples
