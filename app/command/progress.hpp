// SPDX-License-Identifier: Apache-2.0
// Shows the progress of a check on standard error. On a terminal, it is one line that is redrawn and finally erased;
// otherwise, it is a sequence of log lines. It can also be printed as JSON events, one per line.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "app/command/options.hpp"
#include "checker/refine/verdict/check.hpp"

namespace robochart::app {

/// True if the options allow progress as a line on standard error, and standard error is a terminal.
[[nodiscard]] bool progress_line_wanted(const OutputOptions&);
/// Returns the function for Limits::progress; empty if no progress is wanted (--progress never, --quiet). The line is
/// erased when the last copy of the function is destroyed.
[[nodiscard]] std::function<void(const refine::Progress&)> progress_of(const OutputOptions&,
                                                                       const std::string& subject);

/// Prints progress for logs: one line per half minute of a phase. Shorter phases print no line.
class ProgressLog {
public:
    explicit ProgressLog(std::string subject) : subject_(std::move(subject)) {}
    /// Returns "A1 [timed] S is deadlock-free: searching 30 s: ...", without a line end; no value if no line is due.
    [[nodiscard]] std::optional<std::string> next_line(const refine::Progress&);

private:
    std::string subject_;
    refine::Progress::Phase phase_ = refine::Progress::Phase::compiling;
    double due_ = 0;  ///< time of the next line, in seconds since the beginning of the phase
};

/// Returns "searching: 1,234,567 states, …", with at most `width` columns.
[[nodiscard]] std::string progress_text(const refine::Progress&, std::size_t width);
/// Returns one JSON object (docs/cli.md, progress), without a line end.
[[nodiscard]] std::string progress_json(const refine::Progress&, const std::string& subject);

}  // namespace robochart::app
