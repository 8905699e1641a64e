// SPDX-License-Identifier: Apache-2.0
// Converts the shared IR to its CSP semantics: a CSPM syntax tree that both FDR and our checker can read. Names and
// alphabets are those of RoboTool (docs/semantics.md). The structure is our own: each machine is one sequential
// process, with its variables and clocks as parameters.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "csp_emit/base/emission.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// Emits all components of the system for one semantics (untimed or timed). The CSPM reader parses the CSP blocks and
/// reports syntax errors at their places in the .assertions file. Constructs without CSP semantics are reported by
/// name.
[[nodiscard]] Emission emit(const ir::System&, const ir::Instantiation&, Time, const Options&,
                            diagnostics::SourceManager&, diagnostics::Diagnostics&);

/// Returns the emission as files that FDR loads: csp-gen/[timed/]NAME.csp and NAME_assertions.csp (which includes the
/// first). `notes` become comments at the head of the definitions, and may contain any text.
[[nodiscard]] std::vector<OutputFile> files(const Emission&, Time, const std::string& model,
                                            const std::vector<std::string>& notes = {});

}  // namespace robochart::csp_emit
