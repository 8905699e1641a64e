// The measures of a swarm over time: of every trial, and over all trials, for plots.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "simulation/trial/trial.hpp"

namespace robochart::simulation {

/// The values of several trials at one time. Quartiles are interpolated between the sorted values (definition 7 of
/// Hyndman and Fan, Sample quantiles in statistical packages, 1996).
struct Quartiles {
    double least = 0;
    double lower = 0;   ///< quartile
    double middle = 0;  ///< median
    double upper = 0;   ///< quartile
    double most = 0;
};
/// Of at least one value.
[[nodiscard]] Quartiles quartiles_of(std::vector<double> values);

/// One quantity over time.
struct Series {
    std::string name;                         ///< in a legend; "" where the chart has one series
    std::vector<std::vector<double>> trials;  ///< of each trial, a value for each time until it ended
    std::vector<Quartiles> all;               ///< of the trials that had not ended
};

/// What a scenario accepts of a quantity of a chart at a time, or when it reaches a level.
struct Target {
    bool mean = false;  ///< of the mean of the trials, else of each
    double from = 0;    ///< s
    double to = 0;
    double low = 0;  ///< in the chart's unit
    double high = 0;
};

/// Quantities with one unit.
struct Chart {
    std::string title;
    std::string unit;                 ///< "" of a number
    std::string definition;           ///< a sentence, with its source
    bool whole = false;               ///< values are counts
    std::optional<double> most = {};  ///< the largest possible value
    std::vector<Series> series = {};
    std::vector<Target> targets = {};
};

/// All charts of a run, over the same times.
struct Charts {
    std::vector<double> times;  ///< s
    std::size_t every = 1;      ///< of the recorded times, one in so many (and the last)
    bool distances = true;      ///< false: too many pairs of robots for mean distances
    std::vector<Chart> charts;
};

/// The charts of the recorded trials: the mean distance between robots, the largest cluster, the number of clusters,
/// the scenario's other measures, and how many robots are in each state of the first machine. At most `most_times`
/// times.
[[nodiscard]] Charts charts_of(const Scenario&, const std::vector<TrialResult>&, const Machines&,
                               std::size_t most_times = 240);

/// The smallest `every` with which `thinned` keeps at most `most` (two or more).
[[nodiscard]] std::size_t thinning(std::size_t count, std::size_t most);
/// Of so many recorded times, the numbers of those that are kept: one in `every`, and the last.
[[nodiscard]] std::vector<std::size_t> thinned(std::size_t count, std::size_t every);

/// The length of a link of the scenario's first measure of clusters; without one two diameters, so that no robot fits
/// between two that are linked.
[[nodiscard]] double link_of(const Scenario&);

}  // namespace robochart::simulation
