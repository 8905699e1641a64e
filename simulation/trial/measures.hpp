// SPDX-License-Identifier: Apache-2.0
// Computes measures of a swarm and their statistics over a trial. The second moment is that of Graham and Sloane, as
// used by Gauci et al., IJRR 33(8), 2014.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "simulation/scenario/scenario.hpp"
#include "simulation/trial/controller.hpp"
#include "simulation/trial/formulas.hpp"

namespace robochart::simulation {

/// The state of the world at one time.
struct Frame {
    double time = 0;
    std::vector<Pose> poses;
    std::vector<std::uint16_t>
        states;                 ///< by robot and machine: index of the state; the number of states between states
    std::vector<bool> working;  ///< by robot: no part of it has failed; empty: no part of any robot has failed
    std::vector<LightNow> lights = {};  ///< empty: as the scenario defines them at that time
    std::vector<double> kept = {};      ///< by measure, for measures `kept`; empty: no claims are followed
    std::vector<bool> obstacles = {};   ///< by index in Scenario::obstacles: present or not; empty: as at the start

    /// Returns the state of a robot's machine.
    [[nodiscard]] std::uint16_t robot_state(std::size_t robot, std::size_t machine = 0) const {
        return states[robot * (states.size() / poses.size()) + machine];
    }
};

/// The groups of robots in a swarm. Two robots are in one group if they are linked, directly or through others; two
/// robots with at most `link` between their centres are linked. A robot without links is a group by itself.
struct Clusters {
    std::size_t count = 0;
    std::size_t largest = 0;  ///< number of robots in the largest group
};
[[nodiscard]] Clusters count_clusters(const std::vector<Pose>&, double link);
/// Returns the fraction of robots in the largest group.
[[nodiscard]] double largest_cluster(const std::vector<Pose>&, double link);
/// Returns the mean distance between the centres of all pairs of robots, in cm; 0 if there is no pair.
[[nodiscard]] double mean_distance(const std::vector<Pose>&);
/// Returns the mean distance to the centroid, in cm.
[[nodiscard]] double mean_spread(const std::vector<Pose>&);
/// Returns the sum of squared distances to the centroid, in units of the squared diameter.
[[nodiscard]] double second_moment(const std::vector<Pose>&, double radius);
[[nodiscard]] Vector centroid(const std::vector<Pose>&);
/// Returns the fraction of robots whose centre is at most `distance` from a point.
[[nodiscard]] double share_within(const std::vector<Pose>&, Vector, double distance);
/// Returns the fraction of robots whose centre is in a rectangle.
[[nodiscard]] double share_inside(const std::vector<Pose>&, const Region&);
/// Returns the state of a light in a frame.
[[nodiscard]] LightNow light_at(const Scenario&, const Frame&, std::size_t light);
/// Returns the frame reduced to the robots of one kind.
[[nodiscard]] Frame of_kind(const Scenario&, std::size_t kind, const Frame&);
/// Returns the fraction of robots that are in the states of the measure.
[[nodiscard]] double share_in(const Measure&, const Frame&);
[[nodiscard]] double measure_value(const Scenario&, const Measure&, const Frame&);
/// Finds the states of measures by name; reports unknown names.
void find_states(Scenario&, const Machines&, diagnostics::Diagnostics&);
/// Returns the measures at one instant. A measure is computed at most once. The result stores references to the
/// arguments.
[[nodiscard]] MeasureNow measures_now(const Scenario&, const Frame&);

/// The statistics of a scenario's bands, collected step by step.
class Statistics {
public:
    explicit Statistics(const Scenario&);

    /// True if some band needs the positions after this number of steps.
    [[nodiscard]] bool is_due(std::uint64_t step) const;
    void take_samples(std::uint64_t step, const MeasureNow&);
    /// Returns one value per band; NaN if a time was never reached. Averages are over all full seconds.
    [[nodiscard]] std::vector<double> band_values() const;

private:
    struct Entry {
        double value = 0;
        std::uint64_t looks = 0;
        bool done = false;
        std::optional<Condition> condition;  ///< the condition of first_time
    };
    [[nodiscard]] bool is_due(std::size_t band, std::uint64_t step) const;

    const Scenario& scenario_;
    std::vector<Entry> entries_;
};

}  // namespace robochart::simulation
