// SPDX-License-Identifier: Apache-2.0
// Tests that one missing declaration causes one error. Elements that depend on it cause no further errors.
#include <gtest/gtest.h>

#include "tests/frontend/fixture.hpp"

namespace robochart::frontend {
namespace {

using testing::resolved;

const std::string interfaces =
    "interface Signals { event go event stop event back }\n"
    "interface Calls { walk() turn() }\n"
    "interface Data { var speed : nat var height : nat }\n"
    "robotic platform R { uses Signals provides Calls provides Data }\n";

/// Returns a project in which a machine with these clauses uses all declarations, with a controller and a module.
std::string project(const std::string& machine,
                    const std::string& controller = "uses Signals requires Calls requires Data",
                    const std::string& platform = interfaces) {
    return platform + "stm S { " + machine +
           "\n var own : nat initial i state A { entry walk(); turn() } state B { entry own = speed + height }\n"
           "transition t { from i to A }\n"
           "transition u { from A to B trigger go action walk(); back }\n"
           "transition v { from B to A trigger stop }\n}\n"
           "controller C { " +
           controller +
           " sref s = S\n"
           "connection C on go to s on go connection C on stop to s on stop connection s on back to C on back }\n"
           "module M { rref r = R cref c = C\n"
           "connection r on go to c on go ( _async ) connection r on stop to c on stop ( _async )\n"
           "connection c on back to r on back ( _async ) }\n";
}

std::size_t errors(const std::string& text, std::string& report) {
    const auto reading = resolved(text);
    report = reading->report();
    return reading->findings.error_count();
}

TEST(Missing, NothingIsMissing) {
    std::string report;
    EXPECT_EQ(errors(project("uses Signals requires Calls requires Data"), report), 0U) << report;
}

TEST(Missing, AForgottenClauseIsOneError) {
    std::string report;
    EXPECT_EQ(errors(project("requires Calls requires Data"), report), 1U) << report;
    EXPECT_NE(report.find("interface `Signals` declares `go`; `uses Signals` makes its declarations visible"),
              std::string::npos)
        << report;
    EXPECT_EQ(errors(project("uses Signals requires Data"), report), 1U) << report;
    EXPECT_NE(report.find("`requires Calls`"), std::string::npos) << report;
    EXPECT_EQ(errors(project("uses Signals requires Calls"), report), 1U) << report;
    EXPECT_NE(report.find("`requires Data`"), std::string::npos) << report;
}

/// The controller itself does not use the event, so only one of the connections is reported.
TEST(Missing, AForgottenClauseOfAControllerIsOneError) {
    std::string report;
    EXPECT_EQ(errors(project("uses Signals requires Calls requires Data", "requires Calls requires Data"), report), 1U)
        << report;
    EXPECT_NE(report.find("Cn10"), std::string::npos) << report;
    EXPECT_NE(report.find("`uses Signals` in `C`"), std::string::npos) << report;
}

TEST(Missing, AnUnknownInterfaceIsOneError) {
    std::string report;
    for (const char* machine : {"uses Signal requires Calls requires Data", "uses Signals requires Cals requires Data",
                                "uses Signals requires Calls requires Dta"}) {
        EXPECT_EQ(errors(project(machine), report), 1U) << report;
        EXPECT_NE(report.find("there is no interface"), std::string::npos) << report;
    }
    const std::string all = "uses Signals requires Calls requires Data";
    EXPECT_EQ(errors(project(all, "uses Signal requires Calls requires Data"), report), 1U) << report;
    EXPECT_EQ(errors(project(all, "uses Signals requires Cals requires Data"), report), 1U) << report;
    std::string platform = interfaces;
    platform.replace(platform.find("provides Calls"), 14, "provides Cals");
    EXPECT_EQ(errors(project(all, all, platform), report), 1U) << report;
}

TEST(Missing, TwoThingsAreTwoErrors) {
    std::string report;
    EXPECT_EQ(errors(project("requires Data"), report), 2U) << report;
    EXPECT_EQ(errors(project("uses Signals requires Calls requires Data"
                             " transition w { from A to B trigger nowhere condition missing > 1 }"),
                     report),
              2U)
        << report;
}

TEST(Missing, AnImportThatBringsNothingIsOneErrorAndAWarning) {
    const auto reading = resolved("package p import q::* interface I { var a : T var b : U const c : V }");
    EXPECT_EQ(reading->findings.error_count(), 1U) << reading->report();
    EXPECT_NE(reading->report().find("there is no package `q`, which the file imports"), std::string::npos)
        << reading->report();
    // Without the import, each of the names causes an error.
    EXPECT_EQ(resolved("package p interface I { var a : T var b : U const c : V }")->findings.error_count(), 3U);
}

TEST(Missing, TypesOfOneNameAreDistinguished) {
    auto reading = std::make_unique<testing::Reading>();
    const auto add = [&](const char* path, const char* text) {
        const auto source = reading->sources.add(path, text);
        reading->model.files.push_back(parse(reading->sources, source, false, reading->findings));
    };
    add("a.rct", "package left enumeration Side { near far } interface I { move(s : Side) }");
    add("b.rct",
        "package right import left::* enumeration Side { near far } stm S { requires I initial i state A { entry "
        "move(Side::near) } transition t { from i to A } }");
    resolve(reading->model, reading->findings);
    EXPECT_NE(reading->report().find("must be left::Side, but this is right::Side"), std::string::npos)
        << reading->report();
}

}  // namespace
}  // namespace robochart::frontend
