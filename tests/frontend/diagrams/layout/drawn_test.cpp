// SPDX-License-Identifier: Apache-2.0
// Tests levels with a drawn layout: routes between boxes with other sizes, places for text, and elements that were not
// drawn.
#include "frontend/diagrams/layout/drawn.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/diagnostics/splitmix64.hpp"
#include "frontend/diagrams/layout/drawn_ports.hpp"
#include "frontend/diagrams/layout/drawn_routes.hpp"
#include "tests/frontend/diagrams/layout/random_levels.hpp"
#include "tests/rounds.hpp"

namespace robochart::diagrams::layout {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Two adjacent boxes: (0, 0) to (100, 40), and (200, 0) to (300, 40).
const RouteEnd left_box{{0, 0, 100, 40}};
const RouteEnd right_box{{200, 0, 100, 40}};

DrawnEdge drawn(std::vector<DrawnEdge::Bend> bends) {
    DrawnEdge edge;
    edge.bends = std::move(bends);
    return edge;
}

TEST(DrawnRoute, LeadsFromBorderToBorder) {
    // The line leads from the middle of one box to that of the other. The middles are 200 apart.
    EXPECT_THAT(route_as_drawn(drawn({{{0, 0}, {-200, 0}}, {{200, 0}, {0, 0}}}), left_box, right_box),
                ElementsAre(Point{100, 20}, Point{200, 20}));
}

TEST(DrawnRoute, KeepsItsBends) {
    // The route leaves the source at its right side, goes down by 60, and then goes up into the target.
    const auto edge = drawn({{{50, 10}, {-150, 10}},
                             {{80, 10}, {-120, 10}},
                             {{80, 70}, {-120, 70}},
                             {{200, 70}, {0, 70}},
                             {{200, 20}, {0, 20}}});
    EXPECT_THAT(route_as_drawn(edge, left_box, right_box),
                ElementsAre(Point{100, 30}, Point{130, 30}, Point{130, 90}, Point{250, 90}, Point{250, 40}));
}

/// If boxes have moved, the bends near the source move with the source, and those near the target with the target.
TEST(DrawnRoute, FitsBoxesThatHaveMoved) {
    const RouteEnd moved{{200, 12, 100, 40}};
    // The line was drawn straight. Its ends are now 12 pixels apart, and both boxes cover y 20 to 32.
    const auto line = route_as_drawn(drawn({{{50, 0}, {-150, 0}}, {{150, 0}, {-50, 0}}}), left_box, moved);
    EXPECT_THAT(line, ElementsAre(Point{100, 26}, Point{200, 26}));
    const RouteEnd far{{200, 300, 100, 40}};
    EXPECT_THAT(route_as_drawn(drawn({{{50, 0}, {-150, 0}}, {{150, 0}, {-50, 0}}}), left_box, far), IsEmpty())
        << "no straight line joins them any more";
}

TEST(DrawnRoute, EndsOnCircles) {
    const RouteEnd circle{{200, 8, 24, 24}, RouteEnd::Shape::circle};
    // The circle has radius 12. Six pixels above its centre, it starts 10.39 pixels to the left of the centre.
    const auto line = route_as_drawn(drawn({{{50, -6}, {-112, -6}}, {{162, -6}, {0, -6}}}), left_box, circle);
    ASSERT_EQ(line.size(), 2U);
    EXPECT_EQ(line[1].y, 14);
    EXPECT_NEAR(line[1].x, 212 - std::sqrt(144.0 - 36.0), 0.001);
}

TEST(DrawnRoute, OfALoopGoesOutAndBack) {
    const auto loop =
        drawn({{{50, -10}, {50, -10}}, {{90, -10}, {90, -10}}, {{90, 10}, {90, 10}}, {{50, 10}, {50, 10}}});
    EXPECT_THAT(route_as_drawn(loop, left_box, left_box),
                ElementsAre(Point{100, 10}, Point{140, 10}, Point{140, 30}, Point{100, 30}));
}

TEST(DrawnRoute, MayBeOblique) {
    DrawnEdge edge = drawn({{{0, 0}, {-200, -100}}, {{200, 100}, {0, 0}}});
    const RouteEnd below{{200, 100, 100, 40}};
    EXPECT_THAT(route_as_drawn(edge, left_box, below), IsEmpty()) << "with right angles, askew is no route";
    edge.right_angled = false;
    // The line leads from (50, 20) to (250, 120). It leaves the first box at its bottom, y = 40, and enters the second
    // at its top, y = 100.
    EXPECT_THAT(route_as_drawn(edge, left_box, below), ElementsAre(Point{90, 40}, Point{210, 100}));
}

TEST(DrawnRoute, ThatWasNotStoredIsNone) {
    EXPECT_THAT(route_as_drawn(drawn({}), left_box, right_box), IsEmpty());
    EXPECT_THAT(route_as_drawn(drawn({{{1, 1}, {1, 1}}}), left_box, right_box), IsEmpty());
    EXPECT_THAT(route_as_drawn(drawn({{{3, 3}, {0, 0}}, {{3, 3}, {0, 0}}}), left_box, right_box), IsEmpty());
}

TEST(NewRoute, AvoidsBoxes) {
    FreeSpace space;
    space.add(Rectangle{130, 0, 40, 40});
    const std::vector<Point> route = new_route(left_box, right_box, space);
    EXPECT_FALSE(space.is_crossed(route));
    EXPECT_GT(route.size(), 2U);
    EXPECT_THAT(new_route(left_box, right_box, FreeSpace()), ElementsAre(Point{100, 20}, Point{200, 20}));
}

TEST(FreeSpace, TakesTheFirstPlaceWithNothingOnIt) {
    FreeSpace space;
    space.add(Rectangle{0, 0, 10, 10});
    const Point line[] = {{20, 0}, {20, 100}};
    space.add(line);
    const Rectangle places[] = {{5, 5, 10, 10}, {15, 5, 10, 10}, {30, 5, 10, 10}, {50, 5, 10, 10}};
    EXPECT_EQ(space.choose_place(places), places[2]);
    EXPECT_EQ(space.occupied_area(places[0]), 25);
    EXPECT_EQ(space.choose_place(std::span(places).first(2)), places[0]) << "least of all: 25 of a box, 40 of a line";
}

/// If a box now blocks a route, the route changes. Other boxes and routes stay.
TEST(DrawnLevel, LeadsRoutesAroundBoxes) {
    Level level;
    for (int b = 0; b < 3; ++b) level.boxes.emplace_back().size = {100, 40};
    level.edges = {{0, 1, {}, {}, {}, {}}, {0, 2, {}, {}, {}, {}}};
    DrawnLevel drawn_level;
    for (const double x : {0.0, 200.0, 400.0}) drawn_level.boxes.emplace_back(DrawnBox{{x, 50}, {}, {}});
    drawn_level.ports.resize(3);
    drawn_level.edges = {drawn({{{50, 0}, {-150, 0}}, {{150, 0}, {-50, 0}}}),
                         drawn({{{50, 0}, {-350, 0}}, {{350, 0}, {-50, 0}}})};
    const Placement placement = arrange_as_drawn(level, drawn_level);
    EXPECT_THAT(placement.edges[0].points, ElementsAre(Point{100, 70}, Point{200, 70}));
    FreeSpace middle;
    middle.add(placement.boxes[1].place);
    EXPECT_FALSE(middle.is_crossed(placement.edges[1].points));
    EXPECT_EQ(placement.boxes[2].place, (Rectangle{400, 50, 100, 40}));
}

/// Returns a random drawing: any number of drawn and new boxes, ports and edges, with random stored data.
DrawnLevel any_drawing(const Level& level, std::uint64_t state) {
    const auto random = [&] { return diagnostics::splitmix64(state); };
    const auto number = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() % 1000) / 1000;
    };
    DrawnLevel drawn;
    for (const Box& box : level.boxes) {
        std::optional<DrawnBox> place;
        if (random() % 4 != 0) {
            place = DrawnBox{{number(-100, 900), number(-100, 900)}, {}, {}};
            if (random() % 2 == 0) place->width = number(0, 300);
            if (random() % 2 == 0) place->height = number(0, 300);
        }
        drawn.boxes.push_back(place);
        DrawnPorts ports;
        for (std::size_t p = 0; p < box.ports.size(); ++p) {
            ports.ports.emplace_back();
            if (random() % 3 != 0) ports.ports.back() = DrawnPort{{number(-30, 330), number(-30, 330)}, Side::top};
            ports.labels.push_back({number(0, 80), 14});
        }
        drawn.ports.push_back(std::move(ports));
    }
    for (std::size_t e = 0; e < level.edges.size(); ++e) {
        drawn.edges.emplace_back();
        if (random() % 3 == 0) continue;
        DrawnEdge edge;
        edge.right_angled = random() % 4 != 0;
        for (std::size_t i = random() % 5; i > 0; --i)
            edge.bends.push_back({{number(-300, 300), number(-300, 300)}, {number(-300, 300), number(-300, 300)}});
        drawn.edges.back() = std::move(edge);
    }
    return drawn;
}

void expect_whole(const Level& level, const Placement& placement, std::uint64_t seed) {
    ASSERT_EQ(placement.boxes.size(), level.boxes.size());
    ASSERT_EQ(placement.edges.size(), level.edges.size());
    for (std::size_t b = 0; b < level.boxes.size(); ++b) {
        ASSERT_EQ(placement.boxes[b].ports.size(), level.boxes[b].ports.size()) << seed;
        if (level.boxes[b].on_border) continue;
        const Rectangle& place = placement.boxes[b].place;
        EXPECT_GE(place.width, level.boxes[b].size.width - 0.001) << seed;
        EXPECT_GE(place.x, 0) << seed;
        EXPECT_GE(place.y, 0) << seed;
        EXPECT_LE(place.right(), placement.size.width) << seed;
        EXPECT_LE(place.bottom(), placement.size.height) << seed;
    }
    for (std::size_t e = 0; e < level.edges.size(); ++e) {
        EXPECT_GE(placement.edges[e].points.size(), 2U) << seed;
        EXPECT_EQ(placement.edges[e].label.empty(), level.edges[e].label.empty()) << seed;
        for (const Point& point : placement.edges[e].points)
            EXPECT_TRUE(std::isfinite(point.x) && std::isfinite(point.y)) << seed;
    }
}

void expect_apart(const Level& level, const Placement& placement, std::uint64_t seed) {
    constexpr double gap = 5;
    for (std::size_t a = 0; a < level.boxes.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) {
            if (level.boxes[a].on_border || level.boxes[b].on_border) continue;
            EXPECT_FALSE(rectangles_overlap(placement.boxes[a].place, placement.boxes[b].place, -gap))
                << a << " and " << b << " of " << seed;
        }
}

TEST(DrawnLevel, OfAnyFormIsPlaced) {
    for (std::uint64_t seed = 1; seed <= tests::rounds(300); ++seed)
        for (const Level& level : {random_machine(seed, 9), random_components(seed, 7)}) {
            const Placement placement = arrange_as_drawn(level, any_drawing(level, seed));
            expect_whole(level, placement, seed);
            expect_apart(level, placement, seed);
        }
}

/// Of two boxes that touch, the second moves in the direction in which the distance is shorter.
TEST(DrawnLevel, SeparatesBoxesThatTouch) {
    Level level;
    for (int b = 0; b < 3; ++b) level.boxes.emplace_back().size = {100, 40};
    DrawnLevel drawn_level;
    for (const Point corner : {Point{10, 10}, Point{110, 10}, Point{10, 50}})
        drawn_level.boxes.emplace_back(DrawnBox{corner, {}, {}});
    drawn_level.ports.resize(3);
    const Placement placement = arrange_as_drawn(level, drawn_level);
    EXPECT_EQ(placement.boxes[0].place, (Rectangle{10, 10, 100, 40}));
    EXPECT_EQ(placement.boxes[1].place, (Rectangle{118, 10, 100, 40}));
    EXPECT_EQ(placement.boxes[2].place, (Rectangle{10, 58, 100, 40}));
}

/// A square on the upper or right side moves outwards until it leaves the title free.
TEST(DrawnPorts, LeaveTitlesFree) {
    const Rectangle box{0, 0, 100, 60};
    DrawnPorts drawn;
    drawn.header = 26;
    drawn.title = {-30, 8, 75, 12};  // from x = 20 to 95
    drawn.ports = {DrawnPort{{50, 0}}, DrawnPort{{100, 12}}, DrawnPort{{100, 50}}};
    drawn.labels.resize(3);
    const std::vector<PlacedPort> placed = squares_of(box, 26, drawn);
    EXPECT_EQ(placed[0].centre, (Point{50, -2}));
    EXPECT_EQ(placed[1].centre, (Point{105, 12}));
    EXPECT_EQ(placed[2].centre.x, 100);
}

}  // namespace
}  // namespace robochart::diagrams::layout
