// SPDX-License-Identifier: Apache-2.0
#include "robosim_examples.hpp"

#include <string>

namespace robochart::testing {
namespace {

/// Returns a machine with these declarations.
std::string machine(const std::string& declarations, const std::string& first_line = "stm S {") {
    return first_line + "\n" + declarations + R"(
	initial i
	state A { }
	transition t0 { from i to A }
	transition t1 { from A to A exec }
}
)";
}

const std::string contexts = "\tinput context { }\n\toutput context { }";

const diagnostics::Block blink{"robochart", "blink.rct", R"(package M
stm Blink {
	event lit
	initial i
	state A { entry lit }
	transition t0 { from i to A }
}
)"};

diagnostics::Block model(const std::string& text) {
    return {"robosim", "", text};
}

}  // namespace

std::vector<std::vector<diagnostics::Block>> robosim_examples() {
    const std::string cycle = "\tcycleDef cycle == 1\n";
    return {
        {model(R"(controller C {
	cycleDef cycle == 1
	input context { }  // expect: RC-Y01
	sref S_ref = S
}
)" + machine(cycle + contexts))},
        {model("interface Effects { event done var speed : real }\n" +
               machine(cycle + "\tinput context { }\n\toutput context { uses Effects }  // expect: RC-Y02"))},
        {model("interface Measures { var distance : real }\n" +
               machine(cycle + "\tvar d : real\n\tinput context { requires Measures }\n\toutput context { }\n" +
                       "\ttransition t2 { from A to A exec condition $distance?d }  // expect: RC-Y04"))},
        {model("interface I { const n : nat = $m }  // expect: RC-Y05\n")},
        {model(machine("\tconst LENGTH : nat\n\tcycleDef cycle == LENGTH  // expect: RC-Y07\n" + contexts))},
        {model(machine(contexts, "stm S {  // expect: RC-Y07"))},
        {model(R"(interface Senses { event seen }
controller C {
	cycleDef cycle == 1
	sref S_ref = S  // expect: RC-W01
}
)" + machine(cycle + "\tinput context { uses Senses }\n\toutput context { }\n" +
             "\ttransition t2 { from A to A exec condition $seen }"))},
        {model(machine(cycle + contexts)),
         {"robosim-assertions", "", "simulation N of S { cycleDef cycle == 1 }  // expect: RC-Y10\n"}},
        {model(machine(cycle + contexts)),
         {"robosim-assertions", "", "assertion A0 : S is schedulable  // expect: RC-Y10\n"}},
        {blink, {"robosim-assertions", "", R"(simulation N of M::Blink {  // expect: RC-Y10
	cycleDef cycle == 1
	input context { }
	output context { event lit }
}
csp N csp-begin
N = SKIP
csp-end
)"}},
        {{"robochart", "blink.rct", R"(package M
stm Blink {  // expect: RC-E01
	event lit
	initial i
	state A { entry lit }
	transition t0 { from i to A }
}
)"},
         model(machine(cycle + contexts, "stm S {  // expect: RC-S26")),
         {"console", "", "$ robochart-verify emit prism MODEL"}},
        {model(machine(cycle + contexts, "stm S {  // expect: RC-S26")),
         {"console", "", "$ robochart-verify emit prism MODEL"}},
    };
}

}  // namespace robochart::testing
