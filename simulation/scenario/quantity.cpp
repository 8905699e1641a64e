// SPDX-License-Identifier: Apache-2.0
#include "simulation/scenario/quantity.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace robochart::simulation {

namespace {

struct Row {
    std::string_view name;
    Unit unit;
};

constexpr double degree = std::numbers::pi / 180;

constexpr std::array<Row, 15> units{{
    {"mm", {Dimension::length, 0.1}},
    {"cm", {Dimension::length, 1}},
    {"m", {Dimension::length, 100}},
    {"cm2", {Dimension::area, 1}},
    {"m2", {Dimension::area, 10'000}},
    {"ms", {Dimension::time, 0.001}},
    {"s", {Dimension::time, 1}},
    {"deg", {Dimension::angle, degree}},
    {"rad", {Dimension::angle, 1}},
    {"mm/s", {Dimension::speed, 0.1}},
    {"cm/s", {Dimension::speed, 1}},
    {"m/s", {Dimension::speed, 100}},
    {"deg/s", {Dimension::turn_rate, degree}},
    {"rad/s", {Dimension::turn_rate, 1}},
    {"%", {Dimension::share, 0.01}},
}};

}  // namespace

std::string_view describe_dimension(Dimension dimension) {
    switch (dimension) {
        case Dimension::number:
            return "a number without unit";
        case Dimension::share:
            return "a share (%)";
        case Dimension::length:
            return "a length (mm, cm, m)";
        case Dimension::area:
            return "an area (cm2, m2)";
        case Dimension::time:
            return "a time (ms, s)";
        case Dimension::angle:
            return "an angle (deg, rad)";
        case Dimension::speed:
            return "a speed (mm/s, cm/s, m/s)";
        case Dimension::turn_rate:
            return "a rate of turning (deg/s, rad/s)";
    }
    return "";
}

std::string_view printed_unit(Dimension dimension) {
    switch (dimension) {
        case Dimension::time:
            return " s";
        case Dimension::share:
            return " %";
        case Dimension::length:
            return " cm";
        case Dimension::number:
        case Dimension::area:
        case Dimension::angle:
        case Dimension::speed:
        case Dimension::turn_rate:
            break;
    }
    return "";
}

std::optional<Unit> unit_named(std::string_view name) {
    const auto* row = std::ranges::find_if(units, [&](const Row& r) { return r.name == name; });
    if (row == units.end()) return std::nullopt;
    return row->unit;
}

}  // namespace robochart::simulation
