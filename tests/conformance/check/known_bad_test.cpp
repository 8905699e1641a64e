// SPDX-License-Identifier: Apache-2.0
// Tests the checkers with pairs of a model and a controller. A faulty controller must be reported, and a correct one
// must conform, whatever was checked before. All controllers are loaded at once: if they shared symbols (g++'s default
// for inline variables), every comparison would report equality.
#include <gtest/gtest.h>

#include <map>

#include "conformance/check/conformance_check.hpp"
#include "conformance/check/random_walk.hpp"
#include "tests/conformance/support.hpp"

namespace robochart::conformance {
namespace {

/// In objects/turner.cpp, each of these values of FAULT changes an output, the end of a cycle, or termination.
constexpr int bad[] = {1, 2, 3, 4, 5, 6, 7, 11};

class Loaded {
public:
    const rc_interface& operator[](int fault) {
        auto& object = objects_[fault];
        if (object == nullptr) object = test::hand_made("turner", fault, error_);
        EXPECT_NE(object, nullptr) << error_;
        return object->interface();
    }

private:
    std::map<int, std::unique_ptr<SharedObject>> objects_;
    std::string error_;
};

Outcome outcome_of_check(const rc_interface& code) {
    process::EventTable events;
    test::GraphSystem model(test::turner_model(), events);
    return judge_component(model, events, test::turner_interface(), code, 1, {}).outcome;
}

Outcome outcome_of_walk(const rc_interface& code) {
    process::EventTable events;
    test::GraphSystem model(test::turner_model(), events);
    const Alphabet alphabet(test::turner_interface(), events);
    return run_random_walks(model, alphabet, code, 1, {}, WalkOptions{5'000, 10, 3}).outcome;
}

TEST(KnownBad, PairsAreReportedBadInAnyOrder) {
    Loaded loaded;
    for (const int fault : bad) (void)loaded[fault];
    for (const int fault : bad) {
        EXPECT_EQ(outcome_of_check(loaded[0]), Outcome::conforms) << "before " << fault;
        EXPECT_EQ(outcome_of_check(loaded[fault]), Outcome::differs) << fault;
        EXPECT_EQ(outcome_of_walk(loaded[0]), Outcome::inconclusive) << "before " << fault;
        EXPECT_EQ(outcome_of_walk(loaded[fault]), Outcome::differs) << fault;
    }
}

/// This model allows less, so a controller that conforms to the other model becomes faulty.
TEST(KnownBad, ASmallerModelFindsTheRightControllerWrong) {
    Loaded loaded;
    auto edges = test::turner_model();
    std::erase_if(edges, [](const test::Edge& edge) { return edge.event == "T::TurnCall"; });
    edges.push_back({3, "T::DriveCall.2", 4});
    process::EventTable events;
    test::GraphSystem model(edges, events);
    EXPECT_EQ(judge_component(model, events, test::turner_interface(), loaded[0], 1, {}).outcome, Outcome::differs);
}

}  // namespace
}  // namespace robochart::conformance
