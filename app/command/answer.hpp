// SPDX-License-Identifier: Apache-2.0
// The answer of a run for programs: on standard output in the format of --format, and in the files of --json, --junit
// and --sarif.
#pragma once

#include <functional>
#include <string>

#include "app/command/options.hpp"
#include "base/diagnostics/render.hpp"

namespace robochart::app {

/// Outputs the document in each requested format; a document in JSON also gets the record of the run. Files are written
/// when the run ends; later documents are appended.
void output_document(const Options&, const std::function<std::string(Format)>& document);

/// True if a program receives the answer in this format.
[[nodiscard]] bool is_requested(const Options&, Format);

/// The data of a SARIF log about this run and the rules.
[[nodiscard]] diagnostics::SarifRules about_log(const Options&, const std::string& limit = "");

}  // namespace robochart::app
