// How far a check has come, on standard error: one line that is drawn over and wiped, lines of a log where standard
// error is no terminal, or JSON events, one a line.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "app/command/options.hpp"
#include "checker/refine/verdict/check.hpp"

namespace robochart::app {

/// Whether somebody may be looking at a line on standard error and wants one.
[[nodiscard]] bool progress_line_wanted(const Options&);
/// What a check is to be given as Limits::progress; empty where nothing is wanted (--progress never, --quiet). The line
/// is wiped when the last copy of the function is gone.
[[nodiscard]] std::function<void(const refine::Progress&)> progress_of(const Options&, const std::string& subject);

/// For logs: a line for each half minute of a phase. Short runs have none.
class ProgressLog {
public:
    explicit ProgressLog(std::string subject) : subject_(std::move(subject)) {}
    /// "A1 [timed] S is deadlock-free: searching 30 s: ...", where one is due; without a line end.
    [[nodiscard]] std::optional<std::string> line(const refine::Progress&);

private:
    std::string subject_;
    refine::Progress::Phase phase_ = refine::Progress::Phase::compiling;
    double due_ = 0;  ///< seconds of the phase
};

/// "searching: 1,234,567 states, …", at most `width` columns.
[[nodiscard]] std::string progress_text(const refine::Progress&, std::size_t width);
/// One object (docs/cli.md, progress), without a line end.
[[nodiscard]] std::string progress_json(const refine::Progress&, const std::string& subject);

}  // namespace robochart::app
