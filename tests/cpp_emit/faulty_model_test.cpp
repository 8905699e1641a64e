// SPDX-License-Identifier: Apache-2.0
// Tests seeded faults that the IR can express. Each fault changes the machine as described and nothing else. The
// expected texts follow from the descriptions in all_faults() and from the form of `--print ir`.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "cpp_emit/faults/code_faults.hpp"
#include "cpp_emit/faults/faulty_model.hpp"
#include "cpp_emit/plan/resolve_component.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/ir/dump.hpp"
#include "tests/cpp_emit/models.hpp"

namespace robochart::cpp_emit::faulty_model_test {
namespace {

const char* const model = R"(
package p
interface I { op(a : nat, b : nat) tell(v : nat) }
stm M {
    requires I clock T
    event a : nat event x : nat var v : nat = 1 var w : nat = 2
    initial i
    state A { entry v = w + 3 ; wait(4) ; x!v exit op(5, w) }
    state B { entry if v > 6 then tell(7) else tell(8) end }
    transition t0 { from i to A }
    transition t1 { from A to B trigger a?v # T condition v > 9 action tell(10) }
    transition t2 { from B to A condition since(T) >= 2 }
}
)";

class FaultyModels : public ::testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(component_); }

    /// Returns the text of the model with a fault.
    std::string faulty_text(Fault fault, std::uint32_t site) {
        Mutation mutation(fault, site);
        const FaultyModel faulty(system_, inst_, *component_, mutation);
        sites_ = mutation.site_count();
        initials_ = faulty.component().root_unit().initials;
        ir::System changed = faulty.system();
        changed.machines.front() = *faulty.component().root_unit().machine;
        return ir::dump_text(changed);
    }

    ir::System system_ = testing::load_model(model);
    diagnostics::Diagnostics diagnostics_;
    ir::Instantiation inst_ = ir::instantiate_system(system_, {}, diagnostics_);
    std::optional<Component> component_ =
        resolve_component(system_, inst_, testing::component_named(system_, "M"), diagnostics_);
    std::uint32_t sites_ = 0;
    std::vector<ir::Value> initials_;
};

TEST_F(FaultyModels, WithoutFaultAreTheModelItself) {
    Mutation none(Fault::none, 0);
    const FaultyModel same(system_, inst_, *component_, none);
    EXPECT_EQ(&same.system(), &system_);
    EXPECT_EQ(&same.component(), &*component_);
    EXPECT_EQ(none.site_count(), 0U);
}

TEST_F(FaultyModels, AreTheModelBeyondTheLastSite) {
    const std::string right = ir::dump_text(system_);
    for (const FaultKind& kind : all_faults()) EXPECT_EQ(faulty_text(kind.fault, 0xffffffffU), right) << kind.name;
}

TEST_F(FaultyModels, DifferAtEverySite) {
    std::set<Fault> expressed;
    for (const FaultKind& kind : all_faults()) {
        if (kind.fault == Fault::initial_lost) continue;
        std::set<std::string> texts = {ir::dump_text(system_)};
        (void)faulty_text(kind.fault, 0xffffffffU);
        const std::uint32_t sites = sites_;
        if (sites > 0) expressed.insert(kind.fault);
        for (std::uint32_t site = 0; site < sites; ++site)
            EXPECT_TRUE(texts.insert(faulty_text(kind.fault, site)).second) << kind.name << " at " << site;
    }
    EXPECT_GE(expressed.size(), 20U);
}

TEST_F(FaultyModels, HaveTheFaultInTheirText) {
    struct Expected {
        Fault fault;
        std::uint32_t site;
        const char* text;  ///< a line that the original model does not have
    };
    const Expected all[] = {
        {Fault::guard_negated, 0, "not ((received > 9))"},
        {Fault::trigger_value_old, 0, "(v > 9)"},
        {Fault::arithmetic_wrong, 0, "v = (w - 3)"},
        {Fault::comparison_wrong, 0, "(v >= 6)"},
        {Fault::literal_wrong, 0, "v = (w + 2)"},
        {Fault::argument_swapped, 0, "call op(w, 5)"},
        {Fault::wait_early, 0, "wait 3"},
        {Fault::wait_late, 0, "wait 1"},
    };
    const std::string right = ir::dump_text(system_);
    for (const Expected& expected : all) {
        EXPECT_EQ(right.find(expected.text), std::string::npos) << expected.text;
        EXPECT_NE(faulty_text(expected.fault, expected.site).find(expected.text), std::string::npos)
            << expected.text << " in\n"
            << faulty_text(expected.fault, expected.site);
    }
    const Expected gone[] = {
        {Fault::guard_dropped, 0, "(received > 9)"}, {Fault::entry_dropped, 0, "v = (w + 3)"},
        {Fault::exit_dropped, 0, "call op"},         {Fault::action_dropped, 0, "call tell(10)"},
        {Fault::wait_dropped, 0, "wait 4"},          {Fault::assignment_dropped, 0, "v = (w + 3)"}};
    for (const Expected& expected : gone) {
        EXPECT_NE(right.find(expected.text), std::string::npos) << expected.text << " in\n" << right;
        EXPECT_EQ(faulty_text(expected.fault, expected.site).find(expected.text), std::string::npos) << expected.text;
    }
}

TEST_F(FaultyModels, BeginWithTheDefaultOfAType) {
    (void)faulty_text(Fault::none, 0);
    const std::vector<ir::Value> right = initials_;
    (void)faulty_text(Fault::initial_lost, 0);
    EXPECT_EQ(sites_, 2U);  // v and w
}

/// Lines of the class Step as the generator writes them.
const char* const code = R"(class Step {
    bool transition(Frame& f) noexcept {
        switch (f.at) {
            case At::A: return from_A(f) || from_B(f) || from_C(f);
        }
    }
    void advance(Frame& f) noexcept {
        advance_clock(f.T, cycle_length, 3);
    }
    robochart::StepResult dispatch(Event event) noexcept {
        event = nothing;
    }
};
)";

std::string code_with(Fault fault) {
    Mutation mutation(fault, 0);
    return faulty_code(code, mutation);
}

TEST(FaultyCode, ChangesOneLine) {
    const std::string right = code;
    EXPECT_EQ(code_with(Fault::none), right);
    EXPECT_EQ(code_with(Fault::guard_negated), right) << "none of lines";
    EXPECT_NE(code_with(Fault::outer_first).find("return from_C(f) || from_B(f) || from_A(f);"), std::string::npos);
    EXPECT_NE(code_with(Fault::clock_saturated).find("cycle_length, 3 - 1);"), std::string::npos);
    EXPECT_NE(code_with(Fault::clock_twice).find("3); advance_clock(f.T, cycle_length, 3);\n"), std::string::npos);
    EXPECT_EQ(code_with(Fault::clock_stopped).find("advance_clock"), std::string::npos);
    EXPECT_EQ(code_with(Fault::dispatch_event_kept).find("event = nothing"), std::string::npos);
    Mutation beyond(Fault::clock_stopped, 1);
    EXPECT_EQ(faulty_code(code, beyond), right);
    EXPECT_EQ(beyond.site_count(), 1U);
}

}  // namespace
}  // namespace robochart::cpp_emit::faulty_model_test
