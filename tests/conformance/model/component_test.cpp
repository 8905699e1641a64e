// SPDX-License-Identifier: Apache-2.0
// Tests data about one component that are derived from the IR and the script.
#include "conformance/model/component.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "tests/conformance/bench.hpp"

namespace robochart::conformance {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// The operations write these variables, and no expression reads them.
TEST(Component, UnreadVariablesOfAggregation) {
    test::Model model("corpus/aggregation");
    EXPECT_THAT(unread_variables(model.system, model.machine_named("AggregationFSM")),
                testing::UnorderedElementsAre("linearSpeed", "angularSpeed"));
    EXPECT_THAT(unread_variables(model.system, model.first_module()), IsEmpty());
}

// An operation that the controller defines reads `illuminated`. If the machine is checked alone, the checker does not
// know this operation.
TEST(Component, UnreadVariablesDependOnTheContext) {
    test::Model model("corpus/swarm_taxis");
    EXPECT_THAT(unread_variables(model.system, model.machine_named("SwarmTaxisFSM")),
                testing::UnorderedElementsAre("avoidanceRadius", "illuminated"));
    EXPECT_THAT(unread_variables(model.system, model.first_controller()), ElementsAre("avoidanceRadius"));
}

TEST(Component, CarriersComeFromTheModelsTypes) {
    test::Model model("corpus/swarm_taxis");
    test::Bench bench(model, model.first_module());
    const Interface interface = bench.interface();
    EXPECT_EQ(interface.component, "swarm_taxis::SwarmTaxis");
    std::map<std::string, Carrier::Kind> kinds;
    for (const Register& input : interface.inputs) kinds[input.name] = input.carrier.kind;
    EXPECT_EQ(kinds["heading.in"], Carrier::Kind::real);
    EXPECT_EQ(kinds["illumination.in"], Carrier::Kind::boolean);
    EXPECT_EQ(interface.inputs.size(), 4U);
    EXPECT_THAT(interface.blocked, IsEmpty());
}

cspm::Script script_of(const std::string& text) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics found;
    cspm::Script script = cspm::read(sources, sources.add("a.csp", text), found);
    EXPECT_TRUE(found.ok());
    return script;
}

TEST(Component, ProcessTakesItsConstantsFromGlobalDefinitions) {
    const std::string module =
        "module P\nexports\nmodule S\nexports\nD__(id__, const_P_S_c) = STOP\nendmodule\nendmodule\n";
    const ir::ComponentRef ref{ir::ComponentKind::machine, "S", "P", 0};
    const cspm::ExprPtr process = component_process(script_of(module + "const_P_S_c = 3\n"), ref);
    ASSERT_TRUE(process);
    EXPECT_EQ(cspm::print(process), "P::S::D__(0, const_P_S_c)");
    EXPECT_FALSE(component_process(script_of(module), ref));
    EXPECT_FALSE(component_process(script_of("channel c"), ref));
}

}  // namespace
}  // namespace robochart::conformance
