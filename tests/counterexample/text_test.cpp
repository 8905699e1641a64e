// SPDX-License-Identifier: Apache-2.0
// Tests the texts of runs: what they contain and what they omit.
#include "counterexample/text.hpp"

#include <gtest/gtest.h>

namespace robochart::runs {
namespace {

Machine machine(const std::string& component, const std::string& text) {
    return {component, "S", text, {}, {}, {}};
}

Step step(Kind kind, const std::string& text, std::vector<Machine> machines, std::int64_t time = 0) {
    Step result;
    result.time = time;
    result.hidden = true;
    result.event.kind = kind;
    result.event.text = text;
    result.event.component = machines.front().component;
    result.machines = std::move(machines);
    return result;
}

Step tock(std::int64_t units, std::vector<Machine> machines, std::int64_t time) {
    Step result = step(Kind::tock, "", std::move(machines), time);
    result.units = units;
    result.event.component.clear();
    return result;
}

TEST(Text, TimeIsSaidInTimedRunsOnly) {
    runs::Run run;
    run.initial = {machine("S", "at initial node i")};
    run.steps = {step(Kind::transition, "t0: i -> A", {machine("S", "in A")})};
    run.steps[0].event.place = Place{"s.rct", 3, 1, 3, 9};
    run.steps[0].time.reset();
    run.end.why = "it has been reached";
    EXPECT_EQ(text_of(run, "  "),
              "  t0: i -> A   s.rct:3\n"
              "  now in A\n"
              "  why it has been reached\n");
    run.timed = true;
    run.steps.insert(run.steps.begin(), tock(4, {machine("S", "at initial node i")}, 0));
    run.steps[1].time = 4;
    run.time = 4;
    EXPECT_EQ(text_of(run, ""),
              "t=4    t0: i -> A   s.rct:3\n"
              "now at t=4: in A\n"
              "why it has been reached\n");
}

TEST(Text, TimeThatPassesAtTheEndIsALineOfItsOwn) {
    runs::Run run;
    run.timed = true;
    run.time = 5;
    run.steps = {step(Kind::transition, "t0: i -> A", {machine("S", "in A")}, 3), tock(2, {machine("S", "in A")}, 3)};
    run.end.why = "w";
    EXPECT_EQ(text_of(run, ""),
              "t=3    t0: i -> A\n"
              "t=3    2 time units pass\n"
              "now at t=5: in A\n"
              "why w\n");
}

TEST(Text, WhatIsAssignedWhenTimeHasPassedIsSaidAfterIt) {
    runs::Run run;
    run.timed = true;
    run.time = 2;
    run.steps = {tock(2, {machine("S", "in A")}, 0)};
    run.steps[0].changes = {{"S", "x", std::nullopt, "2"}, {"S", "y", "0", "1"}};
    run.end.why = "w";
    EXPECT_EQ(text_of(run, ""),
              "t=2    x = 2, y = 1\n"
              "now at t=2: in A\n"
              "why w\n");
}

TEST(Text, SeveralMachinesAreNamed) {
    runs::Run run;
    run.initial = {machine("P::M::c::one", "in A"), machine("P::M::c::two", "in B")};
    run.steps = {step(Kind::output, "output a", run.initial)};
    run.steps[0].with = {{Kind::input, "input b", "P::M::c::two", "", "", {}, {}}};
    run.steps[0].changes = {{"P::M::c::two", "x", "0", "1"}};
    run.end.why = "w";
    EXPECT_EQ(text_of(run, ""),
              "one   output a; two: input b   [x = 1]\n"
              "now one: in A; two: in B\n"
              "why w\n");
    // Two components with the same name are distinguished.
    run.initial[1].component = run.steps[0].machines[1].component = "P::M::d::one";
    run.steps[0].with[0].component = "P::M::d::one";
    EXPECT_EQ(text_of(run, ""),
              "P::M::c::one   output a; P::M::d::one: input b   [x = 1]\n"
              "now P::M::c::one: in A; P::M::d::one: in B\n"
              "why w\n");
}

TEST(Text, ALoopIsSaidBehindTheStateInWhichItBegins) {
    runs::Run run;
    run.timed = true;
    run.time = 1;
    const std::vector<Machine> here{machine("S", "in A")};
    run.steps = {tock(1, here, 0), tock(1, here, 1)};
    run.loop_start = 1;
    run.end.why = "w";
    EXPECT_EQ(text_of(run, ""),
              "t=0    1 time unit passes\n"
              "now at t=1: in A\n"
              "then for ever:\n"
              "t=1    1 time unit passes\n"
              "why w\n");
}

TEST(Text, StepsInsideWithoutNewsAreLeftOut) {
    runs::Run run;
    const std::vector<Machine> here{machine("S", "in A")};
    run.steps = {step(Kind::internal, "read x", here), step(Kind::entered, "entered A", here),
                 step(Kind::external_write, "others write x = 1", here), step(Kind::internal, "x = 1", here)};
    run.steps[3].changes = {{"S", "x", "0", "1"}};
    run.end.why = "w";
    EXPECT_EQ(text_of(run, ""),
              "x = 1\n"
              "now in A\n"
              "why w\n");
}

}  // namespace
}  // namespace robochart::runs
