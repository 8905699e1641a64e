// SPDX-License-Identifier: Apache-2.0
// Tests obstacles from drawings. Corners are compared with corners that were computed by hand, and a drawing is
// rejected if a part of it would be ignored.
#include "simulation/scenario/drawn_obstacles.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "simulation/scenario/read_scenario.hpp"
#include "tests/temporary_folder.hpp"

namespace robochart::simulation {
namespace {

using ::testing::HasSubstr;
using Polygon = std::vector<Vector>;

std::string drawing(const std::string& inside) {
    return "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:i=\"urn:editor\" "
           "viewBox=\"0 0 200 100\">" +
           inside + "</svg>";
}

std::vector<Polygon> read(const std::string& inside) {
    std::string error;
    auto found = drawn_obstacles(drawing(inside), error);
    EXPECT_EQ(error, "") << inside;
    return found;
}

std::string refused(const std::string& text) {
    std::string error;
    EXPECT_TRUE(drawn_obstacles(text, error).empty());
    return error;
}

/// The middle of the drawing, (100, 50), becomes (0, 0), and the y axis points up.
TEST(DrawnObstacles, Corners) {
    const Polygon square{{-90, 40}, {-80, 40}, {-80, 30}, {-90, 30}};
    EXPECT_EQ(read("<polygon points=\"10,10 20 10,20,20 10 20\"/>"), std::vector<Polygon>{square});
    EXPECT_EQ(read("<g><rect x=\"10\" y=\"10px\" width=\"10\" height=\"10\"/></g>"), std::vector<Polygon>{square});
    EXPECT_EQ(read("<path d=\"M 10 10 H20 V20 H10 Z\"/>"), std::vector<Polygon>{square});
    EXPECT_EQ(read("<path d=\"m10,10 10,0 0,10 -10,0z\"/>"), std::vector<Polygon>{square});
    const Polygon triangle{{0, 50}, {10, 50}, {0, 40}};
    EXPECT_EQ(read("<path d=\"M10 10h10v10h-10zM100 0L110 0 100 10Z\"/>"), (std::vector<Polygon>{square, triangle}));
    EXPECT_TRUE(read("<title>map</title><defs/><i:view><i:grid/></i:view>").empty()) << "nothing is drawn";
}

TEST(DrawnObstacles, WhatIsNotReadIsSaid) {
    const auto inside = [](const std::string& text) { return refused(drawing(text)); };
    EXPECT_THAT(inside("<circle r=\"5\"/>"), HasSubstr("`circle` is not read"));
    EXPECT_THAT(inside("<s:circle xmlns:s=\"http://www.w3.org/2000/svg\"/>"), HasSubstr("`circle` is not read"));
    EXPECT_THAT(inside("<g transform=\"rotate(45)\"/>"), HasSubstr("`transform`"));
    EXPECT_THAT(inside("<g style=\"transform:none\"/>"), HasSubstr("`transform`"));
    EXPECT_THAT(inside("<style/>"), HasSubstr("`style` is not read"));
    EXPECT_THAT(inside("<defs><rect/></defs>"), HasSubstr("`defs`"));
    EXPECT_THAT(inside("<svg viewBox=\"0 0 1 1\"/>"), HasSubstr("inside the drawing"));
    EXPECT_THAT(inside("<rect width=\"1\" height=\"1\" rx=\"1\"/>"), HasSubstr("rounded"));
    EXPECT_THAT(inside("<rect width=\"1\"/>"), HasSubstr("`rect` has no height"));
    EXPECT_THAT(inside("<rect width=\"1cm\" height=\"1\"/>"), HasSubstr("is not a length"));
    EXPECT_THAT(inside("<rect width=\"0\" height=\"1\"/>"), HasSubstr("no size"));
    EXPECT_THAT(inside("<polygon points=\"1 2 3\"/>"), HasSubstr("number"));
    EXPECT_THAT(inside("<polygon points=\"1 2 3 4\"/>"), HasSubstr("three corners"));
    EXPECT_THAT(inside("<polygon points=\"nan 2 3 4 5 6\"/>"), HasSubstr("number"));
    EXPECT_THAT(inside("<polygon points=\"1e400 2 3 4 5 6\"/>"), HasSubstr("number"));
    EXPECT_THAT(inside("<path d=\"M0 0L1 1 2 0\"/>"), HasSubstr("not closed"));
    EXPECT_THAT(inside("<path d=\"M0 0C1 1 2 0 3 3Z\"/>"), HasSubstr("command C"));
    EXPECT_THAT(inside("<path d=\"1 2\"/>"), HasSubstr("begins with"));
    EXPECT_THAT(inside("<path d=\"M0 0L1 1 2 0ZZ\"/>"), HasSubstr("closed twice"));
    EXPECT_THAT(inside("\n<polygon points=\"x\"/>"), HasSubstr("line 3"));
}

TEST(DrawnObstacles, HostileTexts) {
    EXPECT_NE(refused(""), "");
    EXPECT_THAT(refused("<html/>"), HasSubstr("not an SVG"));
    EXPECT_THAT(refused("<svg/>"), HasSubstr("no viewBox"));
    EXPECT_THAT(refused("<svg viewBox=\"0 0 -1 1\"/>"), HasSubstr("viewBox"));
    EXPECT_THAT(
        refused("<!DOCTYPE svg [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;\">]><svg viewBox=\"0 0 1 1\">&b;</svg>"),
        HasSubstr("document types"));
    EXPECT_THAT(refused("<svg viewBox=\"0 0 1 1\"><polygon"), HasSubstr("line 1"));
    EXPECT_NE(refused(std::string(1'000, '\0')), "");
    std::string deep;
    for (int i = 0; i < 100'000; ++i) deep += "<g>";
    EXPECT_NE(refused(drawing(deep)), "");
    std::string many = "<polygon points=\"";
    for (int i = 0; i < 20'000; ++i) many += "1 2 ";
    EXPECT_THAT(refused(drawing(many + "\"/>")), HasSubstr("corners"));
}

constexpr const char* world = R"(scenario S for M {
	step 0.1 s physics 0.1 s unit 0.1 s duration 1 s
	arena 400 cm by 200 cm
	obstacles "map.svg" with 2 cm per unit
	robots 30 { radius 3 cm place linked around (0 cm, -50 cm) within 10 cm }
	measure linked is cluster(10 cm)
	accept each linked at 0 s >= 100 %
})";

TEST(DrawnObstacles, StandInTheArena) {
    const tests::TemporaryFolder folder;
    diagnostics::SourceManager sources;
    const auto source = sources.add(folder.in("s.scenario"), world);
    diagnostics::Diagnostics missing;
    (void)read_scenario(sources, source, missing);
    ASSERT_FALSE(missing.ok());
    EXPECT_THAT(missing.sorted_findings().at(0).message(), HasSubstr("obstacles of map.svg"));

    folder.write("map.svg", drawing("<rect x=\"10\" y=\"10\" width=\"10\" height=\"10\"/>"));
    diagnostics::Diagnostics good;
    const Scenario scenario = read_scenario(sources, source, good);
    EXPECT_TRUE(good.ok());
    ASSERT_EQ(scenario.world.arena.obstacles.size(), 1U);
    EXPECT_EQ(scenario.world.arena.obstacles[0], (Polygon{{-180, 80}, {-160, 80}, {-160, 60}, {-180, 60}}));
    EXPECT_EQ(scenario.world.arena.walls.size(), 4U);
    EXPECT_EQ(scenario.drawings.size(), 1U) << "for digests";
}

/// Every robot is within 10 cm of another one, no two robots touch, and all are in the arena.
TEST(LinkedStarts, AreLinkedAndDoNotOverlap) {
    WorldOptions options;
    options.arena.width = 60;
    options.arena.height = 100;
    options.body.radius = 3;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        World swarm(options, seed);
        ASSERT_TRUE(swarm.place_linked(30, {20, 10}, 10));
        EXPECT_EQ(swarm.position(0), (Vector{20, 10}));
        for (std::size_t i = 0; i < swarm.size(); ++i) {
            double nearest = 1e9;
            for (std::size_t j = 0; j < swarm.size(); ++j)
                if (i != j) nearest = std::min(nearest, length(swarm.position(i) - swarm.position(j)));
            EXPECT_GE(nearest, 6 - 1e-9);
            EXPECT_LE(nearest, 10 + 1e-9);
            EXPECT_LE(std::abs(swarm.position(i).x), 27);
            EXPECT_LE(std::abs(swarm.position(i).y), 47);
        }
    }
    World narrow(options, 1);
    EXPECT_FALSE(narrow.place_linked(2, {0, 0}, 5)) << "closer than a diameter";
    EXPECT_FALSE(World(options, 1).place_linked(1, {29, 0}, 10)) << "in the wall";
}

}  // namespace
}  // namespace robochart::simulation
