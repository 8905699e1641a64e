// SPDX-License-Identifier: Apache-2.0
#include "simulation/scenario/sensor_readings.hpp"

#include <algorithm>
#include <array>

namespace robochart::simulation {

std::span<const ReadingRow> reading_table() {
    using Kind = SensorKind;
    static constexpr std::array<ReadingRow, 13> table{{
        {"robot", Kind::line_of_sight, Reading::robot, Carries::signal, std::nullopt},
        {"clear", Kind::line_of_sight, Reading::clear, Carries::signal, std::nullopt},
        {"wall", Kind::line_of_sight, Reading::wall, Carries::signal, std::nullopt},
        {"distance", Kind::line_of_sight, Reading::distance, Carries::real, std::nullopt, Dimension::length},
        {"near", Kind::range_and_bearing, Reading::near, Carries::signal, Dimension::length},
        {"away", Kind::range_and_bearing, Reading::away, Carries::real, Dimension::length, Dimension::angle},
        {"towards", Kind::range_and_bearing, Reading::towards, Carries::real, Dimension::length, Dimension::angle},
        {"count", Kind::range_and_bearing, Reading::count, Carries::whole, Dimension::length},
        {"message", Kind::range_and_bearing, Reading::message, Carries::whole, Dimension::length},
        {"on", Kind::ground, Reading::on, Carries::signal, Dimension::length},
        {"lit", Kind::light, Reading::lit, Carries::boolean, Dimension::number},
        {"near", Kind::proximity, Reading::near, Carries::signal, Dimension::length},
        {"turned", std::nullopt, Reading::turned, Carries::signal, std::nullopt},
    }};
    return table;
}

std::span<const SensorName> sensor_names() {
    static constexpr std::array<SensorName, 5> table{{{"line_of_sight", SensorKind::line_of_sight},
                                                      {"range_and_bearing", SensorKind::range_and_bearing},
                                                      {"light_ring", SensorKind::light},
                                                      {"proximity", SensorKind::proximity},
                                                      {"ground", SensorKind::ground}}};
    return table;
}

std::optional<SensorKind> sensor_kind(std::string_view name) {
    for (const SensorName& sensor : sensor_names())
        if (sensor.name == name) return sensor.kind;
    return std::nullopt;
}

namespace {

const ReadingRow* find(std::optional<SensorKind> kind, std::string_view name) {
    const auto rows = reading_table();
    const auto row =
        std::ranges::find_if(rows, [&](const ReadingRow& r) { return r.sensor == kind && r.name == name; });
    return row == rows.end() ? nullptr : &*row;
}

}  // namespace

const ReadingRow* reading_of(SensorKind kind, std::string_view name) {
    return find(kind, name);
}

const ReadingRow* reading_of_actuator(std::string_view name) {
    return find(std::nullopt, name);
}

}  // namespace robochart::simulation
