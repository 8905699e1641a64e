// SPDX-License-Identifier: Apache-2.0
// Tests the notation of values in logs. Reading inverts printing for every value of every type, and different values
// are printed differently.
#include <gtest/gtest.h>

#include <set>

#include "conformance/model/logged_value.hpp"
#include "cpp_emit/plan/types.hpp"
#include "semantics/evaluate/carrier.hpp"
#include "tests/conformance/bench.hpp"

namespace robochart::conformance {
namespace {

const char* const text = R"(
enumeration Job { Fetch(real, Colour) Both(Pose) Drop }
enumeration Colour { Red Green }
datatype Pose { x : real near : boolean }
datatype Tag { pose : Pose }
type Thing
stm M {
	var a : Job
	var b : Tag
	var c : Seq(Seq(boolean))
	var d : Set(Pose)
	var e : vector(real, 2)
	var f : matrix(boolean, 2, 2)
	var g : matrix(boolean, 2, 1)
	var h : vector(nat, 1)
	var j : boolean -> Colour
	var k : Colour <-> boolean
	var l : nat * Pose * int
	var m : string
	var n : Seq(Thing)
	var o : real
	initial i
	state A { entry o = -0.5 ; m = "a, b? <c> (d) \ /" ; m = "" }
	transition t0 { from i to A }
}
)";

/// The C++ types of the model's variables cover all kinds of types.
TEST(LoggedValues, EveryValueIsReadAsWritten) {
    const test::Model model(test::ModelFolder(text).path());
    ASSERT_EQ(model.system.machines.size(), 1U);
    for (const ir::Variable& variable : model.system.machines[0].variables) {
        const ValueReader reader(model.system, model.instantiation, variable.type, {}, NumberReading::exact);
        const bool whole = cpp_emit::is_composed(model.system.type(variable.type));
        std::set<std::string> written;
        std::int64_t place = 0;
        for (const ir::Value& value : ir::carrier_values(model.system, model.instantiation, variable.type)) {
            const std::string word = log_text(model.system, model.instantiation, variable.type, value);
            EXPECT_EQ(word.find_first_of(" \t?!"), std::string::npos) << word;
            EXPECT_TRUE(written.insert(word).second) << variable.name << " " << word;
            EXPECT_EQ(reader.read_value(word).number, whole ? place : value.number) << variable.name << " " << word;
            ++place;
        }
        EXPECT_GE(place, 2) << variable.name;
    }
}

}  // namespace
}  // namespace robochart::conformance
