// SPDX-License-Identifier: Apache-2.0
// Tests that reports of whole cycles have the same results as reports of single events, for allowed runs and for
// violations.
#include "conformance/monitor/cycle_cache.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <algorithm>

#include <limits>
#include <random>

#include "conformance/monitor/monitor.hpp"
#include "tests/conformance/bench.hpp"

namespace robochart::conformance {
namespace {

using cpp_emit::Carried;
using cpp_emit::Port;

struct Written {
    std::uint32_t output;
    std::vector<double> arguments;  ///< integers for integer types
};

/// The tables and ports of one component, and two monitors. One monitor receives whole cycles, the other single events.
class Pair {
public:
    Pair(const MonitorTables& tables, std::vector<Port> inputs, std::vector<Port> outputs)
        : inputs_(std::move(inputs)),
          outputs_(std::move(outputs)),
          signals(inputs_.size() + 1),
          cycles(tables, inputs_, outputs_),
          whole(tables),
          single(tables) {}

    void read(std::uint32_t input, double value = 0) {
        signals[input].present = 1;
        signals[input].value = raw(inputs_[input], 0, value);
    }

    /// Reports a cycle to a monitor event by event.
    void report_events(Monitor& monitor, const std::vector<Written>& written) const {
        for (std::uint32_t i = 0; i < inputs_.size(); ++i) {
            if (signals[i].present == 0)
                monitor.absent(i);
            else if (inputs_[i].arguments.empty())
                monitor.read(i);
            else if (inputs_[i].arguments[0] == Carried::real)
                monitor.read(i, signals[i].value.real);
            else
                monitor.read(i, signals[i].value.whole);
        }
        for (const Written& one : written) {
            std::uint32_t place = Monitor::start();
            for (std::uint32_t k = 0; k < one.arguments.size(); ++k)
                place = outputs_[one.output].arguments[k] == Carried::real
                            ? monitor.argument(place, one.output, k, one.arguments[k])
                            : monitor.argument(place, one.output, k, static_cast<std::int64_t>(one.arguments[k]));
            monitor.wrote_at(one.output, place);
        }
        monitor.end_of_cycle();
    }

    /// Reports the cycle to both monitors and compares them. Clears the signals afterwards.
    void cycle(const std::vector<Written>& written) {
        report_events(single, written);
        rc_actions actions{};
        for (const Written& one : written) {
            rc_action& action = actions.action[actions.count++];
            action.output = one.output;
            for (std::uint32_t k = 0; k < one.arguments.size(); ++k)
                action.argument[action.count++] = raw(outputs_[one.output], k, one.arguments[k]);
        }
        cycles.pass_cycle(whole, signals.data(), actions, RC_DRIVE_QUIESCENT);
        std::ranges::fill(signals, rc_signal{});
        ASSERT_EQ(whole.verdict(), single.verdict());
        ASSERT_EQ(whole.state(), single.state());
        ASSERT_STREQ(whole.where(), single.where());
        if (whole.verdict() == MonitorVerdict::violated) {
            ASSERT_STREQ(whole.event(), single.event());
            ASSERT_STREQ(whole.element(), single.element());
        }
    }

    void reset() {
        whole.reset();
        single.reset();
    }

private:
    static rc_value raw(const Port& port, std::size_t argument, double value) {
        rc_value result;
        if (!port.arguments.empty() && port.arguments[argument] == Carried::real)
            result.real = value;
        else
            result.whole = static_cast<std::int64_t>(value);
        return result;
    }

    std::vector<Port> inputs_, outputs_;

public:
    std::vector<rc_signal> signals;
    CycleCache cycles;
    Monitor whole, single;
};

Port port(std::vector<Carried> arguments = {}) {
    Port result;
    result.arguments = std::move(arguments);
    return result;
}

class Made {
public:
    explicit Made(const std::string& folder) : project_(folder, {}) {
        std::string error;
        model_ = CyclicModel::load(project_.system, project_.instantiation, project_.first_module(), 1, limits_,
                                   project_.sources, project_.diagnostics, error);
        EXPECT_NE(model_, nullptr) << error;
        build = MonitorBuild::make(*model_, limits_, project_.sources);
    }
    [[nodiscard]] std::uint32_t input(const std::string& name) const {
        return find_channel(build->tables().input, build->tables().inputs, name);
    }
    [[nodiscard]] std::uint32_t output(const std::string& name) const {
        return find_channel(build->tables().output, build->tables().outputs, name);
    }
    std::unique_ptr<MonitorBuild> build;

private:
    static std::uint32_t find_channel(const MonitorChannel* channels, std::uint32_t count, const std::string& name) {
        for (std::uint32_t i = 0; i < count; ++i)
            if (channels[i].name == name) return i;
        ADD_FAILURE() << name;
        return 0;
    }

    test::Model project_;
    refine::Limits limits_;
    std::unique_ptr<CyclicModel> model_;
};

/// Runs ten thousand cycles of swarm taxis. The model allows most outputs, because the test first tries them on a copy
/// of the monitor. It forbids some, among them headings that never occurred before.
TEST(CycleCache, WholeCyclesGiveTheResultsOfTheirEvents) {
    const Made made("corpus/swarm_taxis");
    const MonitorTables& tables = made.build->tables();
    std::vector<Port> inputs(tables.inputs);
    std::vector<Port> outputs(tables.outputs);
    inputs[made.input("illumination")] = outputs[made.output("illuminated")] = port({Carried::boolean});
    outputs[made.output("reached")] = port({Carried::boolean});
    inputs[made.input("heading")] = port({Carried::real});
    for (const char* const name : {"avoidanceRadius", "desiredTurningDegree", "StartTurning"})
        outputs[made.output(name)] = port({Carried::real});
    Pair pair(tables, inputs, outputs);
    std::mt19937 random(7);
    const auto chance = [&](double share) { return std::uniform_real_distribution<>(0, 1)(random) < share; };
    int violated = 0;
    for (int i = 0; i < 10000; ++i) {
        const bool lit = chance(0.5);
        const double heading = chance(0.3) ? 0.2 : std::uniform_real_distribution<>(-180, 180)(random);
        if (chance(0.5)) pair.read(made.input("illumination"), lit ? 1 : 0);
        if (chance(0.3)) pair.read(made.input("heading"), heading);
        if (chance(0.3)) pair.read(made.input("robotDetected"));
        if (chance(0.3)) pair.read(made.input("turned"));
        const Written forward{made.output("MoveForward"), {}};
        const Written look{made.output("CheckIlluminationStatus"), {}};
        std::vector<std::vector<Written>> outcomes{{},
                                                   {forward, look},
                                                   {{made.output("illuminated"), {lit ? 1.0 : 0.0}},
                                                    {made.output("avoidanceRadius"), {lit ? 0.2 : 0.1}},
                                                    forward,
                                                    look},
                                                   {{made.output("CalcAvoidanceHeading"), {}}},
                                                   {{made.output("CalcCoherenceHeading"), {}}},
                                                   {{made.output("desiredTurningDegree"), {heading}},
                                                    {made.output("reached"), {0}},
                                                    {made.output("StartTurning"), {heading}}},
                                                   {{made.output("reached"), {1}}, forward, look}};
        std::shuffle(outcomes.begin(), outcomes.end(), random);
        if (!chance(0.02)) {
            const auto allowed = std::ranges::find_if(outcomes, [&](const auto& outcome) {
                Monitor trial = pair.single;
                pair.report_events(trial, outcome);
                return trial.verdict() == MonitorVerdict::allowed;
            });
            if (allowed != outcomes.end()) outcomes[0] = *allowed;
        }
        ASSERT_NO_FATAL_FAILURE(pair.cycle(outcomes[0])) << "cycle " << i;
        if (pair.whole.verdict() == MonitorVerdict::allowed) continue;
        ++violated;
        pair.reset();
    }
    EXPECT_GT(pair.cycles.hit_count(), 5000U) << "else only events were reported";
    EXPECT_GT(violated, 50);
}

/// The tables are written by hand. There is one state. The input has the values -1 and 3. One output has two arguments
/// from {0, 1}; (0, 1) and (1, 0) are allowed. Another output is a real number, 0 or 0.5.
class ByHand : public ::testing::Test {
protected:
    static constexpr std::uint16_t dead = Monitor::dead;
    const std::int64_t read_values[2] = {-1, 3}, bits[2] = {0, 1}, halves[2] = {0, 5};
    const MonitorValues read_range{read_values, 2, 1, false, false};
    const MonitorValues two_ranges[2] = {{bits, 2, 1, true, false}, {bits, 2, 1, true, false}};
    const MonitorValues real_range{halves, 2, 10, false, false};
    const std::uint16_t read_columns[3] = {0, 1, 2}, two_columns[4] = {dead, 3, 4, dead}, real_columns[2] = {5, 6};
    const MonitorChannel inputs[1] = {{"in", "in (a.rct:1)", &read_range, 1, read_columns}};
    const MonitorChannel outputs[2] = {{"two", "two (a.rct:2)", two_ranges, 2, two_columns},
                                       {"real", "real (a.rct:3)", &real_range, 1, real_columns}};
    const std::uint16_t next[8] = {0, 0, 0, 0, 0, 0, 0, 0};
    const char* const where[1] = {nullptr};
    const MonitorTables tables{"C", 1, 1, 8, next, 1, inputs, 2, outputs, 7, dead, where};
    Pair pair{tables, {port({Carried::whole})}, {port({Carried::whole, Carried::whole}), port({Carried::real})}};
};

TEST_F(ByHand, OutputsOfSeveralArguments) {
    for (int i = 0; i < 3; ++i) pair.cycle({{0, {0, 1}}});
    for (int i = 0; i < 3; ++i) pair.cycle({{0, {1, 0}}, {1, {0.5}}});
    EXPECT_EQ(pair.cycles.hit_count(), 4U) << "all but the first of each";
    pair.cycle({{0, {0, 0}}});
    EXPECT_EQ(pair.whole.verdict(), MonitorVerdict::violated) << "its first argument is as before, its second is not";
}

TEST_F(ByHand, ValuesOutsideLeaveEverythingOpen) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    for (const double value : {0.25, none, 1e300, -1e300, 0.5 + 1e-6}) {
        pair.reset();
        pair.cycle({{1, {0.5}}});
        pair.cycle({{1, {value}}});
        EXPECT_EQ(pair.whole.verdict(), MonitorVerdict::unknown) << value;
        pair.cycle({{1, {0.5}}});
        EXPECT_EQ(pair.whole.verdict(), MonitorVerdict::unknown) << "for good";
    }
    for (const double value : {2.0, -2.0, 9e18, -9e18}) {
        pair.reset();
        pair.read(0, value);
        pair.cycle({});
        EXPECT_EQ(pair.whole.verdict(), MonitorVerdict::unknown) << value;
    }
}

TEST_F(ByHand, ReadingsAreDistinguished) {
    for (int i = 0; i < 3; ++i)
        for (const double value : {-1.0, 3.0}) {
            pair.read(0, value);
            pair.cycle({{1, {0.0}}});
            pair.cycle({{1, {-0.0}}});
        }
    EXPECT_EQ(pair.whole.verdict(), MonitorVerdict::allowed);
}

TEST_F(ByHand, TerminationIsNoCycle) {
    pair.cycle({});
    const rc_actions nothing{};
    pair.cycles.pass_cycle(pair.whole, pair.signals.data(), nothing, RC_DRIVE_TERMINATED);
    EXPECT_EQ(pair.whole.verdict(), MonitorVerdict::violated);
    EXPECT_STREQ(pair.whole.event(), "termination");
}

/// Cycles with more outputs than the cache stores are processed event by event, with the same results.
TEST_F(ByHand, LongCycles) {
    const std::vector<Written> often(40, Written{1, {0.5}});
    pair.cycle(often);
    pair.cycle(often);
    EXPECT_EQ(pair.cycles.hit_count(), 0U);
    EXPECT_EQ(pair.whole.verdict(), MonitorVerdict::allowed);
}

}  // namespace
}  // namespace robochart::conformance
