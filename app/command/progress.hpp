// How far a check has come, on standard error: one line that is drawn over and wiped, or JSON events, one a line.
#pragma once

#include <functional>
#include <string>

#include "app/command/options.hpp"
#include "checker/refine/verdict/check.hpp"

namespace robochart::app {

/// Whether somebody may be looking at a line on standard error and wants one.
[[nodiscard]] bool progress_line_wanted(const Options&);
/// What a check is to be given as Limits::progress; empty where nobody looks (standard error is no terminal, --quiet)
/// and no JSON is asked for. The line is wiped when the last copy of the function is gone.
[[nodiscard]] std::function<void(const refine::Progress&)> progress_of(const Options&, const std::string& subject);

/// "searching: 1,234,567 states, …", at most `width` columns.
[[nodiscard]] std::string progress_text(const refine::Progress&, std::size_t width);
/// One object (docs/cli.md, progress), without a line end.
[[nodiscard]] std::string progress_json(const refine::Progress&, const std::string& subject);

}  // namespace robochart::app
