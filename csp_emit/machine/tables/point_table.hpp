// SPDX-License-Identifier: Apache-2.0
// Stores the points of a machine, which are its reachable configurations. Each point becomes one function.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "csp_emit/machine/tables/activation_records.hpp"

namespace robochart::csp_emit {

struct Point {
    Activation config;
    std::string name;      ///< name of the function
    bool returns = false;  ///< this point is the end of an operation that several calls share
};

/// Owns the points, numbered in the order in which they are reached. The number of points, and the number of arguments
/// of all calls between points, are limited. If a limit is exceeded, this is reported once, and the bodies of further
/// points are not made.
class PointTable {
public:
    PointTable(MachineContext& context, const ActivationRecords& frames) : context_(context), frames_(frames) {}

    /// Returns the point of a configuration, or null if there would be too many points. Valid until the next point is
    /// added.
    [[nodiscard]] const Point* point_of(const Activation& config);
    /// Returns the point at which the operation of a frame has ended and returns to its caller.
    [[nodiscard]] const Point& end_of(std::uint32_t frame);
    /// Counts a call of a point with this number of arguments.
    void count_call(std::size_t arguments);
    [[nodiscard]] bool has_overflowed() const { return overflow_; }

    [[nodiscard]] const std::vector<Point>& all() const { return points_; }
    /// Removes the points whose functions are not called.
    void erase_points(const std::function<bool(const std::string& name)>& unwanted);

private:
    std::string name_of(const Activation& config);
    void too_large(const std::string& what);

    MachineContext& context_;
    const ActivationRecords& frames_;
    std::map<std::string, std::size_t> number_;  ///< the point's number, by the key of the configuration
    std::vector<Point> points_;
    std::size_t passed_ = 0;  ///< number of arguments of all calls
    bool overflow_ = false;
};

}  // namespace robochart::csp_emit
