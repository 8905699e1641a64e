// SPDX-License-Identifier: Apache-2.0
// Tests hash-consing: each term, event, set, renaming and order is stored only once.
#include "checker/process/term.hpp"

#include <gtest/gtest.h>

#include "scripted.hpp"

namespace robochart::process {
namespace {

TEST(EventTable, NumbersVisibleEventsInOrderOfFirstInterning) {
    EventTable table;
    EXPECT_EQ(table.name(tau), "τ");
    EXPECT_EQ(table.name(tick), "✓");
    EXPECT_EQ(table.intern("b"), first_visible);
    EXPECT_EQ(table.intern("a"), first_visible + 1);
    EXPECT_EQ(table.intern("b"), first_visible);
    EXPECT_EQ(table.size(), 4U);
}

TEST(TermStore, GivesEqualTermsEqualIds) {
    Scripted s;
    const TermId stop = s.stop();
    const TermId skip = s.skip();
    EXPECT_NE(stop, skip);
    EXPECT_EQ(s.op(Op::external_choice, {stop, skip}), s.op(Op::external_choice, {stop, skip}));
    EXPECT_NE(s.op(Op::external_choice, {stop, skip}), s.op(Op::external_choice, {skip, stop}));
    EXPECT_NE(s.over(Op::parallel, {stop, skip}, {"a"}), s.over(Op::parallel, {stop, skip}, {"b"}));
    const TermId split = s.op(Op::alphabetised, {stop, skip}, 0, {s.set({"a"}), s.set({"b"})});
    EXPECT_NE(split, s.op(Op::alphabetised, {stop, skip}, 0, {s.set({"b"}), s.set({"a"})}));
    EXPECT_EQ(s.store[split].children, (std::vector<TermId>{stop, skip}));
}

TEST(TermStore, KeepsIdsAndReferencesWhileItGrows) {
    Scripted s;
    const TermId first = s.stop();
    const Term& stored = s.store[first];
    std::vector<TermId> made;
    for (std::uint32_t i = 0; i < 20000; ++i) made.push_back(s.op(Op::call, {}, i));
    for (std::uint32_t i = 0; i < 20000; ++i) {
        ASSERT_EQ(s.op(Op::call, {}, i), made[i]);
        ASSERT_EQ(s.store[made[i]].payload, i);
    }
    EXPECT_EQ(stored.op, Op::stop);
    EXPECT_EQ(s.store.size(), 20001U);
}

TEST(TermStore, SortsSetsAndDropsTau) {
    Scripted s;
    const Event a = s.event("a");
    const Event b = s.event("b");
    const Event c = s.event("c");
    const SetId set = s.store.intern_set({c, a, c, tau});
    EXPECT_EQ(s.store[set], (EventSet{a, c}));
    EXPECT_EQ(s.store.intern_set({a, c}), set);
    EXPECT_TRUE(s.store.contains(set, a));
    EXPECT_FALSE(s.store.contains(set, b));
    EXPECT_FALSE(s.store.contains(set, tau));
    EXPECT_FALSE(s.store.contains(set, 1000));
    EXPECT_FALSE(s.store.contains(s.store.intern_set({}), a));
}

TEST(TermStore, InternsRenamingsAndOrders) {
    Scripted s;
    const Event a = s.event("a");
    const Event b = s.event("b");
    EXPECT_EQ(s.store.intern_renaming({{b, a}, {a, b}}), s.store.intern_renaming({{a, b}, {b, a}}));
    EXPECT_EQ(s.store[s.store.intern_renaming({{b, a}, {a, b}})], (Renaming{{a, b}, {b, a}}));
    EXPECT_NE(s.store.intern_order({{a}, {b}}), s.store.intern_order({{b}, {a}}));
    EXPECT_EQ(s.store.intern_order({{b, a}}), s.store.intern_order({{a, b}}));
}

TEST(TermStore, AsksTheDefinitionsOncePerCall) {
    Scripted s;
    const TermId p = s.name("P");
    s.bind(p, s.skip());
    EXPECT_EQ(s.store.unfold(s.store[p].payload), s.skip());
    EXPECT_EQ(s.store.unfold(s.store[p].payload), s.skip());
    EXPECT_EQ(s.unfoldings, 1);
}

}  // namespace
}  // namespace robochart::process
