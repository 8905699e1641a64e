// SPDX-License-Identifier: Apache-2.0
// Tests monitors. Their automaton is that of the normal form, their header is self-contained, and their verdicts agree
// with those on logs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "conformance/monitor/monitor.hpp"
#include "cpp_emit/load/shared_library.hpp"
#include "tests/conformance/bench.hpp"

namespace robochart::conformance {
namespace {

using ::testing::HasSubstr;

class MonitoredModel {
public:
    explicit MonitoredModel(const std::string& folder, const ir::InstantiationOptions& options = {})
        : project_(folder, options) {
        std::string error;
        model_ = CyclicModel::load(project_.system, project_.instantiation, project_.first_module(), 1, limits_,
                                   project_.sources, project_.diagnostics, error);
        EXPECT_NE(model_, nullptr) << error;
        build = MonitorBuild::make(*model_, limits_, project_.sources);
    }
    std::unique_ptr<MonitorBuild> build;

private:
    test::Model project_;
    refine::Limits limits_;
    std::unique_ptr<CyclicModel> model_;
};

// Lists the registers of the aggregation module, and then its outputs, in the order of the code's interface.
enum Input : std::uint32_t { see_wall, see_robot };
enum Output : std::uint32_t { linear, angular };

void cycle(Monitor& monitor, bool wall, bool robot, const std::vector<std::pair<Output, double>>& writes) {
    if (wall)
        monitor.read(see_wall);
    else
        monitor.absent(see_wall);
    if (robot)
        monitor.read(see_robot);
    else
        monitor.absent(see_robot);
    for (const auto& [output, value] : writes) monitor.wrote(output, value);
    monitor.end_of_cycle();
}

const std::vector<std::pair<Output, double>> drives{{angular, -0.75}, {linear, -10.88}};
const std::vector<std::pair<Output, double>> turns{{angular, -5.02}, {linear, 0.0}};

TEST(Monitors, AllowRunsOfTheModel) {
    const MonitoredModel made("corpus/aggregation");
    ASSERT_STREQ(made.build->tables().input[see_wall].name, "seeWall");
    ASSERT_STREQ(made.build->tables().output[angular].name, "angularSpeed");
    Monitor monitor(made.build->tables());
    cycle(monitor, true, false, drives);
    cycle(monitor, false, true, turns);
    cycle(monitor, false, true, {});
    cycle(monitor, true, false, drives);
    EXPECT_EQ(monitor.verdict(), MonitorVerdict::allowed) << monitor.event();
    EXPECT_THAT(monitor.where(), HasSubstr("in S1 ("));
}

TEST(Monitors, StopAtTheFirstEventThatIsNot) {
    const MonitoredModel made("corpus/aggregation");
    Monitor late(made.build->tables());
    cycle(late, true, false, drives);
    cycle(late, false, true, {});
    EXPECT_EQ(late.verdict(), MonitorVerdict::violated);
    EXPECT_STREQ(late.event(), "the end of the cycle");
    EXPECT_THAT(late.where(), HasSubstr("in S1 ("));
    Monitor wrong(made.build->tables());
    cycle(wrong, true, false, drives);
    cycle(wrong, false, true, {{angular, -5.02}, {linear, -10.88}});
    EXPECT_STREQ(wrong.event(), "linearSpeed");
    EXPECT_THAT(wrong.element(), HasSubstr("aggregation.rct:"));
    // Later cycles do not change the verdict.
    cycle(wrong, true, false, drives);
    EXPECT_STREQ(wrong.event(), "linearSpeed");
    wrong.reset();
    cycle(wrong, true, false, drives);
    EXPECT_EQ(wrong.verdict(), MonitorVerdict::allowed);
}

/// Preconditions of this model test the speeds, so the verdict on a speed outside the finite instantiation is unknown.
TEST(Monitors, SayWhereTheyKnowNothing) {
    const MonitoredModel made("corpus/aggregation");
    Monitor monitor(made.build->tables());
    cycle(monitor, true, false, {{angular, -0.7512}});
    EXPECT_EQ(monitor.verdict(), MonitorVerdict::unknown);
    cycle(monitor, true, false, {});
    EXPECT_EQ(monitor.verdict(), MonitorVerdict::unknown) << "for good";
}

/// The automaton is minimal, so it has at most the states of a hand-written automaton. The hand-written one combines
/// the machine's states with the stages of a cycle. Each mode (start, S1, S2) has 2 relevant reads and up to 2 writes,
/// so there are at most 3 x 6 states.
TEST(Monitors, AreSmall) {
    const MonitoredModel made("corpus/aggregation");
    EXPECT_LE(made.build->tables().states, 18U);
    EXPECT_LT(made.build->tables().states, made.build->node_count());
}

/// The generated header and the shipped runtime header compile without exceptions, RTTI or warnings.
TEST(Monitors, StandAlone) {
    const MonitoredModel made("corpus/aggregation");
    auto files = monitor_files(made.build->tables(), "Aggregation");
    files.push_back({"use.cpp", R"(#include "Aggregation_monitor.hpp"
extern "C" __attribute__((visibility("default"))) int run(double first, double second) {
    using namespace Aggregation_monitor;
    Monitor monitor;
    static_assert(sizeof(Monitor) <= 16, "a few bytes");
    monitor.read(in_seeWall);
    monitor.absent(in_seeRobot);
    monitor.wrote(out_angularSpeed, first);
    monitor.wrote(out_linearSpeed, second);
    monitor.end_of_cycle();
    return static_cast<int>(monitor.verdict());
}
)"});
    cpp_emit::BuildOptions options;
    options.flags = "-std=c++17 -O2 -fno-exceptions -fno-rtti -Wall -Wextra -Wpedantic -Wconversion -Werror";
    std::string error;
    const auto library = cpp_emit::SharedLibrary::build(files, {"use.cpp"}, options, error);
    ASSERT_NE(library, nullptr) << error;
    const auto run = reinterpret_cast<int (*)(double, double)>(library->find_symbol("run"));
    ASSERT_NE(run, nullptr);
    EXPECT_EQ(run(-0.75, -10.88), 0);
    EXPECT_EQ(run(-0.75, 0), 1);
    EXPECT_EQ(run(-0.33, 0), 2);
    EXPECT_THAT(files[0].text, HasSubstr("(aggregation.rct:")) << "no folders in generated text";
}

/// The model only passes headings on, so the robot may turn by any heading. A monitor detects a heading that differs
/// from the received one, with rare exceptions.
TEST(Monitors, FollowValuesThatArePassedOn) {
    const MonitoredModel made("corpus/swarm_taxis");
    const MonitorTables& tables = made.build->tables();
    const auto output = [&](const std::string& name) {
        for (std::uint32_t o = 0; o < tables.outputs; ++o)
            if (tables.output[o].name == name) return o;
        ADD_FAILURE() << name;
        return 0U;
    };
    const auto run = [&](double heard, double turned) {
        Monitor monitor(tables);
        const auto reads = [&](bool near, bool hears) {
            for (std::uint32_t i = 0; i < tables.inputs; ++i) {
                const std::string name = tables.input[i].name;
                if (name == "robotDetected" && near)
                    monitor.read(i);
                else if (name == "heading" && hears)
                    monitor.read(i, heard);
                else
                    monitor.absent(i);
            }
        };
        reads(false, false);
        monitor.wrote(output("MoveForward"));
        monitor.wrote(output("CheckIlluminationStatus"));
        monitor.end_of_cycle();
        reads(true, false);
        monitor.wrote(output("CalcAvoidanceHeading"));
        monitor.end_of_cycle();
        reads(false, true);
        monitor.wrote(output("desiredTurningDegree"), turned);
        monitor.wrote(output("reached"), false);
        monitor.wrote(output("StartTurning"), turned);
        monitor.end_of_cycle();
        return monitor.verdict();
    };
    int found = 0;
    for (int i = 0; i < 20; ++i) {
        const double heading = -84.25 + 7.123 * i;
        EXPECT_EQ(run(heading, heading), MonitorVerdict::allowed) << heading;
        found += run(heading, heading + 45.5) == MonitorVerdict::violated ? 1 : 0;
    }
    EXPECT_GE(found, 10);
}

}  // namespace
}  // namespace robochart::conformance
