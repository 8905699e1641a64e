// SPDX-License-Identifier: Apache-2.0
// Tests priorities as guards. Each kind of guard has a process whose answers would be wrong without it. Random rules
// are compared with the same rules from which one guard is removed.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "checker/lts/graph.hpp"
#include "checker/machine/supercombinator_system.hpp"
#include "checker/refine/verdict/check.hpp"
#include "checker/symbolic/saturation.hpp"
#include "tests/checker/machine/random_rules.hpp"
#include "tests/checker/machine/rules_by_hand.hpp"
#include "tests/checker/process/scripted.hpp"

namespace robochart::symbolic {
namespace {

using machine::no_level;
using machine::Participant;
using machine::Passage;
using machine::Supercombinator;
using machine::WholeRule;
using process::Event;
using process::first_visible;

/// The answers of decision diagrams about a process.
struct DiagramAnswers {
    bool deadlock = false;
    std::vector<Event> events;  ///< that some reachable state can perform
    long double states = 0;
    friend bool operator==(const DiagramAnswers&, const DiagramAnswers&) = default;
};

DiagramAnswers answers_by(const Supercombinator& combined, const RegionRules& rules) {
    const Variables variables = make_variables(combined, rules, diagnostics::unlimited);
    Diagrams diagrams(variables.domains, {}, diagnostics::unlimited);
    Relations relations(combined, rules, variables, diagrams, diagnostics::unlimited);
    std::vector<Value> initial(variables.slot_at.size());
    for (Level level = 1; level < initial.size(); ++level) initial[level] = combined.initial[variables.slot_at[level]];
    Saturation saturation(relations, relations.steps(), diagrams, diagnostics::unlimited);
    const Level top = diagrams.levels();
    const Node reached = diagrams.keep_always(saturation.reachable(initial));
    const auto all_lack = [&](const std::vector<Step>& steps) {
        const Diagrams::Kept lowest(diagrams, relations.none_possible(steps));
        const Diagrams::Kept lacking(diagrams, diagrams.lift(lowest.get(), top));
        return diagrams.intersect(top, reached, lacking.get());
    };
    DiagramAnswers answers;
    answers.states = diagrams.count_tuples(reached);
    answers.deadlock = all_lack(relations.steps()) != nothing;
    for (std::size_t rule = 0; rule < rules.back().size(); ++rule)
        if (all_lack({relations.steps()[rule]}) != reached) answers.events.push_back(rules.back()[rule].event);
    std::ranges::sort(answers.events);
    answers.events.erase(std::unique(answers.events.begin(), answers.events.end()), answers.events.end());
    return answers;
}

/// Returns the same answers from a search of all states.
DiagramAnswers answers_by_search(const std::shared_ptr<const Supercombinator>& combined, process::Scripted& s) {
    machine::SupercombinatorSystem system(combined, s.store);
    const lts::Graph graph = lts::explore(system, [](std::size_t) {}).graph;
    DiagramAnswers answers;
    answers.states = static_cast<long double>(graph.size());
    for (lts::StateIndex state = 0; state < graph.size(); ++state) {
        if (graph.edges(state).empty()) answers.deadlock = true;
        for (const lts::Edge& edge : graph.edges(state)) answers.events.push_back(edge.event);
    }
    std::ranges::sort(answers.events);
    answers.events.erase(std::unique(answers.events.begin(), answers.events.end()), answers.events.end());
    return answers;
}

/// The kinds of guards.
enum class Guard {
    outermost,  ///< the outermost region prevents a rule of the process
    inner,      ///< an inner region prevents a rule of the process that passes through it
    nested,     ///< a region does not prevent a rule, because an inner region prevents the rule with priority
};

/// Removes the guards of this kind from a rule of a region. Returns false if there are none.
bool leave_out(Guard guard, RegionRules& rules, std::size_t region, std::size_t number) {
    const std::size_t last = rules.size() - 1;
    if ((guard == Guard::nested) != (region < last)) return false;
    const auto is_of_kind = [&](const Passage& passage) {
        if (guard == Guard::outermost) return passage.region == last;
        return passage.region < region;
    };
    return std::erase_if(rules[region][number].prevented, is_of_kind) > 0;
}

/// A process in which each event belongs to one component. Each region contains the previous one.
class Guards : public testing::Test {
protected:
    enum Name : Event { a = first_visible, b, c, d };

    struct Layer {
        std::vector<machine::Rows> components;  ///< in addition to the region inside
        std::map<Event, std::uint32_t> levels;
    };

    Guards() {
        for (const char* const name : {"a", "b", "c", "d"}) s.event(name);
    }

    /// Makes a process with these layers. If `off_by_c`, the rule for c of the outermost region turns the first
    /// component off.
    std::shared_ptr<const Supercombinator> process_of(const std::vector<Layer>& layers, bool off_by_c = false) {
        Supercombinator made;
        for (const Layer& layer : layers) {
            std::vector<Participant> participants;
            std::vector<process::EventSet> alphabets;
            if (!made.regions.empty()) {
                participants.push_back({true, static_cast<std::uint32_t>(made.regions.size() - 1)});
                alphabets.push_back(made.regions.back().alphabet);
            }
            for (const machine::Rows& rows : layer.components) {
                const auto slot = static_cast<std::uint32_t>(made.components.size());
                made.components.push_back(machine::component_of(rows, s.stop()));
                made.initial.push_back(0);
                made.fields.push_back({slot, 0, 0xffU});
                participants.push_back({false, slot});
                alphabets.push_back(made.components.back()->alphabet());
            }
            const bool outermost = &layer == &layers.back();
            std::vector<machine::DraftRule> drafts;
            for (std::uint32_t who = 0; who < participants.size(); ++who)
                for (std::uint32_t i = 0; i < alphabets[who].size(); ++i) {
                    machine::DraftRule& draft =
                        drafts.emplace_back(machine::DraftRule{alphabets[who][i], {{who, i}}, {}});
                    if (outermost && off_by_c && draft.event == c)
                        draft.assignments.push_back({0, static_cast<machine::Local>(made.components[0]->size())});
                }
            std::vector<std::uint32_t> levels(d + 1, no_level);
            for (const auto& [event, level] : layer.levels) levels[event] = level;
            made.regions.push_back(machine::region_of(participants, alphabets, std::move(drafts), levels));
        }
        made.words = static_cast<std::uint32_t>(made.components.size());
        machine::list_leading(made, diagnostics::unlimited);
        return std::make_shared<const Supercombinator>(std::move(made));
    }

    /// Checks that the answers with all guards agree with those of a search. Returns these answers, and the answers
    /// without the guards of this kind.
    std::pair<DiagramAnswers, DiagramAnswers> with_and_without(const std::shared_ptr<const Supercombinator>& combined,
                                                               Guard guard) {
        RegionRules rules = machine::rules_of_regions(*combined, diagnostics::unlimited).value();
        const DiagramAnswers right = answers_by(*combined, rules);
        EXPECT_EQ(right, answers_by_search(combined, s));
        bool left_out = false;
        for (std::size_t region = 0; region < rules.size(); ++region)
            for (std::size_t number = 0; number < rules[region].size(); ++number)
                left_out = leave_out(guard, rules, region, number) || left_out;
        EXPECT_TRUE(left_out);
        return {right, answers_by(*combined, rules)};
    }

    process::Scripted s;
};

/// a is always possible and has priority over b, so the deadlock after b is not reachable.
TEST_F(Guards, TheOutermostRegionPreventsARule) {
    const machine::Rows loop_or_stop{{{a, 0}, {b, 1}}, {}};
    const auto combined = process_of({{{loop_or_stop}, {{a, 0}, {b, 1}}}});
    const auto [right, wrong] = with_and_without(combined, Guard::outermost);
    EXPECT_FALSE(right.deadlock);
    EXPECT_EQ(right.events, std::vector<Event>{a});
    EXPECT_TRUE(wrong.deadlock);
    EXPECT_EQ(wrong.events, (std::vector<Event>{a, b}));
}

/// The same region below an operator that has no priorities, next to a component that can do nothing.
TEST_F(Guards, AnInnerRegionPreventsARule) {
    const machine::Rows loop_or_stop{{{a, 0}, {b, 1}}, {}}, stop{{}};
    const auto combined = process_of({{{loop_or_stop}, {{a, 0}, {b, 1}}}, {{stop}, {}}});
    const auto [right, wrong] = with_and_without(combined, Guard::inner);
    EXPECT_FALSE(right.deadlock);
    EXPECT_EQ(right.events, std::vector<Event>{a});
    EXPECT_TRUE(wrong.deadlock);
    EXPECT_EQ(wrong.events, (std::vector<Event>{a, b}));
}

/// In the outermost region, b has priority over c. The inner region prevents b, because a is always possible. So c
/// happens and turns the first component off. If the guard of b were removed, c would seem to be prevented.
TEST_F(Guards, APreventedRuleOfTheProcessPreventsNothing) {
    const machine::Rows loops{{{a, 0}, {b, 0}}}, once{{{c, 1}}, {}};
    const auto combined = process_of({{{loops}, {{a, 0}, {b, 1}}}, {{once}, {{b, 0}, {c, 1}}}}, true);
    const auto [right, wrong] = with_and_without(combined, Guard::inner);
    EXPECT_TRUE(right.deadlock);
    EXPECT_EQ(right.events, (std::vector<Event>{a, c}));
    EXPECT_FALSE(wrong.deadlock);
    EXPECT_EQ(wrong.events, (std::vector<Event>{a, b}));
}

/// The same situation one operator further inside. There are three regions. In the middle one, b would prevent c, but
/// the innermost region prevents b.
TEST_F(Guards, APreventedRuleOfAnInnerRegionPreventsNothing) {
    const machine::Rows loops{{{a, 0}, {b, 0}}}, once{{{c, 1}}, {}}, stop{{}};
    const auto combined = process_of({{{loops}, {{a, 0}, {b, 1}}}, {{once}, {{b, 0}, {c, 1}}}, {{stop}, {}}}, true);
    const auto [right, wrong] = with_and_without(combined, Guard::nested);
    EXPECT_TRUE(right.deadlock);
    EXPECT_EQ(right.events, (std::vector<Event>{a, c}));
    EXPECT_FALSE(wrong.deadlock);
    EXPECT_EQ(wrong.events, std::vector<Event>{a});
}

/// A guard that is removed from one rule changes the answers of many random processes. Nested guards are not tested
/// here: they need rules with three levels and three regions, which are too rare among random rules.
TEST_F(Guards, EachKindOfGuardMattersInRandomRules) {
    for (const Guard guard : {Guard::outermost, Guard::inner}) {
        machine::RandomRules random(3708);
        int planted = 0, noticed = 0;
        for (int round = 0; round < 500; ++round) {
            const std::shared_ptr<const Supercombinator> combined = random.next(s.stop());
            const RegionRules rules = machine::rules_of_regions(*combined, diagnostics::unlimited).value();
            const DiagramAnswers right = answers_by(*combined, rules);
            for (std::size_t region = 0; region < rules.size(); ++region)
                for (std::size_t number = 0; number < rules[region].size(); ++number) {
                    RegionRules faulty = rules;
                    if (!leave_out(guard, faulty, region, number)) continue;
                    ++planted;
                    noticed += answers_by(*combined, faulty) == right ? 0 : 1;
                }
        }
        EXPECT_GT(planted, 100) << static_cast<int>(guard);
        EXPECT_GT(noticed * 10, planted) << static_cast<int>(guard);
    }
}

}  // namespace
}  // namespace robochart::symbolic
