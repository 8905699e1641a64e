// SPDX-License-Identifier: Apache-2.0
// Tests monitors with controllers that a generator with a seeded fault produced. The trial stops at the first event
// that the model does not allow, and the report names the event's element.
#include "app/verbs/monitor.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/command/run.hpp"
#include "command.hpp"
#include "cpp_emit/simulator_api.hpp"

namespace robochart::app::monitor_test {
namespace {

using ::testing::HasSubstr;

class Watched {
public:
    explicit Watched(const std::string& study) {
        set_verb(options_, Verb::simulate);
        options_.load.inputs = {testing::repository("corpus/" + study + "/" + study + ".scenario")};
        options_.simulate.trials = 1;
        options_.simulate.monitor = true;
        run_ = std::make_unique<Run>(options_);
        options_.run = run_.get();
        simulation_ = load_simulation(options_);
        guard_ = make_guard(*simulation_, options_);
        EXPECT_NE(guard_, nullptr);
    }

    /// Runs one trial with the controller of a generator with this fault. Returns why the trial stopped, or nullopt if
    /// it did not.
    std::optional<simulation::Stop> run(cpp_emit::Fault fault, std::uint32_t site) {
        driver::Project& project = *simulation_->project;
        cpp_emit::Options generator;
        generator.cycle_length = simulation_->scenario.units_per_step;
        generator.sources = &project.sources;
        generator.fault = fault;
        generator.fault_site = site;
        const auto component = driver::code_components(project.system, simulation_->scenario.component.text).front();
        const auto emission =
            cpp_emit::emit_drive(project.system, project.instantiation, component, generator, project.diagnostics);
        std::string error;
        const auto controller = simulation::Controller::build(emission, "", error);
        EXPECT_NE(controller, nullptr) << error;
        simulation::RunOptions options;
        options.record = false;
        options.trace = guard_->make_observer({});
        diagnostics::Diagnostics found;
        return simulation::run_trials(simulation_->plan, controller->drive(), options, found).trials.at(0).stop;
    }

private:
    Options options_;
    std::unique_ptr<Run> run_;
    std::unique_ptr<Simulation> simulation_;
    std::unique_ptr<simulation::Guard> guard_;
};

TEST(Monitors, StopFaultyControllersWithTheElement) {
    using cpp_emit::Fault;
    Watched aggregation("aggregation");
    EXPECT_FALSE(aggregation.run(Fault::none, 0).has_value());
    for (const auto& [fault, cause] :
         std::vector<std::pair<Fault, std::string>>{{Fault::argument_swapped, "angularSpeed"},
                                                    {Fault::entry_dropped, "the end of the cycle"},
                                                    {Fault::wrong_target, ""},
                                                    {Fault::wait_dropped, ""}}) {
        const auto stop = aggregation.run(fault, 0);
        ASSERT_TRUE(stop.has_value()) << static_cast<int>(fault);
        EXPECT_THAT(stop->cause, HasSubstr("its model does not allow " + cause));
        EXPECT_THAT(stop->place, HasSubstr("aggregation.rct:"));
    }
}

TEST(Monitors, StopFaultyTaxis) {
    using cpp_emit::Fault;
    Watched taxis("swarm_taxis");
    EXPECT_FALSE(taxis.run(Fault::none, 0).has_value());
    for (const auto& [fault, site] : std::vector<std::pair<Fault, std::uint32_t>>{{Fault::wait_dropped, 0},
                                                                                  {Fault::clock_off_by_one, 0},
                                                                                  {Fault::entry_dropped, 1},
                                                                                  {Fault::guard_negated, 0}}) {
        const auto stop = taxis.run(fault, site);
        ASSERT_TRUE(stop.has_value()) << static_cast<int>(fault);
        EXPECT_THAT(stop->place, HasSubstr("swarm_taxis.rct:"));
    }
}

}  // namespace
}  // namespace robochart::app::monitor_test
