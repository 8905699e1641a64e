// Seeded faults of the generator: every mutant is found to differ, or is equivalent for a reason written here.
// RoboTool's kinds are those that its own generators were seen to have (event eaten under a false guard, children not
// exited, composite resumed, input not awaited).
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/conformance/bench.hpp"

namespace robochart::conformance {
namespace {

using cpp_emit::Fault;
using testing::UnorderedElementsAre;

struct Named {
    Fault fault;
    const char* name;
};
constexpr Named all_faults[] = {
    {Fault::guard_after_consume, "guard_after_consume"},
    {Fault::children_not_exited, "children_not_exited"},
    {Fault::composite_resumed, "composite_resumed"},
    {Fault::input_not_awaited, "input_not_awaited"},
    {Fault::single_transition_step, "single_transition_step"},
    {Fault::guard_negated, "guard_negated"},
    {Fault::guard_dropped, "guard_dropped"},
    {Fault::clock_not_reset, "clock_not_reset"},
    {Fault::clock_off_by_one, "clock_off_by_one"},
    {Fault::wrong_target, "wrong_target"},
    {Fault::action_dropped, "action_dropped"},
    {Fault::entry_dropped, "entry_dropped"},
    {Fault::exit_dropped, "exit_dropped"},
    {Fault::argument_swapped, "argument_swapped"},
    {Fault::assignment_dropped, "assignment_dropped"},
    {Fault::event_kept, "event_kept"},
    {Fault::wait_dropped, "wait_dropped"},
    {Fault::trigger_value_old, "trigger_value_old"},
    {Fault::output_repeated, "output_repeated"},
    {Fault::send_not_awaited, "send_not_awaited"},
    {Fault::offer_kept, "offer_kept"},
    {Fault::buffer_kept, "buffer_kept"},
    {Fault::buffer_first, "buffer_first"},
    {Fault::ended_by_one, "ended_by_one"},
    {Fault::write_not_relayed, "write_not_relayed"},
};

/// A mutant that behaves as the original, and why.
struct Equivalent {
    Fault fault;
    std::uint32_t site;
    const char* why;
};

std::set<std::string> kill_all(test::Bench& bench, const std::vector<Equivalent>& equivalents) {
    std::set<std::string> killed;
    for (const Named& named : all_faults) {
        const std::uint32_t sites = bench.sites(named.fault);
        for (std::uint32_t site = 0; site < sites; ++site) {
            const char* why = nullptr;
            for (const Equivalent& equivalent : equivalents) {
                if (equivalent.fault == named.fault && equivalent.site == site) why = equivalent.why;
            }
            const Result result = bench.check(named.fault, site);
            EXPECT_EQ(result.outcome, why == nullptr ? Outcome::differs : Outcome::conforms)
                << named.name << " at " << site << ": " << result.reason << (why == nullptr ? "" : why);
            if (result.outcome == Outcome::differs) killed.insert(named.name);
            fmt::print("{:24} {:2}  {}  {} cycles  {}\n", named.name, site,
                       result.outcome == Outcome::differs ? "killed    " : "equivalent", result.cycles.size(),
                       result.reason);
        }
    }
    return killed;
}

const Equivalent one_transition_a_cycle{
    Fault::single_transition_step, 0,
    "Every entry action takes a cycle, so no cycle has two transitions of the machine."};

TEST(Mutants, Aggregation) {
    test::Model model("corpus/aggregation");
    test::Bench bench(model, model.module());
    ASSERT_EQ(bench.check().outcome, Outcome::conforms);
    EXPECT_THAT(kill_all(bench, {one_transition_a_cycle}),
                UnorderedElementsAre("wrong_target", "entry_dropped", "argument_swapped", "assignment_dropped",
                                     "event_kept", "wait_dropped"));
}

TEST(Mutants, SwarmTaxis) {
    test::Model model("corpus/swarm_taxis");
    test::Bench bench(model, model.module());
    ASSERT_EQ(bench.check().outcome, Outcome::conforms);
    const char* const after_t2 = "t3 is tried after t2, which fires whenever t3's guard is false.";
    const char* const has_turned = "Turn ends with reached = true and nothing else writes it: the guard is true here.";
    const char* const reset_later = "T is not read before t4 or t5 resets it.";
    const std::vector<Equivalent> equivalents{
        one_transition_a_cycle,
        {Fault::guard_after_consume, 1, after_t2},
        {Fault::guard_dropped, 2, after_t2},
        {Fault::guard_dropped, 3, has_turned},
        {Fault::guard_dropped, 4, has_turned},
        {Fault::clock_not_reset, 0, "Clocks start at 0, and t0 fires before time passes."},
        {Fault::clock_not_reset, 1, reset_later},
        {Fault::clock_not_reset, 2, reset_later},
        {Fault::clock_off_by_one, 1, reset_later},
        {Fault::clock_off_by_one, 2, reset_later},
        {Fault::trigger_value_old, 0, "The guard of t3 does not read the trigger's variable."},
    };
    EXPECT_THAT(kill_all(bench, equivalents),
                UnorderedElementsAre("guard_after_consume", "input_not_awaited", "guard_negated", "guard_dropped",
                                     "clock_not_reset", "clock_off_by_one", "wrong_target", "action_dropped",
                                     "entry_dropped", "assignment_dropped", "event_kept", "wait_dropped"));
}

TEST(Mutants, Nested) {
    test::Model model("tests/conformance/models/nested");
    test::Bench bench(model, model.module());
    ASSERT_EQ(bench.check().outcome, Outcome::conforms);
    const std::vector<Equivalent> equivalents{
        {Fault::guard_after_consume, 1, "t2 is the last to want `level`: eaten or lost at the end of the cycle."},
        {Fault::wrong_target, 3, "u2 goes to Idle, which Pause is left for at once and without an action."},
    };
    EXPECT_THAT(kill_all(bench, equivalents),
                UnorderedElementsAre("guard_after_consume", "children_not_exited", "composite_resumed",
                                     "single_transition_step", "guard_negated", "guard_dropped", "wrong_target",
                                     "entry_dropped", "exit_dropped", "argument_swapped", "event_kept", "wait_dropped",
                                     "trigger_value_old"));
}

TEST(Mutants, Team) {
    test::Model model("tests/conformance/models/team");
    test::Bench bench(model, model.module());
    ASSERT_EQ(bench.check().outcome, Outcome::conforms);
    const char* const after_t1 = "Worker's t2 is tried after t1, which takes every task whose value is above 0.";
    const std::vector<Equivalent> equivalents{
        {Fault::guard_after_consume, 1, after_t1},
        {Fault::guard_dropped, 1, after_t1},
    };
    EXPECT_THAT(kill_all(bench, equivalents),
                UnorderedElementsAre("guard_after_consume", "single_transition_step", "guard_negated", "guard_dropped",
                                     "wrong_target", "action_dropped", "entry_dropped", "argument_swapped",
                                     "assignment_dropped", "event_kept", "wait_dropped", "trigger_value_old",
                                     "send_not_awaited", "offer_kept", "buffer_kept", "buffer_first", "ended_by_one",
                                     "write_not_relayed"));
}

TEST(Mutants, Parcels) {
    test::Model model("tests/conformance/models/parcels");
    test::Bench bench(model, model.module());
    const Result result = bench.check();
    ASSERT_EQ(result.outcome, Outcome::conforms) << result.reason;
    const std::vector<Equivalent> equivalents{
        {Fault::guard_after_consume, 0, "Idle wants `order` in t1 only: eaten, or lost at the end of the cycle."},
        {Fault::guard_after_consume, 2, "t3 is the last to want `job`: eaten, or lost at the end of the cycle."},
    };
    EXPECT_THAT(kill_all(bench, equivalents),
                UnorderedElementsAre("action_dropped", "assignment_dropped", "entry_dropped", "event_kept",
                                     "guard_after_consume", "guard_dropped", "guard_negated", "single_transition_step",
                                     "trigger_value_old", "wait_dropped", "wrong_target"));
}

}  // namespace
}  // namespace robochart::conformance
