// SPDX-License-Identifier: Apache-2.0
// Computes the points of a sweep (the values that a scenario varies), and represents the results of claims at each
// point. All points use the same seeds (common random numbers), and all points share the error of a claim (Bonferroni),
// so that the results hold jointly.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/statistics/survival.hpp"
#include "simulation/report/claims.hpp"
#include "simulation/scenario/scenario.hpp"

namespace robochart::simulation {

/// A point of a sweep: one value for each variation.
using Point = std::vector<double>;

/// Returns all points; the first variation changes fastest.
[[nodiscard]] std::vector<Point> points_of(const Scenario&);
/// Returns the scenario at a point: with this number of robots or noise, and only with claims.
[[nodiscard]] Scenario scenario_at(const Scenario&, const Point&);
/// Returns `NAME=VALUE` for each constant that varies.
[[nodiscard]] std::vector<std::string> constants_at(const Scenario&, const Point&);

/// Returns a name such as "robots", "noise" or "farRadius".
[[nodiscard]] std::string name_of(const Variation&);
/// Returns a text such as "4", "5 %" or "0.2".
[[nodiscard]] std::string value_text(const Variation&, double value);
/// Returns a text such as "robots 4, noise 5 %".
[[nodiscard]] std::string point_text(const Scenario&, const Point&);

/// The results of the claims at a point.
struct PointResult {
    Point point;
    std::vector<ClaimResult> claims;  ///< empty if not computed
};

/// The least value of the first variation at which a claim holds, for one value of the second variation.
struct Least {
    std::optional<double> value;  ///< value of the first variation at which the claim is proved
    bool certain = false;         ///< the claim is refuted at every smaller value
    bool ended = false;           ///< further points are unnecessary or cannot help
};
/// `second` is the value of the second variation, if there is one.
[[nodiscard]] Least least_value(const std::vector<PointResult>&, std::size_t claim, std::optional<double> second);

/// Returns the interval of a single point, with the whole error of the claim. Returns no value for tests, and while
/// trials are still missing for the next evaluation.
[[nodiscard]] std::optional<statistics::Interval> pointwise_interval(const Claim&, const ClaimResult&);

/// Returns the time to success in each trial. If a trial stopped or had no success, its time is a lower bound.
[[nodiscard]] std::vector<statistics::Duration> durations_of(const ClaimResult&);

/// Convert the claims of a point to text, exactly, and back. The second function returns no value if the first one did
/// not write the text.
[[nodiscard]] std::string claims_to_text(const std::vector<ClaimResult>&);
[[nodiscard]] std::optional<std::vector<ClaimResult>> claims_from_text(std::string_view text, std::size_t claims);

}  // namespace robochart::simulation
