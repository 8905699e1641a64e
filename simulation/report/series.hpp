// SPDX-License-Identifier: Apache-2.0
// Computes the measures of a swarm over time, for every trial and over all trials, for plots.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "simulation/trial/trial.hpp"

namespace robochart::simulation {

/// The quartiles of several trials' values at one time, interpolated between the sorted values (definition 7 of Hyndman
/// and Fan, Sample quantiles in statistical packages, 1996).
struct Quartiles {
    double least = 0;
    double lower = 0;   ///< quartile
    double middle = 0;  ///< median
    double upper = 0;   ///< quartile
    double most = 0;
};
/// Returns the quartiles of at least one value.
[[nodiscard]] Quartiles quartiles_of(std::vector<double> values);

/// One quantity over time.
struct Series {
    std::string name;                         ///< the name in a legend; "" if the chart has one series
    std::vector<std::vector<double>> trials;  ///< for each trial, its values until it ended
    std::vector<Quartiles> all;               ///< over the trials that had not ended at the time
};

/// The values that a scenario accepts for a quantity at a time, or the times at which the quantity may reach a level.
struct Target {
    bool mean = false;  ///< true: for the mean of the trials; false: for each trial
    double from = 0;    ///< s
    double to = 0;
    double low = 0;  ///< a value in the chart's unit
    double high = 0;
};

/// A chart of quantities with the same unit.
struct Chart {
    std::string title;
    std::string unit;                 ///< "" for a number
    std::string definition;           ///< a sentence, with its source
    bool whole = false;               ///< the values are counts
    std::optional<double> most = {};  ///< the largest possible value
    std::vector<Series> series = {};
    std::vector<Target> targets = {};
};

/// All charts of a run, over the same times.
struct Charts {
    std::vector<double> times;  ///< s
    std::size_t every = 1;      ///< of this many recorded times, one is shown; the last is always shown
    bool distances = true;      ///< false: too many pairs of robots for mean distances
    std::vector<Chart> charts;
};

/// Returns the charts of the recorded trials: the mean distance between robots, the largest cluster, the number of
/// clusters, the scenario's other measures, and the number of robots in each state of the first machine. The charts
/// have at most `most_times` times.
[[nodiscard]] Charts charts_of(const Scenario&, const std::vector<TrialResult>&, const Machines&,
                               std::size_t most_times = 240);

/// Returns the smallest `every` for which kept_indices returns at most `most` times (but at least two).
[[nodiscard]] std::size_t thinning_factor(std::size_t count, std::size_t most);
/// Returns the indices of the recorded times that are used: one of every `every` times, and the last one.
[[nodiscard]] std::vector<std::size_t> kept_indices(std::size_t count, std::size_t every);

/// Returns the length of a link in the scenario's first measure of clusters. If the scenario has no such measure, the
/// length is two diameters, so that no robot fits between two linked robots.
[[nodiscard]] double link_of(const Scenario&);

}  // namespace robochart::simulation
