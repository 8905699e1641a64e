// SPDX-License-Identifier: Apache-2.0
// Compares the contents of pictures, plots and tables of trials with values computed by hand.
#include "simulation/report/pictures.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "simulation/report/plot.hpp"
#include "simulation/report/raster.hpp"
#include "simulation/report/series.hpp"

namespace robochart::simulation {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

Scenario small() {
    Scenario scenario;
    scenario.name.text = "Test";
    scenario.duration = 2;
    scenario.robots = 1;
    return scenario;
}

std::vector<Frame> two_frames() {
    return {{0, {{{0, 0}, 0}}, {0}, {}}, {2, {{{30, 40}, 1.5}}, {1}, {}}};
}

Machines machines() {
    return {{"", {"Going", "Held"}}};
}

TEST(Pictures, SvgHasEveryPanelAndRobot) {
    Scenario scenario = small();
    scenario.pictures = {0, 2};
    const std::string svg = snapshots_svg(scenario, two_frames(), machines());
    EXPECT_THAT(svg, ::testing::StartsWith("<svg "));
    EXPECT_THAT(svg, HasSubstr(">0 s<"));
    EXPECT_THAT(svg, HasSubstr(">2 s<"));
    EXPECT_THAT(svg, HasSubstr("translate(30.0 -40.0)")) << "the y axis points down";
    EXPECT_THAT(svg, HasSubstr(">Held</text>")) << "the legend";
    EXPECT_THAT(svg, HasSubstr(">x [cm]</text>"));
    EXPECT_THAT(svg, HasSubstr(">50 cm</text>")) << "the scale bar";
    EXPECT_THAT(svg, HasSubstr("prefers-color-scheme:dark"));
    EXPECT_THAT(svg, ::testing::EndsWith("</svg>\n"));
}

TEST(Pictures, AnimationNamesTheStates) {
    const std::string svg = animation_svg(small(), two_frames(), machines(), 2);
    EXPECT_THAT(svg, HasSubstr("dur=\"1s\""));
    EXPECT_THAT(svg, HasSubstr(">Held<"));
    EXPECT_THAT(svg, HasSubstr("values=\"0.0 -0.0;30.0 -40.0\""));
}

TEST(Pictures, CsvHasARowARobotATime) {
    EXPECT_EQ(positions_csv(two_frames(), machines()),
              "t,id,x,y,theta,state\n0.000,0,0.0000,0.0000,0.00000,Going\n2.000,0,30.0000,40.0000,1.50000,Held\n");
}

TEST(Pictures, RasterShowsTheRobotWhereItIs) {
    const Raster raster = rasterise_frame(small(), two_frames()[1], 2, 250);  // one pixel per centimetre
    const auto dot = [&](double x, double y) {
        const std::size_t index =
            3 * (static_cast<std::size_t>(125 - y) * raster.width + static_cast<std::size_t>(125 + x));
        return std::array{raster.dots[index], raster.dots[index + 1], raster.dots[index + 2]};
    };
    const std::array<unsigned char, 3> white{255, 255, 255};
    EXPECT_NE(dot(30, 40), white);
    EXPECT_EQ(dot(30, 46), white);
    EXPECT_EQ(dot(-30, 40), white);
}

TEST(Pictures, CsvHasAColumnForEachOfSeveralMachines) {
    const std::vector<Frame> frames{{0, {{{0, 0}, 0}, {{1, 0}, 0}}, {0, 1, 1, 0}, {}}};
    EXPECT_EQ(positions_csv(frames, {{"a", {"Going", "Held"}}, {"b", {"Open"}}}),
              "t,id,x,y,theta,state:a,state:b\n0.000,0,0.0000,0.0000,0.00000,Going,\n"
              "0.000,1,1.0000,0.0000,0.00000,Held,Open\n")
        << "the second machine of the first robot is in between";
}

TEST(Pictures, NamesAreText) {
    Scenario scenario = small();
    scenario.name.text = "<script>alert(1)</script>";
    scenario.lights.push_back({{"\"><img src=x>", {}}, {1, 2}, {1, 2}, 0, {}});
    const Machines machines{{"", {"</svg><script>", std::string(10000, 'x')}}};
    const auto frames = two_frames();
    for (const std::string& svg : {snapshots_svg(scenario, frames, machines), trajectories_svg(scenario, frames),
                                   animation_svg(scenario, frames, machines, 1),
                                   world_svg(scenario, view_of(scenario, frames), frames.back(), machines, "w"),
                                   plots_svg(scenario, charts_of(scenario, std::vector<TrialResult>(1), machines))}) {
        EXPECT_THAT(svg, Not(HasSubstr("<script")));
        EXPECT_THAT(svg, Not(HasSubstr("<img")));
    }
}

TEST(Ticks, AreRound) {
    EXPECT_THAT(axis_ticks(-125, 125, 7), ElementsAre(-100, -50, 0, 50, 100));
    EXPECT_THAT(axis_ticks(0, 180, 9), ElementsAre(0, 50, 100, 150));
    EXPECT_THAT(axis_ticks(0, 1, 6), ElementsAre(0, ::testing::DoubleEq(0.2), ::testing::DoubleEq(0.4),
                                                 ::testing::DoubleNear(0.6, 1e-12), ::testing::DoubleEq(0.8), 1));
    EXPECT_THAT(axis_ticks(3, 3, 5), ElementsAre());
    EXPECT_EQ(number_text(-0.0), "0");
}

TEST(ChartFrame, ScalesReachFromEndToEnd) {
    const ChartFrame frame("<script>", {}, number_axis("<script>", 2, 12, 8), number_axis("", 3, 3, 6));
    const PlotArea& area = frame.area();
    EXPECT_DOUBLE_EQ(frame.x(2), area.left);
    EXPECT_DOUBLE_EQ(frame.x(12), area.left + area.width);
    EXPECT_DOUBLE_EQ(frame.y(3), area.top + area.height) << "an axis without extent ends one above";
    EXPECT_DOUBLE_EQ(frame.y(4), area.top);
    EXPECT_DOUBLE_EQ(frame.y(100), area.top) << "at the end of the axis";
    EXPECT_THAT(frame.svg(), Not(HasSubstr("<script")));
}

// By definition 7 of quantiles, the quartiles of 1, 2, 4, 8 are at ranks 0.75, 1.5 and 2.25 of 0..3.
TEST(Series, QuartilesAreInterpolated) {
    const Quartiles found = quartiles_of({8, 1, 4, 2});
    EXPECT_DOUBLE_EQ(found.least, 1);
    EXPECT_DOUBLE_EQ(found.lower, 1.75);
    EXPECT_DOUBLE_EQ(found.middle, 3);
    EXPECT_DOUBLE_EQ(found.upper, 5);
    EXPECT_DOUBLE_EQ(found.most, 8);
    EXPECT_DOUBLE_EQ(quartiles_of({3}).middle, 3);
}

TEST(Series, ThinnedKeepsTheEnds) {
    EXPECT_EQ(thinning_factor(100, 100), 1U);
    EXPECT_EQ(thinning_factor(101, 100), 2U) << "0, 2, ..., 100 are 51";
    EXPECT_EQ(thinning_factor(10, 2), 9U) << "the ends alone";
    EXPECT_EQ(thinning_factor(0, 2), 1U);
    EXPECT_THAT(kept_indices(10, 4), ElementsAre(0, 4, 8, 9));
    EXPECT_THAT(kept_indices(9, 4), ElementsAre(0, 4, 8));
    EXPECT_THAT(kept_indices(0, 4), ElementsAre());
}

/// Returns three robots in a row, `gap` apart, at each of these times.
TrialResult rows(const std::vector<double>& gaps) {
    TrialResult trial;
    for (const double gap : gaps)
        trial.frames.push_back(
            {static_cast<double>(trial.frames.size()), {{{0, 0}, 0}, {{gap, 0}, 0}, {{2 * gap, 0}, 0}}, {0, 0, 0}, {}});
    return trial;
}

TEST(Series, OverTheTrialsThatHadNotEnded) {
    Scenario scenario = small();
    scenario.robots = 3;
    scenario.measures.push_back({{"c", {}}, MeasureKind::cluster, 10, 0, {}, {}});
    scenario.bands.push_back({{StatisticKind::at_time, 0, 1, {}}, true, 0.5, 1, "each", {}});
    // Of three robots in a row, two pairs are one gap apart and one pair is two gaps apart, which is 4/3 of a gap on
    // average.
    const Charts charts = charts_of(scenario, {rows({30, 10, 3}), rows({60, 30})}, machines());
    EXPECT_THAT(charts.times, ElementsAre(0, 1, 2));
    ASSERT_EQ(charts.charts.size(), 4U);
    const Chart& distance = charts.charts[0];
    EXPECT_THAT(distance.series[0].trials[0],
                ElementsAre(40, ::testing::DoubleNear(40.0 / 3, 1e-9), ::testing::DoubleEq(4)));
    EXPECT_DOUBLE_EQ(distance.series[0].all[0].middle, 60) << "between 40 and 80";
    EXPECT_DOUBLE_EQ(distance.series[0].all[2].most, 4) << "the second trial had ended";
    const Chart& largest = charts.charts[1];
    EXPECT_EQ(largest.unit, "%");
    EXPECT_DOUBLE_EQ(largest.series[0].trials[0][0], 100 / 3.0) << "each alone";
    EXPECT_DOUBLE_EQ(largest.series[0].trials[0][1], 100);
    ASSERT_EQ(largest.targets.size(), 1U);
    EXPECT_DOUBLE_EQ(largest.targets[0].from, 1);
    EXPECT_DOUBLE_EQ(largest.targets[0].low, 50) << "in the chart's unit";
    EXPECT_THAT(charts.charts[2].series[0].trials[1], ElementsAre(3, 3));
    ASSERT_EQ(charts.charts[3].series.size(), 2U) << "the states";
    EXPECT_EQ(charts.charts[3].series[1].name, "Held");
    EXPECT_THAT(charts.charts[3].series[0].trials[1], ElementsAre(3, 3)) << "all robots are in the first state";
    EXPECT_THAT(charts.charts[3].series[1].trials[1], ElementsAre(0, 0));
}

TEST(Series, LinksAreTwoDiametersWithoutAMeasure) {
    Scenario scenario = small();
    scenario.world.body.radius = 5;
    EXPECT_DOUBLE_EQ(link_of(scenario), 20);
    scenario.measures.push_back({{"c", {}}, MeasureKind::cluster, 11, 0, {}, {}});
    EXPECT_DOUBLE_EQ(link_of(scenario), 11);
}

TEST(Series, NoMoreTimesThanAskedFor) {
    Scenario scenario = small();
    scenario.robots = 3;
    const TrialResult trial = rows(std::vector<double>(1000, 5));
    const Charts charts = charts_of(scenario, {trial}, machines(), 50);
    EXPECT_LE(charts.times.size(), 50U);
    EXPECT_GT(charts.times.size(), 40U);
    EXPECT_EQ(charts.times.back(), 999);
}

// Ten million pairs at each of twenty times are too many. Mean distances are omitted, but clusters are not.
TEST(Series, TooManyPairsAreLeftOut) {
    Scenario scenario = small();
    scenario.robots = 5000;
    const Charts charts = charts_of(scenario, {rows({5, 5}), rows({5, 5})}, machines());
    EXPECT_FALSE(charts.distances);
    ASSERT_FALSE(charts.charts.empty());
    EXPECT_EQ(charts.charts[0].title, "Largest cluster");
}

TEST(Plot, HasAxesBandsAndALineForEachTrial) {
    Scenario scenario = small();
    scenario.robots = 3;
    const Charts charts = charts_of(scenario, {rows({30, 10, 3}), rows({60, 30, 6})}, machines());
    const ChartFrame drawn = draw_plot(charts.charts[0], charts.times, true);
    EXPECT_THAT(drawn.content(), HasSubstr(">[cm]</text>"));
    EXPECT_THAT(drawn.content(), HasSubstr(">time [s]</text>"));
    EXPECT_THAT(drawn.content(), HasSubstr("data-trial=\"1\""));
    // The values at 0 s are 40 and 80. The axis ends 5 % above 80.
    const auto y = [&](double value) {
        return fmt::format("{:.1f}", drawn.area().top + drawn.area().height * (1 - value / 84));
    };
    EXPECT_THAT(drawn.content(), HasSubstr("points=\"62.0," + y(60))) << "the median";
    EXPECT_THAT(drawn.content(), HasSubstr("points=\"62.0," + y(80))) << "the upper edge of all trials";
    EXPECT_THAT(drawn.content(), HasSubstr("points=\"62.0," + y(40))) << "the first trial";
}

}  // namespace
}  // namespace robochart::simulation
