// The answer of a run for programs: on standard output as --format says, and in the files that --json, --junit and
// --sarif name.
#pragma once

#include <functional>
#include <string>

#include "app/command/options.hpp"
#include "diagnostics/render.hpp"

namespace robochart::app {

/// Gives the document in each format for programs that is asked for. Files get it when the run ends, what comes later
/// behind what came before.
void answer(const Options&, const std::function<std::string(Format)>& document);

/// Whether a program is given the answer in this format.
[[nodiscard]] bool is_asked_for(const Options&, Format);

/// What a log in SARIF says of this run and of the rules.
[[nodiscard]] diagnostics::SarifRules about_log(const Options&, const std::string& limit = "");

}  // namespace robochart::app
