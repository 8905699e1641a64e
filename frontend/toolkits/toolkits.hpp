// SPDX-License-Identifier: Apache-2.0
// Provides the libraries of the language (core, set_toolkit and others), which are part of the program (private to the
// front end).
#pragma once

#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// A toolkit: its package and its text (a file of frontend/toolkits/library).
struct Toolkit {
    std::string_view package;
    std::string_view text;
};

/// The package of `nat`, `int`, `real`, `boolean` and `string`, which needs no import.
inline constexpr std::string_view core_package = "core";

[[nodiscard]] const std::vector<Toolkit>& all_toolkits();

/// Sets the toolkits of the model to core, those that its files import, and those that these import in turn. Toolkits
/// that the model already contains are not parsed again, so the function may be called after every change.
void add_toolkits(diagnostics::SourceManager& sources, Model& model, diagnostics::Diagnostics& out);

}  // namespace robochart::frontend
