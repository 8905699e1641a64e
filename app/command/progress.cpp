// SPDX-License-Identifier: Apache-2.0
#include "app/command/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "app/command/output.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/json.hpp"
#include "base/diagnostics/utf8.hpp"

namespace robochart::app {
namespace {

std::size_t terminal_width() {
    winsize size{};
    const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? size.ws_col : 80;
}

double per_second(std::uint64_t count, double seconds) {
    return seconds > 0 ? static_cast<double>(count) / seconds : 0;
}

/// Returns the growth of memory per stored state; 0 if there are too few states for an estimate.
double bytes_per_state(const refine::Progress& progress) {
    constexpr std::uint64_t few = 10'000;
    return progress.states < few ? 0 : static_cast<double>(progress.grown_bytes) / static_cast<double>(progress.states);
}

/// Returns a short form of the number: "950", "12.3 k", "4.56 M".
std::string short_number(double value) {
    if (value < 10'000) return fmt::format("{:.0f}", value);
    return value < 1e6 ? fmt::format("{:.1f} k", value / 1e3) : fmt::format("{:.2f} M", value / 1e6);
}

std::string fit_columns(std::string text, std::size_t width) {
    std::size_t columns = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (!diagnostics::is_continuation(text[i]) && ++columns > width) {
            text.resize(i);
            break;
        }
    }
    return text;
}

class Line {
public:
    void draw(const refine::Progress& progress) {
        drawn_ = true;
        redraw_error_line(progress_text(progress, terminal_width() - 1));
    }
    Line() = default;
    Line(const Line&) = delete;
    Line& operator=(const Line&) = delete;
    ~Line() {
        if (drawn_) redraw_error_line({});
    }

private:
    bool drawn_ = false;
};

}  // namespace

std::string progress_text(const refine::Progress& p, std::size_t width) {
    std::vector<std::string> parts;
    const bool compiling = p.phase == refine::Progress::Phase::compiling;
    if (compiling && p.components > 1) parts.push_back(fmt::format("component {} of {}", p.component, p.components));
    parts.push_back(short_number(static_cast<double>(p.states)) + " states");
    if (!compiling) {
        parts.push_back(short_number(static_cast<double>(p.transitions)) + " transitions");
        parts.push_back(short_number(per_second(p.states, p.seconds)) + "/s");
        parts.push_back(short_number(static_cast<double>(p.frontier)) + " waiting");
        parts.push_back(fmt::format("depth {}", p.depth));
    }
    parts.push_back(fmt::format("{} MiB", p.resident_bytes >> 20U));
    if (bytes_per_state(p) > 0) parts.push_back(fmt::format("{:.0f} B/state", bytes_per_state(p)));
    std::string text =
        fmt::format("{} {:.0f} s: {}", compiling ? "compiling" : "searching", p.seconds, fmt::join(parts, ", "));
    if (compiling && !p.part.empty()) text += ", " + diagnostics::escape_for_display(p.part);
    return fit_columns(std::move(text), width);
}

std::string progress_json(const refine::Progress& p, const std::string& subject) {
    const bool compiling = p.phase == refine::Progress::Phase::compiling;
    using diagnostics::round_to_places;
    diagnostics::Json json{{"event", "progress"},
                           {"subject", subject},
                           {"phase", compiling ? "compiling" : "searching"},
                           {"seconds", round_to_places(p.seconds, 3)},
                           {"states", p.states},
                           {"transitions", p.transitions},
                           {"statesPerSecond", round_to_places(per_second(p.states, p.seconds), 0)},
                           {"frontier", p.frontier},
                           {"depth", p.depth},
                           {"residentBytes", p.resident_bytes},
                           {"bytesPerState", round_to_places(bytes_per_state(p), 1)}};
    if (compiling) json.update({{"part", p.part}, {"component", p.component}, {"components", p.components}});
    return diagnostics::json_text(json);
}

std::optional<std::string> ProgressLog::next_line(const refine::Progress& progress) {
    constexpr double interval = 30;
    if (progress.phase != phase_ || due_ == 0) due_ = interval;
    phase_ = progress.phase;
    if (progress.seconds < due_) return std::nullopt;
    due_ = progress.seconds + interval;
    const std::string subject = subject_.empty() ? "" : diagnostics::escape_for_display(subject_) + ": ";
    return subject + progress_text(progress, 200);
}

bool progress_line_wanted(const OutputOptions& output) {
    return output.progress != ProgressMode::never && !output.quiet && error_is_a_terminal();
}

std::function<void(const refine::Progress&)> progress_of(const OutputOptions& output, const std::string& subject) {
    if (output.progress == ProgressMode::json)
        return [subject](const refine::Progress& progress) {
            print_error_styled(progress_json(progress, subject) + "\n");
        };
    if (output.progress == ProgressMode::never || output.quiet) return {};
    if (!error_is_a_terminal())
        return [log = std::make_shared<ProgressLog>(subject)](const refine::Progress& progress) {
            if (const auto line = log->next_line(progress)) print_error("{}\n", *line);
        };
    return [line = std::make_shared<Line>()](const refine::Progress& progress) { line->draw(progress); };
}

}  // namespace robochart::app
