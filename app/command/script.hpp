// SPDX-License-Identifier: Apache-2.0
// Loads a CSPM script for the verb `cspm`.
#pragma once

#include <string>
#include <vector>

#include "app/command/options.hpp"
#include "base/diagnostics/diagnostic.hpp"
#include "checker/cspm/syntax/syntax.hpp"
#include "checker/cspm/types/type_check.hpp"

namespace robochart::app {

/// A script with its findings and the types of its names. Every script is type checked before it is evaluated.
struct LoadedScript {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    cspm::Script script;
    std::vector<cspm::NamedType> types;
};

/// Parses the process as part of an assertion of the script, so that it is type checked in the scope in which it is
/// evaluated. Findings name the text `origin`. Returns null, with diagnostics, if the process is wrong.
[[nodiscard]] cspm::DeclPtr parse_process(LoadedScript& loaded, const std::string& process, const std::string& origin);
void load_script(const std::string& path, LoadedScript& loaded);
/// Prints the findings: as JSON to standard output if the options select JSON, otherwise as text to standard error.
void show_findings(const LoadedScript& loaded, const Options& options);

}  // namespace robochart::app
