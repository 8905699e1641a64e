// SPDX-License-Identifier: Apache-2.0
// Parses failures of robots and obstacles in scenarios.
#include <fmt/format.h>

#include <filesystem>

#include "base/diagnostics/escape.hpp"
#include "simulation/scenario/drawn_obstacles.hpp"
#include "simulation/scenario/rules.hpp"
#include "simulation/scenario/scenario_reader.hpp"

namespace robochart::simulation {

std::optional<FailureKind> ScenarioReader::failure_kind() {
    in_.expect_word("of");
    if (in_.take_word("motors")) return FailureKind::motors;
    if (in_.take_word("radio")) return FailureKind::radio;
    if (in_.take_word("sensors")) return FailureKind::sensors;
    if (in_.take_word("all")) return FailureKind::whole;
    in_.fail_expecting("'all', 'motors', 'radio' or 'sensors'");
    return std::nullopt;
}

void ScenarioReader::parse_failure() {
    Failure failure;
    const diagnostics::Span begin = in_.current_token().span;
    const auto kind = failure_kind();
    if (!kind) return;
    failure.kind = *kind;
    if (in_.take_word("with")) {
        in_.expect_word("mean");
        in_.expect_word("time");
        failure.mean_time = in_.read_positive(Dimension::time, "the mean time to a failure");
    } else {
        in_.expect_word("at");
        failure.at = in_.not_negative(Dimension::time, "the time of a failure");
        times_.push_back({failure.at, in_.last_span()});
        in_.expect_word("in");
        failure.robots = static_cast<std::uint32_t>(in_.read_count(1, most_robots_, "the number of robots that fail"));
        in_.expect_word("robots");
    }
    failure.span = diagnostics::join_spans(begin, in_.last_span());
    kind_->failures.push_back(failure);
}

void ScenarioReader::parse_obstacle() {
    constexpr std::size_t most_corners = 1000;
    const diagnostics::Span begin = in_.current_token().span;
    Obstacle named;
    if (!in_.at_word("(") && !in_.at_word("at")) named.name = new_name("a corner, or a name for the obstacle");
    std::vector<Vector> corners;
    do corners.push_back(in_.read_point("a corner"));
    while (in_.take_word(",") && corners.size() < most_corners);
    const diagnostics::Span span = diagnostics::join_spans(begin, in_.last_span());
    if (in_.has_failed()) return;
    if (corners.size() < 3) in_.report(rules::out_of_range, span, {"an obstacle has at least three corners"});
    if (named.name.text.empty()) return add_obstacle(std::move(corners), span);
    for (const Vector corner : corners) inside_.push_back({corner, "the obstacle", span});
    named.corners = std::move(corners);
    named.there = !in_.take_word("absent");
    scenario_.obstacles.push_back(std::move(named));
}

void ScenarioReader::parse_drawn_obstacles() {
    const diagnostics::Span begin = in_.current_token().span;
    const std::string name = in_.read_quoted("the path of a drawing in quotes");
    in_.expect_word("with");
    const double unit = in_.read_positive(Dimension::length, "the length of a unit of the drawing");
    in_.expect_word("per");
    in_.expect_word("unit");
    if (in_.has_failed()) return;
    const diagnostics::Span span = diagnostics::join_spans(begin, in_.last_span());
    const std::filesystem::path path = std::filesystem::path(path_).parent_path() / name;
    std::string error;
    diagnostics::SourceManager drawings;
    std::vector<std::vector<Vector>> found;
    if (const auto drawing = drawings.load_file(path.string(), error)) {
        scenario_.drawings.emplace_back(drawings.source_text(*drawing));
        scenario_.drawing_files.push_back(path.string());
        found = drawn_obstacles(scenario_.drawings.back(), error);
    }
    if (!error.empty())
        in_.report(rules::out_of_range, span,
                   {fmt::format("obstacles of {}: {}", diagnostics::escape_for_display(name),
                                diagnostics::escape_for_display(error))});
    else if (found.empty())
        in_.report(rules::out_of_range, span,
                   {fmt::format("there is no obstacle in {}", diagnostics::escape_for_display(name))});
    for (std::vector<Vector>& corners : found) {
        for (Vector& corner : corners) corner = unit * corner;
        add_obstacle(std::move(corners), span);
    }
}

void ScenarioReader::add_obstacle(std::vector<Vector> corners, diagnostics::Span span) {
    Arena& arena = scenario_.world.arena;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        arena.walls.push_back({corners[i], corners[(i + 1) % corners.size()]});
        inside_.push_back({corners[i], "the obstacle", span});
    }
    arena.obstacles.push_back(std::move(corners));
}

}  // namespace robochart::simulation
