// The table of what sensors and actuators report: private to this component.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "simulation/scenario/scenario.hpp"

namespace robochart::simulation {

struct ReadingRow {
    std::string_view name;
    std::optional<SensorKind> sensor;  ///< none: of an actuator
    Reading reading;
    Carries carries;
    std::optional<Dimension> argument;
    Dimension result = Dimension::number;  ///< of real readings
};

[[nodiscard]] std::span<const ReadingRow> readings();
/// A kind of sensor by its word in scenarios.
struct SensorName {
    std::string_view name;
    SensorKind kind;
};
[[nodiscard]] std::span<const SensorName> sensor_names();
[[nodiscard]] std::optional<SensorKind> sensor_kind(std::string_view name);
[[nodiscard]] const ReadingRow* reading_of(SensorKind, std::string_view name);
[[nodiscard]] const ReadingRow* reading_of_actuator(std::string_view name);

}  // namespace robochart::simulation
