// SPDX-License-Identifier: Apache-2.0
// Tests the names of events in the code's interface and in the script.
#include "conformance/code/interface.hpp"

#include <gtest/gtest.h>

#include "tests/conformance/support.hpp"

namespace robochart::conformance {
namespace {

using Kind = ModelRole::Kind;

TEST(Alphabet, RolesOfModelEvents) {
    process::EventTable events;
    const Alphabet alphabet(test::turner_interface(), events);
    const auto role = [&](const char* name) { return alphabet.model_role(events.intern(name)); };
    EXPECT_EQ(alphabet.model_role(process::tau).kind, Kind::tau);
    EXPECT_EQ(alphabet.model_role(process::tick).kind, Kind::tick);
    EXPECT_EQ(role("tock").kind, Kind::tock);
    EXPECT_EQ(role("T::terminate").kind, Kind::terminate);
    EXPECT_EQ(role("T::seeWall.in").index, 1U);
    EXPECT_EQ(role("T::speed.in.2").reading, 2U);
    EXPECT_EQ(role("T::speed.in.7").kind, Kind::foreign);  // not a value of the register
    EXPECT_EQ(role("T::speed.out.2").kind, Kind::foreign);
    EXPECT_EQ(role("T::seeWallx.in").kind, Kind::foreign);
    EXPECT_EQ(role("U::seeWall.in").kind, Kind::foreign);
    EXPECT_EQ(role("T::DriveCall.-2").kind, Kind::output);
    EXPECT_EQ(events.name(role("T::DriveCall.-2").write), "registerWrite.wrote__DriveCall.-2");
    EXPECT_EQ(role("T::DriveCall.-2").write, alphabet.write_event(0, {-2}));
}

TEST(Alphabet, TellsEventsToPeople) {
    process::EventTable events;
    Interface interface = test::turner_interface();
    interface.scale = 100;
    interface.inputs[2].carrier.kind = Carrier::Kind::real;
    interface.outputs[0].arguments[0].kind = Carrier::Kind::real;
    interface.outputs.push_back({"set_lit", {{Carrier::Kind::boolean, {}, {}}}});
    const Alphabet alphabet(interface, events);
    EXPECT_EQ(alphabet.describe_event(alphabet.read_event(0, 0)), "no seeRobot");
    EXPECT_EQ(alphabet.describe_event(alphabet.read_event(0, 1)), "seeRobot");
    EXPECT_EQ(alphabet.describe_event(alphabet.read_event(2, 1)), "speed = -0.02");
    EXPECT_EQ(alphabet.describe_event(alphabet.write_event(0, {-1088})), "Drive(-10.88)");
    EXPECT_EQ(alphabet.describe_event(alphabet.write_event(2, {1})), "lit = true");
    EXPECT_EQ(alphabet.describe_event(alphabet.tock()), "end of cycle");
}

TEST(Alphabet, ExactDecimals) {
    const Carrier real{Carrier::Kind::real, {}, {}};
    EXPECT_EQ(people_text(real, -75, 100), "-0.75");
    EXPECT_EQ(people_text(real, 300, 100), "3");
    EXPECT_EQ(people_text(real, 1, 1000), "0.001");
    EXPECT_EQ(people_text(real, -5, 1), "-5");
    EXPECT_EQ(people_text(real, INT64_MIN, 10), "-922337203685477580.8");
}

TEST(Alphabet, Enumerations) {
    const Carrier colour{Carrier::Kind::enumeration, {"Red", "Green"}, {"P_Colour_Red", "P_Colour_Green"}};
    EXPECT_EQ(cspm_text(colour, 1), "P_Colour_Green");
    EXPECT_EQ(people_text(colour, 1, 1), "Green");
    EXPECT_EQ(cspm_text(colour, 2), "2");
}

TEST(Alphabet, ClashingNamesGetDifferentConstructors) {
    process::EventTable events;
    Interface interface;
    interface.component = "T";
    interface.outputs = {{"set_x.out", {}}, {"set_x", {Carrier{}}}};
    const Alphabet alphabet(interface, events);
    EXPECT_NE(alphabet.output_constructor(0), alphabet.output_constructor(1));
}

TEST(Alphabet, ValuesNeedText) {
    process::EventTable events;
    Interface interface;
    interface.inputs = {{"x.in", {1, 2}, {"1"}, {}}};
    EXPECT_THROW(Alphabet(interface, events), AlphabetError);
}

}  // namespace
}  // namespace robochart::conformance
