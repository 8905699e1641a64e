// SPDX-License-Identifier: Apache-2.0
// Checks the syntax, names and types of CSP blocks in the emitted script, without a search.
#pragma once

#include <optional>

#include "base/diagnostics/diagnostic.hpp"
#include "base/diagnostics/source.hpp"
#include "csp_emit/base/emission.hpp"
#include "frontend/syntax/ast.hpp"

namespace robochart::csp_emit {

/// Reports errors in the CSP blocks of a resolved model, at their places in the model's texts. For each unit of the
/// model (frontend/project/units.hpp) and each semantics (untimed, timed) of its blocks, emits the unit with the
/// generated instantiation. If a unit has errors or no script, checks only the syntax of its blocks.
void check_blocks(const frontend::Model&, const diagnostics::SourceManager&, diagnostics::Diagnostics&);

/// Returns the script of an assertion file without its blocks. It shows which names a block can use. Returns no value
/// if the model has errors.
[[nodiscard]] std::optional<Emission> emission_without_blocks(const frontend::Model&, const diagnostics::SourceManager&,
                                                              diagnostics::SourceId assertions, Time,
                                                              diagnostics::Budget*);

}  // namespace robochart::csp_emit
