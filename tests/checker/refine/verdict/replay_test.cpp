// SPDX-License-Identifier: Apache-2.0
// Tests that the replay detects a checker that reports a wrong counterexample.
#include "checker/refine/verdict/replay.hpp"
#include "checker/process/term_system.hpp"

#include <gtest/gtest.h>

#include "tests/checker/process/scripted.hpp"

namespace robochart::refine {
namespace {

using process::Op;
using process::Scripted;
using process::TermId;

class Replay : public testing::Test {
protected:
    Scripted s;
    process::OperationalSemantics semantics{s.store};
    Limits limits;
    Budget budget{limits};
    TermId stop = s.stop();
    TermId a = s.prefix("a", stop);
    TermId ab = s.menu({{"a", stop}, {"b", stop}});

    refine::Run run(TermId from, const std::vector<std::pair<std::string, TermId>>& steps) {
        refine::Run result{{static_cast<lts::Word>(from)}, {}};
        for (const auto& [name, target] : steps)
            result.steps.push_back({s.event(name), s.event(name), {static_cast<lts::Word>(target)}});
        return result;
    }
    void confirm_replay(TermId specification, TermId implementation, Model model, const Violation& violation) {
        process::TermSystem left(semantics, specification);
        process::TermSystem right(semantics, implementation);
        confirm_refinement_violation(left, right, model, violation, budget);
    }
    void confirm_replay(TermId process, const Violation& violation) {
        process::TermSystem system(semantics, process);
        confirm_property_violation(system, violation, budget);
    }
};

TEST_F(Replay, AcceptsWhatIsTrue) {
    EXPECT_NO_THROW(confirm_replay(a, ab, Model::traces, {ViolationKind::trace, run(ab, {{"b", stop}}), {}, {}}));
    EXPECT_NO_THROW(confirm_replay(ab, a, Model::failures, {ViolationKind::refusal, run(a, {}), {}, {}}));
    EXPECT_NO_THROW(confirm_replay(a, {ViolationKind::deadlock, run(a, {{"a", stop}}), {}, {}}));
}

TEST_F(Replay, RejectsRunsThatDoNotExist) {
    EXPECT_THROW(confirm_replay(a, ab, Model::traces, {ViolationKind::trace, run(a, {{"a", stop}}), {}, {}}),
                 std::logic_error);
    EXPECT_THROW(confirm_replay(a, ab, Model::traces, {ViolationKind::trace, run(ab, {{"c", stop}}), {}, {}}),
                 std::logic_error);
    EXPECT_THROW(confirm_replay(a, ab, Model::traces, {ViolationKind::trace, run(ab, {{"b", a}}), {}, {}}),
                 std::logic_error);
}

TEST_F(Replay, RejectsViolationsThatAreNone) {
    EXPECT_THROW(confirm_replay(ab, ab, Model::traces, {ViolationKind::trace, run(ab, {{"b", stop}}), {}, {}}),
                 std::logic_error);
    EXPECT_THROW(confirm_replay(a, ab, Model::failures, {ViolationKind::refusal, run(ab, {}), {}, {}}),
                 std::logic_error);
    EXPECT_THROW(confirm_replay(ab, a, Model::traces, {ViolationKind::refusal, run(a, {}), {}, {}}), std::logic_error);
    EXPECT_THROW(confirm_replay(a, {ViolationKind::deadlock, run(a, {}), {}, {}}), std::logic_error);
    EXPECT_THROW(confirm_replay(a, {ViolationKind::divergence, run(a, {}), {}, {}}), std::logic_error);
    EXPECT_THROW(confirm_replay(a, {ViolationKind::nondeterminism, run(a, {}), {}, s.event("a")}), std::logic_error);
    const TermId div = s.op(Op::div);
    EXPECT_THROW(
        confirm_replay(div, ab, Model::failures_divergences, {ViolationKind::trace, run(ab, {{"b", stop}}), {}, {}}),
        std::logic_error);
    process::TermSystem system(semantics, ab);
    EXPECT_THROW(confirm_missing_trace(system, {s.event("a")}, run(ab, {}), budget), std::logic_error);
    EXPECT_THROW(confirm_trace(system, {s.event("b")}, run(ab, {{"a", stop}}), budget), std::logic_error);
}

}  // namespace
}  // namespace robochart::refine
