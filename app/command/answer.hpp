// SPDX-License-Identifier: Apache-2.0
// Outputs the result of a run in formats for programs: on standard output in the format of --format, and in the files
// of --json, --junit and --sarif.
#pragma once

#include <functional>
#include <string>

#include "app/command/options.hpp"
#include "base/diagnostics/json.hpp"
#include "base/diagnostics/render.hpp"

namespace robochart::app {

/// Outputs the document in each requested format; the record of the run is added to JSON documents. Files are written
/// when the run ends. If the function is called again, the new document is appended.
void output_document(const Options&, const std::function<std::string(Format)>& document);

/// Outputs a document that exists only in JSON.
void output_json(const Options&, const diagnostics::Json& document);

/// True if the options request the result in this format, for standard output or a file.
[[nodiscard]] bool is_requested(const Options&, Format);

/// Returns the data about this run and its rules that a SARIF log contains.
[[nodiscard]] diagnostics::SarifRules about_log(const Options&, const std::string& limit = "");

}  // namespace robochart::app
