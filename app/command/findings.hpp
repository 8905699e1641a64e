// SPDX-License-Identifier: Apache-2.0
// Prints the findings of a model, and writes files below the output folder.
#pragma once

#include <string>

#include "app/command/options.hpp"
#include "driver/model/pipeline.hpp"

namespace robochart::app {

/// Writes a file below `--out`. Returns false with a diagnostic if it cannot be written, or if this run has already
/// written a file of this name.
bool write_output(driver::Project&, const Options&, const std::string& path, const std::string& text);

/// Returns the exit code of a run that ends with errors, which is that for wrong usage if all errors are about the
/// command line.
[[nodiscard]] Exit refusal_code(const driver::Project&);

/// Prints the project's diagnostics as text to stderr.
void show_findings(const driver::Project&, const Options&);
/// Prints the project's diagnostics. In a format for programs, diagnostics that reject the model are printed to stdout
/// as the result of the run. Returns true if the model is acceptable.
bool show_diagnostics(const driver::Project&, const Options&);

}  // namespace robochart::app
