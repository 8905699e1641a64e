// Measures of a swarm and their statistics over a trial. The second moment is that of Graham and Sloane as used by
// Gauci et al., IJRR 33(8), 2014.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "simulation/scenario/scenario.hpp"
#include "simulation/trial/controller.hpp"
#include "simulation/trial/formulas.hpp"

namespace robochart::simulation {

/// Where the robots were at one time.
struct Frame {
    double time = 0;
    std::vector<Pose> poses;
    std::vector<std::uint16_t>
        states;                 ///< robot by robot, of each machine: index into its states; their number in between
    std::vector<bool> working;  ///< robot by robot: nothing has failed; empty: in none
    std::vector<LightNow> lights = {};  ///< empty: where the scenario itself has them at that time
    std::vector<bool> obstacles = {};   ///< of Scenario::obstacles: there or not; empty: as at the start

    /// Of a robot's machine.
    [[nodiscard]] std::uint16_t state(std::size_t robot, std::size_t machine = 0) const {
        return states[robot * (states.size() / poses.size()) + machine];
    }
};

/// Groups of robots linked, directly or by others, by at most `link` between centres; whoever has no link is a group.
struct Clusters {
    std::size_t count = 0;
    std::size_t largest = 0;  ///< robots in the largest
};
[[nodiscard]] Clusters clusters(const std::vector<Pose>&, double link);
/// The share of robots in the largest group.
[[nodiscard]] double largest_cluster(const std::vector<Pose>&, double link);
/// The mean over all pairs of robots of the distance between their centres, cm; 0 without a pair.
[[nodiscard]] double mean_distance(const std::vector<Pose>&);
/// The mean distance to the centroid, cm.
[[nodiscard]] double spread(const std::vector<Pose>&);
/// The sum of squared distances to the centroid in units of the diameter squared.
[[nodiscard]] double second_moment(const std::vector<Pose>&, double radius);
[[nodiscard]] Vector centroid(const std::vector<Pose>&);
/// The share of robots whose centre is at most `distance` from a point.
[[nodiscard]] double share_within(const std::vector<Pose>&, Vector, double distance);
/// The share of robots whose centre is in a rectangle.
[[nodiscard]] double share_inside(const std::vector<Pose>&, const Region&);
/// Where a light is.
[[nodiscard]] LightNow light_at(const Scenario&, const Frame&, std::size_t light);
/// The robots of one kind alone.
[[nodiscard]] Frame of_kind(const Scenario&, std::size_t kind, const Frame&);
/// The share of robots that are in the states of the measure.
[[nodiscard]] double share_in(const Measure&, const Frame&);
[[nodiscard]] double measured(const Scenario&, const Measure&, const Frame&);
/// The states that measures are about, by their names; reports those that are not there.
void find_states(Scenario&, const Machines&, diagnostics::Diagnostics&);
/// The measures of one instant, each calculated once. Keeps references.
[[nodiscard]] MeasureNow measures_now(const Scenario&, const Frame&);

/// The statistics that the bands of a scenario are about, gathered step by step.
class Statistics {
public:
    explicit Statistics(const Scenario&);

    /// Does any band need the positions after this many steps?
    [[nodiscard]] bool due(std::uint64_t step) const;
    void look(std::uint64_t step, const MeasureNow&);
    /// One for each band; NaN: a time that never came. Averages are over every full second.
    [[nodiscard]] std::vector<double> values() const;

private:
    struct Entry {
        double value = 0;
        std::uint64_t looks = 0;
        bool done = false;
        std::optional<Condition> condition;  ///< first_time
    };
    [[nodiscard]] bool due(std::size_t band, std::uint64_t step) const;

    const Scenario& scenario_;
    std::vector<Entry> entries_;
};

}  // namespace robochart::simulation
