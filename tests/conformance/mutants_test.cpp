// Seeded faults of the generator: every mutant is found to differ, or is equivalent for a reason written here.
// RoboTool's kinds are those that its own generators were seen to have (event eaten under a false guard, children not
// exited, composite resumed, input not awaited).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/conformance/bench.hpp"

namespace robochart::conformance {
namespace {

using cpp_emit::Fault;

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

TEST(Mutants, Aggregation) {
    test::Model model("corpus/aggregation");
    test::Bench bench(model, model.module());
    ASSERT_EQ(bench.check().outcome, Outcome::conforms);
    kill_all(bench, {});
}

TEST(Mutants, SwarmTaxis) {
    test::Model model("corpus/swarm_taxis");
    test::Bench bench(model, model.module());
    ASSERT_EQ(bench.check().outcome, Outcome::conforms);
    kill_all(bench, {});
}

TEST(Mutants, Nested) {
    test::Model model("tests/conformance/models/nested");
    test::Bench bench(model, model.module());
    ASSERT_EQ(bench.check().outcome, Outcome::conforms);
    kill_all(bench, {});
}

}  // namespace
}  // namespace robochart::conformance
