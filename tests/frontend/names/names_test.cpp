// SPDX-License-Identifier: Apache-2.0
// Tests names: duplicate declarations, paths through references to a component, and unknown names. Each is reported
// once.
#include <gtest/gtest.h>

#include "frontend/syntax/parse.hpp"
#include "tests/frontend/fixture.hpp"

namespace robochart::frontend {
namespace {

using testing::resolved;

/// Returns "line: message" of each note of the only finding.
std::string notes(const testing::Reading& reading) {
    std::string out;
    const diagnostics::Diagnostic finding = reading.findings.sorted_findings().front();
    for (const diagnostics::Note& note : finding.notes) {
        const bool known = note.span.is_known();
        const std::uint32_t line = known ? reading.sources.position(note.span.source, note.span.begin).line : 0;
        out += std::to_string(line) + ": " + note.message + "\n";
    }
    return out;
}

TEST(Duplicates, AreReportedOnceWithAllPlaces) {
    const auto reading = resolved("interface I {\nevent e\nevent e\nevent f\nevent e\nevent e\n}");
    EXPECT_EQ(reading->codes(), "RC-N03@3");
    EXPECT_EQ(notes(*reading), "2: first declared here\n5: declared again here\n6: declared again here\n");
}

TEST(Duplicates, OfAThousandShowAFew) {
    std::string text = "interface I {\n";
    for (int i = 0; i < 1000; ++i) text += "event e\n";
    const auto reading = resolved(text + "}");
    EXPECT_EQ(reading->codes(), "RC-N03@3");
    EXPECT_EQ(reading->findings.sorted_findings().front().notes.size(), 8U);
    EXPECT_NE(notes(*reading).find(": and at 992 more places, the last one here"), std::string::npos)
        << notes(*reading);
}

TEST(Duplicates, OfOneKindAreReportedBesideAnotherKind) {
    // The interface and the types may share a name, but the types are duplicates of each other.
    EXPECT_EQ(resolved("interface I { event e }\ntype I\ntype I\ndatatype I { f : nat }")->codes(), "RC-N03@3");
}

TEST(Duplicates, OfCspBlocksAreReported) {
    const std::string empty = " csp-begin csp-end\n";
    const auto reading = resolved("csp A" + empty + "csp B" + empty + "csp A" + empty + "csp A" + empty, true);
    EXPECT_EQ(reading->codes(), "RC-N03@3");
    EXPECT_EQ(notes(*reading), "1: first declared here\n4: declared again here\n");
    // A timed and an untimed process never occur in the same script.
    EXPECT_EQ(resolved("timed csp A" + empty + "untimed csp A" + empty, true)->codes(), "");
    EXPECT_EQ(resolved("timed csp A" + empty + "csp A" + empty, true)->codes(), "RC-N03@2");
    EXPECT_EQ(resolved("timed csp A" + empty + "untimed csp A" + empty + "timed csp A" + empty, true)->codes(),
              "RC-N03@3");
}

// ---------------------------------------------------------------- module::ctrl_ref::stm_ref::State

constexpr const char* project = R"(package P
module M {
  robotic platform R { event e }
  cref c_ref = C
  cref d_ref = C
  connection R on e to c_ref on e (_async)
}
controller C {
  event e
  sref s_ref = S
  sref t_ref = S
  connection C on e to s_ref on e
}
stm S {
  event e clock T
  initial i
  state Outer { initial i state Inner { } transition t { from i to Inner } }
  final f
  transition t { from i to Outer trigger e #T }
}
)";

/// Returns the project and assertions about it, loaded together.
std::unique_ptr<testing::Reading> with_claims(const std::string& claims) {
    auto reading = std::make_unique<testing::Reading>();
    const auto model = reading->sources.add("p.rct", project);
    reading->model.files.push_back(parse(reading->sources, model, false, reading->findings));
    const auto id = reading->sources.add("p.assertions", claims);
    reading->model.files.push_back(parse(reading->sources, id, true, reading->findings));
    add_toolkits(reading->sources, reading->model, reading->findings);
    resolve(reading->model, reading->findings);
    return reading;
}

const Assertion& claim(const testing::Reading& reading) {
    return reading.model.files.at(1)->assertions.at(0);
}

std::string steps(const ComponentPath& path) {
    std::string out;
    for (const Declaration* step : path.steps) out += (out.empty() ? "" : "::") + step->name;
    return out;
}

bool is_about_claims(const testing::Reading& reading) {
    for (const auto& finding : reading.findings.sorted_findings())
        if (finding.rule->code.starts_with("RC-Q") || finding.rule->code.starts_with("RC-N")) return true;
    return false;
}

TEST(PathsThroughReferences, LeadToAState) {
    for (const char* name : {"M::d_ref::t_ref::Outer::Inner", "P::M::d_ref::t_ref::Outer::Inner"}) {
        const auto reading = with_claims(std::string("import P::* assertion A: ") + name + " is reachable in M::d_ref");
        EXPECT_FALSE(is_about_claims(*reading)) << reading->report();
        ASSERT_NE(claim(*reading).state, nullptr) << name;
        EXPECT_EQ(claim(*reading).state->name, "Inner");
        EXPECT_EQ(claim(*reading).state->parent->name, "Outer");
        EXPECT_EQ(steps(claim(*reading).other_path), "M::d_ref::t_ref");
        EXPECT_EQ(steps(claim(*reading).subject_path), "M::d_ref");
    }
}

TEST(PathsThroughReferences, LeadToFinalStatesAndClocksAndMachines) {
    const auto final_state = with_claims("import P::* assertion A: M::c_ref::s_ref::f is reachable in M");
    ASSERT_NE(claim(*final_state).state, nullptr) << final_state->report();
    EXPECT_EQ(claim(*final_state).state->kind, DeclKind::final);
    const auto clock = with_claims("import P::* assertion A: clock M::c_ref::t_ref::T is initialised");
    ASSERT_NE(claim(*clock).clock, nullptr) << clock->report();
    EXPECT_EQ(steps(claim(*clock).other_path), "M::c_ref::t_ref");
    const auto machine = with_claims("import P::* assertion A: M::c_ref::t_ref is deadlock-free");
    EXPECT_EQ(steps(claim(*machine).subject_path), "M::c_ref::t_ref") << machine->report();
}

TEST(PathsThroughReferences, StopAtWhatIsNotThere) {
    for (const auto& [name, code] :
         {std::pair("M::d_ref::t_ref::Outer::Innr", "RC-Q03"), std::pair("M::d_ref::t_reff::Outer", "RC-Q03"),
          std::pair("M::d_ref::t_ref::Outer::i", "RC-Q03")}) {
        const auto reading = with_claims(std::string("import P::* assertion A: ") + name + " is reachable in M::d_ref");
        EXPECT_NE(reading->codes().find(code), std::string::npos) << name << "\n" << reading->report();
        EXPECT_EQ(claim(*reading).state, nullptr);
    }
    // A state of the other instance does not belong to this one.
    const auto other = with_claims("import P::* assertion A: M::c_ref::t_ref::Outer is reachable in M::d_ref");
    EXPECT_NE(other->codes().find("RC-Q03"), std::string::npos) << other->report();
    const auto part = with_claims("import P::* assertion A: M::d_ref::t_reff is deadlock-free");
    EXPECT_NE(part->codes().find("RC-Q01"), std::string::npos) << part->report();
}

// ---------------------------------------------------------------- reported once

TEST(Findings, AboutASharedMachineAreReportedOnce) {
    std::string text =
        "interface Ops { patrol() }\noperation patrol() { initial i state W { entry wait(1) } transition t0 { from i "
        "to "
        "W } transition t1 { from W to W } }\n";
    text +=
        "stm S { requires Ops initial i\nstate s { entry patrol() }\ntransition t { from i to s } }\n"
        "controller C { opref p = patrol sref s = S sref s2 = S }\ncontroller D { opref p = patrol sref s = S }\n";
    EXPECT_EQ(resolved(text)->codes(), "RC-W13@4") << resolved(text)->report();
}

TEST(Findings, AboutAMissingTypeAreReportedOnce) {
    EXPECT_EQ(resolved("interface I { var x : }")->codes(), "RC-P01@1");
    EXPECT_EQ(resolved("interface I { var x : var y : nat }")->codes(), "RC-P01@1");
    EXPECT_EQ(resolved("interface I { var x :\nvar y : nat }")->codes(), "RC-P01@1");
    EXPECT_EQ(resolved("interface I { event e : event f }")->codes(), "RC-P01@1");
    EXPECT_EQ(resolved("interface I { var x : state }")->codes(), "RC-P11@1");
}

}  // namespace
}  // namespace robochart::frontend
