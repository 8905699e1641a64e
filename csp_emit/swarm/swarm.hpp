// A swarm as data: copies of one component's semantics on a grid, or where anybody may be near anybody, and what is
// claimed of them together. docs/emergence.md has the notation; its words are those of scenarios where they mean the
// same (docs/scenarios.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "frontend/syntax/word_reader.hpp"

namespace robochart::csp_emit {

/// A torus of cells: who leaves it on one side comes in on the other.
struct SwarmGrid {
    std::uint32_t width = 0;  ///< at least 2, as the height
    std::uint32_t height = 0;
};

/// `place at (X, Y) heading 90 deg`, or `heading any`. Without an own place robots begin where the last one does.
struct SwarmPlace {
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::optional<std::int64_t> degrees;  ///< none: any heading
};

/// What a robot senses.
enum class SwarmReading {
    count,   ///< how many others are near
    near,    ///< whether some other is
    turned,  ///< no turn is under way
    any,     ///< any value at any time, or nothing: the environment decides
};

/// `feed EVENT with count(1) on OPERATION`.
struct SwarmFeed {
    frontend::Word event;
    SwarmReading reading = SwarmReading::any;
    std::uint32_t distance = 1;        ///< count, near: in cells, diagonal steps are one
    std::optional<frontend::Word> on;  ///< once after each call of this operation
};

enum class SwarmMotion { forward, turn, stop };

/// `drive by forward on OPERATION`.
struct SwarmDrive {
    frontend::Word operation;
    SwarmMotion motion = SwarmMotion::stop;
};

/// `connect EVENT to EVENT within 1`: what a robot sends reaches others.
struct SwarmConnection {
    frontend::Word from;
    frontend::Word to;
    std::uint32_t distance = 0;  ///< 0: those anywhere
};

/// `const NAME = VALUE` or `const NAME = robot`, the number of the robot from 0 on.
struct SwarmConstant {
    frontend::Word name;
    std::string value;  ///< "" for the number of the robot
};

/// `range nat = 0 to 4`.
struct SwarmRange {
    frontend::Word type;
    std::int64_t low = 0;
    std::int64_t high = 0;
};

/// What holds or not of where the robots are at the end of a time unit.
struct SwarmCondition {
    enum class Kind {
        linked,  ///< all are joined, directly or by others, by links of at most `distance` cells
        apart,   ///< no two are in one cell
        away,    ///< robot 0 is at least `distance` cells from where it began, by the shorter way round
        negation,
        both,    ///< all parts hold
        either,  ///< some part holds
    };
    Kind kind = Kind::linked;
    std::uint32_t distance = 1;
    std::vector<SwarmCondition> parts;  ///< negation: one; both, either: two or more; the others: none
};

enum class SwarmQuestion {
    deadlock_free,  ///< from wherever the swarm may be, some robot can come to do something but let time pass
    always,         ///< the condition holds whenever a time unit has passed
    possible,       ///< some run leads to where it holds
    recurrent,      ///< from wherever the swarm may be, some run leads to where it holds
};

/// `accept recurrent linked(1)`.
struct SwarmClaim {
    SwarmQuestion question = SwarmQuestion::always;
    SwarmCondition condition;
    std::string text;  ///< as written, behind `accept`
    diagnostics::Span span;
};

struct Swarm {
    frontend::Word name;
    frontend::Word component;
    std::uint32_t robots = 2;
    std::optional<SwarmGrid> grid;  ///< none: anybody may be near anybody at any time
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
