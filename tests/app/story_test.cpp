// Counterexamples told in the model's words.
#include "app/story.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace robochart::app {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class StoryTest : public ::testing::Test {
protected:
    StoryTest() {
        ir::Type real;
        real.kind = ir::TypeKind::real;
        system.types.push_back(real);
        instantiation.scale = 100;
        const auto file = sources.add("robot.rct", "stm S\nstate A\nstate B\n");
        provenance.events["S::moveCall"] = {csp_emit::MeaningKind::call, "call move", {ir::TypeId{0}}, {"S", {file, 6, 7}}};
        provenance.events["S::internal__.TID_t"] = {csp_emit::MeaningKind::transition, "A -> B", {}, {"S::t", {file, 14, 15}}};
        provenance.definitions["S::A__"] = {"in A", {"speed", "since(T)"}, {ir::TypeId{0}, {}}, {}};
        provenance.definitions["S::B__"] = {"in B", {"speed", "since(T)"}, {ir::TypeId{0}, {}}, {}};
    }

    [[nodiscard]] refine::Step step(const std::string& event, const std::string& state, bool hidden = false) {
        const process::Event id = events.intern(event);
        return {hidden ? process::tau : id, id, state};
    }

    process::EventTable events;
    ir::System system;
    ir::Instantiation instantiation;
    diagnostics::SourceManager sources;
    csp_emit::Provenance provenance;
};

TEST_F(StoryTest, TellsCallsTransitionsTimeAndChanges) {
    refine::Counterexample c;
    c.kind = refine::ViolationKind::deadlock;
    c.initial = "S::A__(0,0)";
    c.steps = {step("S::moveCall.-1088", "S::A__(0,0)"), step("tock", "S::A__(0,1)"), step("S::internal__.TID_t", "S::B__(-50,1)", true)};
    const StoryTeller teller(provenance, system, instantiation, sources, events);
    const Story story = teller.tell(c);
    ASSERT_EQ(story.lines.size(), 2U);
    EXPECT_EQ(story.lines[0].text, "call move(-10.88)");
    EXPECT_EQ(story.lines[0].time, 0);
    EXPECT_EQ(story.lines[0].place, "robot.rct:2");
    EXPECT_EQ(story.lines[1].text, "A -> B");
    EXPECT_EQ(story.lines[1].time, 1);
    EXPECT_EQ(story.lines[1].place, "robot.rct:3");
    EXPECT_THAT(story.lines[1].changes, ElementsAre("speed = -0.5"));
    EXPECT_EQ(story.where, "in B (speed = -0.5, since(T) = 1)");
    EXPECT_THAT(story.why, HasSubstr("nothing is possible"));
}

TEST_F(StoryTest, SmallFractionsKeepTheirZeros) {
    refine::Counterexample c;
    c.steps = {step("S::moveCall.-5", "S::A__(0,0)")};
    const StoryTeller teller(provenance, system, instantiation, sources, events);
    EXPECT_EQ(teller.tell(c).lines.front().text, "call move(-0.05)");
}

}  // namespace
}  // namespace robochart::app
