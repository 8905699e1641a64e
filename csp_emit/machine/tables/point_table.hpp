// The points of a machine: the reachable configurations, each of which becomes one function.
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
    std::string name;      ///< of the function
    bool returns = false;  ///< an operation that calls share has come to its end
};

/// Owns the points, numbered in the order in which they are reached. There is a limit on them and on what is passed
/// between them; what exceeds it is reported once, and the rest of the script is kept short.
class PointTable {
public:
    PointTable(MachineContext& context, const ActivationRecords& frames) : context_(context), frames_(frames) {}

    /// The point of a configuration; null if there would be too many. Valid until the next one is added.
    [[nodiscard]] const Point* at(const Activation& config);
    /// The point where the operation of a frame has come to its end and returns to where it was called.
    [[nodiscard]] const Point& end_of(std::uint32_t frame);
    /// Counts a call of a point with so many arguments.
    void count_call(std::size_t arguments);
    [[nodiscard]] bool overflow() const { return overflow_; }

    [[nodiscard]] const std::vector<Point>& all() const { return points_; }
    /// Takes the points away whose functions nobody calls.
    void erase(const std::function<bool(const std::string& name)>& unwanted);

private:
    std::string name_of(const Activation& config);
    void too_large(const std::string& what);

    MachineContext& context_;
    const ActivationRecords& frames_;
    std::map<std::string, std::size_t> number_;  ///< by key of the configuration
    std::vector<Point> points_;
    std::size_t passed_ = 0;  ///< arguments of all calls
    bool overflow_ = false;
};

}  // namespace robochart::csp_emit
