// A CSPM script as the verb `cspm` loads it.
#pragma once

#include <string>
#include <vector>

#include "app/command/options.hpp"
#include "checker/cspm/syntax/syntax.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "diagnostics/diagnostic.hpp"

namespace robochart::app {

/// A script with its findings and the types of its names; every script is type checked before it is evaluated.
struct LoadedScript {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    cspm::Script script;
    std::vector<cspm::NamedType> types;
};

/// The process as an assertion of the script: so it is read, and type checked as a process, where it will be evaluated.
/// `origin`: what findings name as its text. Null, with diagnostics, where it cannot be.
[[nodiscard]] cspm::DeclPtr asked_process(LoadedScript& loaded, const std::string& process, const std::string& origin);
void load_script(const std::string& path, LoadedScript& loaded);
/// As text to standard error, or as JSON to standard output where that is what is asked for.
void show_findings(const LoadedScript& loaded, const Options& options);

}  // namespace robochart::app
