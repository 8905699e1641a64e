// The values that a scenario varies, and what is known of its claims at each of them. Every point uses the same seeds
// (common random numbers), and the error of a claim is shared by all points (Bonferroni), so that what is said of them
// holds jointly.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulation/report/claims.hpp"
#include "simulation/scenario/scenario.hpp"
#include "statistics/survival.hpp"

namespace robochart::simulation {

/// A value of each variation.
using Point = std::vector<double>;

/// All of them; the first variation changes fastest.
[[nodiscard]] std::vector<Point> points_of(const Scenario&);
/// The scenario at a point: as many robots, that noise, claims alone.
[[nodiscard]] Scenario scenario_at(const Scenario&, const Point&);
/// `NAME=VALUE` for each constant that varies.
[[nodiscard]] std::vector<std::string> constants_at(const Scenario&, const Point&);

/// "robots", "noise", "farRadius".
[[nodiscard]] std::string name_of(const Variation&);
/// "4", "5 %", "0.2".
[[nodiscard]] std::string value_text(const Variation&, double value);
/// "robots 4, noise 5 %".
[[nodiscard]] std::string point_text(const Scenario&, const Point&);

/// What is known of the claims at a point.
struct PointResult {
    Point point;
    std::vector<ClaimResult> claims;  ///< none: not looked at
};

/// What the points say of the least value of the first variation at which a claim holds, at one value of the second.
struct Least {
    std::optional<double> value;  ///< of the first variation: the claim is shown to hold there
    bool certain = false;         ///< and to fail at every value below
    bool ended = false;           ///< no more points are needed to say so, or none can
};
/// `second`: the value of the second variation, if there is one.
[[nodiscard]] Least least(const std::vector<PointResult>&, std::size_t claim, std::optional<double> second);

/// The interval of a point by itself, with the whole error of the claim; none for tests, and in between looks.
[[nodiscard]] std::optional<statistics::Interval> pointwise(const Claim&, const ClaimResult&);

/// How long it took in each trial; a trial that stopped, or in which it did not come, had not come by its time.
[[nodiscard]] std::vector<statistics::Duration> durations_of(const ClaimResult&);

/// Claims of a point as text, exactly, and back; nothing from what was not written so.
[[nodiscard]] std::string stored(const std::vector<ClaimResult>&);
[[nodiscard]] std::optional<std::vector<ClaimResult>> restored(std::string_view text, std::size_t claims);

}  // namespace robochart::simulation
