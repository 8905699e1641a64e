// SPDX-License-Identifier: Apache-2.0
// Represents a swarm: copies of one component, on a grid or in a world where any robots may be near each other, and the
// claims about them. docs/emergence.md describes the notation. It uses the words of scenarios (docs/scenarios.md) with
// the same meaning.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "frontend/syntax/word_reader.hpp"

namespace robochart::csp_emit {

/// A torus of cells: a robot that leaves it on one side enters it on the opposite side.
struct SwarmGrid {
    std::uint32_t width = 0;  ///< width and height are at least 2
    std::uint32_t height = 0;
};

/// A line `place at (X, Y) heading 90 deg`, or `heading any`. Robots without a place begin at the last place.
struct SwarmPlace {
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::optional<std::int64_t> degrees;  ///< no value: any heading
};

/// The quantity that a robot senses.
enum class SwarmReading {
    count,   ///< the number of other robots in range
    near,    ///< whether another robot is in range
    turned,  ///< no turn is in progress
    any,     ///< any value at any time, or nothing: the environment decides
};

/// A line `feed EVENT with count(1) on OPERATION`.
struct SwarmFeed {
    frontend::Word event;
    SwarmReading reading = SwarmReading::any;
    std::uint32_t distance = 1;        ///< for count and near: in cells; a diagonal step counts as one
    std::optional<frontend::Word> on;  ///< the event occurs once after each call of this operation
};

enum class SwarmMotion { forward, turn, stop };

/// A line `drive by forward on OPERATION`.
struct SwarmDrive {
    frontend::Word operation;
    SwarmMotion motion = SwarmMotion::stop;
};

/// A line `connect EVENT to EVENT within 1`: messages of a robot reach other robots within this distance.
struct SwarmConnection {
    frontend::Word from;
    frontend::Word to;
    std::uint32_t distance = 0;  ///< 0: any distance
};

/// A line `const NAME = VALUE` or `const NAME = robot`, the number of the robot, counted from 0.
struct SwarmConstant {
    frontend::Word name;
    std::string value;  ///< "" for the number of the robot
};

/// A line `range nat = 0 to 4`.
struct SwarmRange {
    frontend::Word type;
    std::int64_t low = 0;
    std::int64_t high = 0;
};

/// A condition on the positions of the robots at the end of a time unit.
struct SwarmCondition {
    enum class Kind {
        linked,  ///< all robots are connected by links of at most `distance` cells, directly or through others
        apart,   ///< no two robots are in the same cell
        away,    ///< robot 0 is at least `distance` cells from its start, by the shortest path on the torus
        negation,
        both,    ///< all parts hold
        either,  ///< some part holds
    };
    Kind kind = Kind::linked;
    std::uint32_t distance = 1;
    std::vector<SwarmCondition> parts;  ///< one for negation, two or more for both and either, none for the others
};

enum class SwarmQuestion {
    deadlock_free,  ///< from every reachable state, some robot can do something other than let time pass
    always,         ///< the condition holds after every time unit
    possible,       ///< some run reaches a state in which the condition holds
    recurrent,      ///< from every reachable state, some run reaches a state in which the condition holds
};

/// A line `accept recurrent linked(1)`.
struct SwarmClaim {
    SwarmQuestion question = SwarmQuestion::always;
    SwarmCondition condition;
    std::string text;  ///< the text after `accept`
    diagnostics::Span span;
};

struct Swarm {
    frontend::Word name;
    frontend::Word component;
    std::uint32_t robots = 2;
    std::optional<SwarmGrid> grid;  ///< no value: any robots may be near each other at any time
    std::uint32_t headings = 4;     ///< 4 or 8
    std::vector<SwarmPlace> places;
    std::vector<SwarmFeed> feeds;
    std::vector<SwarmDrive> drives;
    std::vector<SwarmConnection> connections;
    std::vector<SwarmConstant> constants;
    std::vector<SwarmRange> ranges;
    std::vector<SwarmClaim> claims;
};

}  // namespace robochart::csp_emit
