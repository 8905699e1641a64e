// CSP blocks checked as `check` reads them, without deciding anything: syntax, names and types in the emitted script.
#pragma once

#include <optional>

#include "csp_emit/base/emission.hpp"
#include "diagnostics/diagnostic.hpp"
#include "diagnostics/source.hpp"
#include "frontend/syntax/ast.hpp"

namespace robochart::csp_emit {

/// Reports what is wrong in the CSP blocks of a resolved model, at their places in its texts. Each unit of the model
/// (frontend/project/units.hpp) is emitted with the generated instantiation, once for each time that a block is for. Of
/// a unit with errors, or one that has no script, the blocks are only read (syntax).
void check_blocks(const frontend::Model&, const diagnostics::SourceManager&, diagnostics::Diagnostics&);

/// The script that the blocks of an assertion file are part of, without any block: for the names that a block can
/// write. Nothing if the model has errors.
[[nodiscard]] std::optional<Emission> emission_without_blocks(const frontend::Model&, const diagnostics::SourceManager&,
                                                              diagnostics::SourceId assertions, Time,
                                                              diagnostics::Budget*);

}  // namespace robochart::csp_emit
