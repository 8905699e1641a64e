// SPDX-License-Identifier: Apache-2.0
#include "driver/model/preferences.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "prism/emit/emit.hpp"
#include "prism/emit/preferences.hpp"
#include "prism/emit/rules.hpp"

namespace robochart::driver {

namespace {

/// Warns about ignored entries of the preferences file. The warning is given once, although the file may be read for
/// several claims.
void warn_of_ignored(Project& project, const ProbabilitySettings& settings, const std::vector<std::string>& ignored) {
    const auto reported = [](const diagnostics::Diagnostic& finding) {
        return finding.rule == &prism_emit::rules::ignored_preferences;
    };
    if (ignored.empty() || std::ranges::any_of(project.diagnostics.sorted_findings(), reported)) return;
    project.diagnostics.report(
        prism_emit::rules::ignored_preferences, {},
        {settings.preferences, fmt::format("{}", fmt::join(ignored, ", ")), ignored.size() == 1 ? "is" : "are"});
}

}  // namespace

std::optional<prism_emit::Preferences> read_preferences(Project& project, const ProbabilitySettings& settings) {
    prism_emit::Preferences result = prism_emit::preferences_of(project.instantiation);
    const auto has_range = [&](const char* type) { return project.asked.ranges.contains(type); };
    result.nat.asked = has_range("nat");
    result.integer.asked = has_range("int");
    result.real.asked = has_range("real");
    if (settings.preferences.empty()) return result;
    std::string error;
    const auto source = project.sources.load_file(settings.preferences, error);
    std::size_t line = 1;
    if (source) error = prism_emit::read_preferences(project.sources.source_text(*source), result, &line);
    if (error.empty()) {
        warn_of_ignored(project, settings, result.ignored);
        return result;
    }
    diagnostics::Span place;  // unknown for a file that cannot be read
    if (source) {
        const std::string_view text = project.sources.source_text(*source);
        const std::string_view wrong = project.sources.line_text(*source, static_cast<std::uint32_t>(line));
        const auto begin = static_cast<std::uint32_t>(wrong.data() - text.data());
        place = {*source, begin, begin + static_cast<std::uint32_t>(wrong.size())};
    }
    project.diagnostics.report(prism_emit::rules::bad_preferences, place, {settings.preferences, error});
    return std::nullopt;
}

}  // namespace robochart::driver
