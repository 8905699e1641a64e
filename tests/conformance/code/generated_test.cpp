// SPDX-License-Identifier: Apache-2.0
// Checks generated code against models that were written by hand from the semantics, so that the expectation does not
// come from csp_emit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "conformance/check/conformance_check.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "tests/conformance/support.hpp"
#include "tests/semantics/sample_systems/sample_systems.hpp"

namespace robochart::conformance {
namespace {

/// Returns the module of corpus/aggregation by semantics 3.8 to 3.10. Each operation makes its assignments in order and
/// then takes one time unit. The transitions wait for their inputs. Speeds are in hundredths.
std::vector<test::Edge> aggregation_model() {
    const std::string p = "aggregation::Aggregation::";
    return {
        {0, p + "set_angularSpeed.-75", 1},
        {1, p + "set_linearSpeed.-1088", 2},
        {2, "tock", 3},
        {3, p + "seeRobot.in", 4},
        {3, "tock", 3},
        {4, p + "set_angularSpeed.-502", 5},
        {5, p + "set_linearSpeed.0", 6},
        {6, "tock", 7},
        {7, p + "seeWall.in", 0},
        {7, "tock", 7},
    };
}

Result judge_aggregation(cpp_emit::Fault fault) {
    const ir::System system = ir::samples::aggregation();
    diagnostics::Diagnostics found;
    const ir::Instantiation instantiation = ir::instantiate_system(system, {}, found);
    cpp_emit::Options options;
    options.fault = fault;
    const ir::ComponentRef module{ir::ComponentKind::module, "Aggregation", "aggregation", 0};
    const cpp_emit::Emission code = cpp_emit::emit(system, instantiation, module, options, found);
    EXPECT_TRUE(found.ok());
    std::string error;
    const auto object = test::compile_quietly(code, error);
    EXPECT_TRUE(object) << error;
    if (!object) return {};
    Interface interface = interface_of(object->interface());
    interface.component = "aggregation::Aggregation";
    process::EventTable events;
    test::GraphSystem model(aggregation_model(), events);
    return judge_component(model, events, interface, object->interface(), 1, {});
}

TEST(Generated, AggregationConforms) {
    const Result result = judge_aggregation(cpp_emit::Fault::none);
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
    EXPECT_THAT(result.warnings, testing::IsEmpty());
}

TEST(Generated, FaultsAreFound) {
    for (const cpp_emit::Fault fault : {cpp_emit::Fault::wait_dropped, cpp_emit::Fault::argument_swapped})
        EXPECT_EQ(judge_aggregation(fault).outcome, Outcome::differs) << static_cast<int>(fault);
}

}  // namespace
}  // namespace robochart::conformance
