// SPDX-License-Identifier: Apache-2.0
// Declares the table of readings that sensors and actuators provide (private to this component).
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "simulation/scenario/scenario.hpp"

namespace robochart::simulation {

struct ReadingRow {
    std::string_view name;
    std::optional<SensorKind> sensor;  ///< no value: the reading of an actuator
    Reading reading;
    Carries carries;
    std::optional<Dimension> argument;
    Dimension result = Dimension::number;  ///< the dimension of a real reading
};

[[nodiscard]] std::span<const ReadingRow> reading_table();
/// A kind of sensor and its keyword.
struct SensorName {
    std::string_view name;
    SensorKind kind;
};
[[nodiscard]] std::span<const SensorName> sensor_names();
[[nodiscard]] std::optional<SensorKind> sensor_kind(std::string_view name);
[[nodiscard]] const ReadingRow* reading_of(SensorKind, std::string_view name);
[[nodiscard]] const ReadingRow* reading_of_actuator(std::string_view name);

}  // namespace robochart::simulation
