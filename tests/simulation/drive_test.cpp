// SPDX-License-Identifier: Apache-2.0
// Tests that the interface for simulators passes values of every generated type to the controller and back.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "harness.hpp"

namespace robochart::simulation {
namespace {

using cpp_emit::Carried;
using testing::Experiment;
using testing::replaced;

constexpr const char* model = R"(
enumeration Colour { Red Green Blue }
interface In { event n_in : nat event i_in : int event b_in : boolean event r_in : real event c_in : Colour }
interface Out { event n_out : nat event i_out : int event b_out : boolean event r_out : real event c_out : Colour }
stm Echo {
	uses In
	uses Out
	var n : nat
	var k : int
	var b : boolean
	var r : real
	var c : Colour
	initial i
	state Ready { }
	transition t0 { from i to Ready }
	transition t1 { from Ready to Ready trigger n_in?n action n_out!(n + 1) }
	transition t2 { from Ready to Ready trigger i_in?k action i_out!(k - 7) }
	transition t3 { from Ready to Ready trigger b_in?b action b_out!(not b) }
	transition t4 { from Ready to Ready trigger r_in?r action r_out!(r * 0.5) }
	transition t5 { from Ready to Ready trigger c_in?c action c_out!c }
}
)";

constexpr const char* scenario = R"(
scenario World for Echo {
	step 0.1 s physics 0.01 s unit 0.1 s duration 1 s trials 1
	arena 100 cm by 100 cm
	robots 1 { place at (0 cm, 0 cm) heading 0 deg }
	stimulus n_in = 3 at 0 s
}
)";

class Echo : public ::testing::Test {
protected:
    void SetUp() override {
        std::string error;
        controller_ = Controller::build(experiment_.emission, "", error);
        ASSERT_NE(controller_, nullptr) << error << experiment_.messages();
        signals_.resize(experiment_.emission.inputs.size());
    }

    std::uint32_t input(const std::string& name) {
        for (std::uint32_t i = 0; i < experiment_.emission.inputs.size(); ++i)
            if (experiment_.emission.inputs[i].name == name) return i;
        ADD_FAILURE() << name;
        return 0;
    }
    /// Runs one cycle with one input. Returns the value of an output.
    rc_value step(const std::string& in, rc_value value, const std::string& out) {
        for (rc_signal& signal : signals_) signal.present = 0;
        signals_[input(in)] = {1, 0, value};
        ControllerArray one(controller_->drive(), 1);
        rc_actions actions{};
        EXPECT_EQ(controller_->drive().step(one[0], signals_.data(), &actions), RC_DRIVE_QUIESCENT);
        EXPECT_EQ(controller_->drive().state_of(one[0], 0), 0U);
        EXPECT_STREQ(controller_->drive().machine[0].state[0], "Ready");
        if (actions.count != 1) {
            ADD_FAILURE() << actions.count << " actions";
            return {};
        }
        EXPECT_EQ(experiment_.emission.outputs[actions.action[0].output].name, out);
        EXPECT_EQ(actions.action[0].count, 1U);
        return actions.action[0].argument[0];
    }
    static rc_value whole(std::int64_t number) {
        rc_value value{};
        value.whole = number;
        return value;
    }

    Experiment experiment_{model, scenario};
    std::unique_ptr<Controller> controller_;
    std::vector<rc_signal> signals_;
};

TEST_F(Echo, CarriesEveryType) {
    rc_value real{};
    real.real = 0.3;
    EXPECT_EQ(step("n_in", whole(41), "n_out").whole, 42);
    EXPECT_EQ(step("i_in", whole(-5), "i_out").whole, -12);
    EXPECT_EQ(step("b_in", whole(1), "b_out").whole, 0);
    EXPECT_EQ(step("b_in", whole(0), "b_out").whole, 1);
    EXPECT_DOUBLE_EQ(step("r_in", real, "r_out").real, 0.15);
    EXPECT_EQ(step("c_in", whole(2), "c_out").whole, 2);
}

TEST_F(Echo, SaysWhatEachPortCarries) {
    const auto& inputs = experiment_.emission.inputs;
    EXPECT_EQ(inputs[input("n_in")].arguments, std::vector{Carried::whole});
    EXPECT_EQ(inputs[input("b_in")].arguments, std::vector{Carried::boolean});
    EXPECT_EQ(inputs[input("r_in")].arguments, std::vector{Carried::real});
    EXPECT_EQ(inputs[input("c_in")].arguments, std::vector{Carried::enumeration});
    EXPECT_STREQ(controller_->drive().input[input("i_in")], "i_in.in");
}

TEST_F(Echo, NamesItsPlaceInTheModel) {
    ControllerArray one(controller_->drive(), 1);
    EXPECT_STREQ(controller_->drive().place_of(one[0]), "Echo::i (model.rct:13)");
    ASSERT_EQ(controller_->drive().machines, 1U);
    EXPECT_EQ(controller_->drive().state_of(one[0], 0), controller_->drive().machine[0].states) << "in no state yet";
}

TEST(Drive, BearsAnyNameOfTheModelsFile) {
    Experiment experiment(model, scenario, "a \"strange\\ name.rct");
    std::string error;
    const auto controller = Controller::build(experiment.emission, "", error);
    ASSERT_NE(controller, nullptr) << error;
    ControllerArray one(controller->drive(), 1);
    EXPECT_STREQ(controller->drive().place_of(one[0]), "Echo::i (a \"strange\\ name.rct:13)");
}

/// The first machine keeps its state. With the event, the second machine goes to the inner state of a composite state.
TEST(Drive, ShowsTheStateOfEachMachine) {
    Experiment experiment(R"(
interface Events { event go }
robotic platform Body { uses Events }
stm Stays { initial i state Here { } transition t0 { from i to Here } }
stm Goes {
	uses Events
	initial i
	state Waiting { }
	state Going { initial j state Slow { } state Fast { } transition u0 { from j to Fast } transition u1 { from Fast to Slow trigger go } }
	transition t0 { from i to Waiting }
	transition t1 { from Waiting to Going trigger go }
}
controller Brain {
	uses Events
	sref stays = Stays
	sref goes = Goes
	connection Brain on go to goes on go
}
module Robot {
	rref body = Body
	cref brain = Brain
	connection body on go to brain on go (_async)
}
)",
                          replaced(replaced(scenario, "for Echo", "for Robot"), "n_in = 3", "go"));
    const RunResult result = experiment.run();
    ASSERT_NE(experiment.controller, nullptr) << experiment.messages();
    const std::vector<MachineStates> machines = machines_of(experiment.controller->drive());
    ASSERT_EQ(machines.size(), 2U);
    EXPECT_EQ(machines[0].name, "brain::stays");
    EXPECT_EQ(machines[1].name, "brain::goes");
    ASSERT_EQ(experiment.emission.machines.size(), 2U);
    EXPECT_EQ(experiment.emission.machines[1].states.size(), machines[1].states.size());
    const Frame& last = result.trials.at(0).frames.back();
    EXPECT_EQ(machines[0].state_name(last.robot_state(0, 0)), "Here");
    EXPECT_EQ(machines[1].state_name(last.robot_state(0, 1)), "Going::Fast");
}

/// Different robots and trials draw different alternatives, and a repeated run draws the same ones.
TEST(Drive, RobotsDrawTheirWays) {
    Experiment experiment(R"(
stm Coin {
	event go
	initial i
	probabilistic p
	state Heads { }
	state Tails { }
	transition t0 { from i to p }
	transition t1 { from p to Heads probability 0.5 }
	transition t2 { from p to Tails probability 0.5 }
	transition t3 { from Heads to p trigger go }
	transition t4 { from Tails to p trigger go }
}
)",
                          replaced(replaced(scenario, "for Echo", "for Coin"), "n_in = 3", "go"));
    std::string error;
    const auto controller = Controller::build(experiment.emission, "", error);
    ASSERT_NE(controller, nullptr) << error << experiment.messages();
    constexpr std::size_t robots = 1000;
    const auto heads = [&](std::uint64_t seed) {
        ControllerArray all(controller->drive(), robots, seed);
        std::vector<bool> result;
        const rc_signal none{};
        rc_actions actions{};
        for (std::size_t robot = 0; robot < robots; ++robot) {
            EXPECT_EQ(controller->drive().step(all[robot], &none, &actions), RC_DRIVE_QUIESCENT);
            result.push_back(controller->drive().state_of(all[robot], 0) == 0);
        }
        return result;
    };
    const std::vector<bool> first = heads(1);
    const auto count = std::ranges::count(first, true);
    EXPECT_NEAR(static_cast<double>(count), 500.0, 79.0) << "five standard deviations";
    EXPECT_EQ(first, heads(1));
    EXPECT_NE(first, heads(2));
}

/// Events without a source are reported (RC-M14). A stimulus can provide a number for a nat.
TEST_F(Echo, ScenarioIsBoundWithWarnings) {
    EXPECT_EQ(experiment_.codes(), "RC-M14 RC-M14 RC-M14 RC-M14") << experiment_.messages();
}

}  // namespace
}  // namespace robochart::simulation
