// SPDX-License-Identifier: Apache-2.0
// Tests that `-q` prints the requested answer and the errors, but no notes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/command.hpp"

namespace robochart::app::testing::quiet_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// The model causes RC-W08, because w is never read.
const std::string model = R"(stm Half {
	event go
	event done
	var w : nat
	initial i
	state A { }
	transition t0 { from i to A }
	transition t1 { from A to A trigger go action send done; w = 1 }
}
)";
const std::string rules = R"(def_start
	event go
	event done
def_end
rule_start
	R when go then done within 2 seconds
rule_end
)";

TEST(Quiet, RulesPrintTheirVerdictsAlone) {
    const Folder folder({{"half.rct", model}, {"half.sleec", rules}});
    const Ran loud = run({"rules", folder / "half.sleec", folder / "half.rct"});
    EXPECT_THAT(loud.out + loud.err, AllOf(HasSubstr("RC-W08"), HasSubstr("an input counts as an event")));
    const Ran quiet = run({"rules", "-q", folder / "half.sleec", folder / "half.rct"});
    EXPECT_EQ(quiet.exit, 1);
    EXPECT_THAT(quiet.out, AllOf(HasSubstr("R by Half: broken"), Not(HasSubstr("an input counts as an event"))));
    EXPECT_EQ(quiet.err, "");
}

TEST(Quiet, WrittenMonitorsPrintNothing) {
    const Folder folder({{"half.rct", model}, {"half.sleec", rules}});
    for (const char* const input : {"half.rct", "half.sleec"}) {
        const Ran quiet = run({"emit", "monitor", "-q", folder / input, "--out", folder / "out"});
        EXPECT_EQ(quiet.exit, 0);
        EXPECT_EQ(quiet.out + quiet.err, "") << input;
    }
}

TEST(Quiet, ErrorsArePrinted) {
    const Folder folder(
        {{"half.rct", "stm Half {\n initial i\n transition t { from i to B }\n}\n"}, {"half.sleec", rules}});
    const Ran monitor = run({"emit", "monitor", "-q", folder / "half.rct", "--out", folder / "out"});
    EXPECT_EQ(monitor.exit, 2);
    EXPECT_THAT(monitor.err, HasSubstr("RC-N01"));
    const Ran broken = run({"rules", "-q", folder / "half.sleec", folder / "half.rct"});
    EXPECT_EQ(broken.exit, 2);
    EXPECT_THAT(broken.err, HasSubstr("RC-N01"));
}

}  // namespace
}  // namespace robochart::app::testing::quiet_test
