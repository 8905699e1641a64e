// SPDX-License-Identifier: Apache-2.0
// Tests that cached answers of an earlier session are used for the same processes only.
#include "checker/cspm/earlier_answers.hpp"

#include <gtest/gtest.h>

#include "base/diagnostics/files.hpp"
#include "checker/cspm/session.hpp"
#include "tests/checker/cspm/support.hpp"

namespace robochart::cspm::test {
namespace {

using refine::Outcome;

/// Two cells, a specification that is evaluated as terms, and one that is compiled.
const std::string script = R"(channel in, mid, out : {0..2}
Cell(a, b) = a?x -> b!x -> Cell(a, b)
Two = Cell(in, mid) [|{|mid|}|] Cell(mid, out)
Buffer(s) = (if s == <> then STOP else out!head(s) -> Buffer(tail(s))) [] #s < 3 & in?x -> Buffer(s ^ <x>)
assert Buffer(<>) [T= Two \ {|mid|}
assert Two [T= Cell(in, mid) ||| Cell(mid, out)
assert Two \ {|mid|} :[deadlock free [F]]
assert Two \ {|in, mid, out|} :[divergence free]
assert Two :[deterministic [FD]]
)";

class EarlierAnswersTest : public ::testing::Test {
protected:
    struct Answers {
        std::string outcomes;  ///< h holds, f fails
        std::string known;     ///< y if the answer was in the cache, otherwise n
        std::vector<std::string> runs;
        std::vector<std::uint64_t> states;
    };

    Answers check(const std::string& text, bool remember = true, bool reduction = false) {
        Reading reading(text);
        EXPECT_TRUE(reading.ok()) << reading.report();
        Session session(reading.script);
        if (remember) session.set_cache(cache_, 0);
        Answers answers;
        refine::Limits limits;
        limits.reduction = reduction;
        for (const DeclPtr& assertion : session.assertions()) {
            const refine::Verdict verdict = session.check(*assertion, limits).verdict;
            answers.outcomes += outcome_letter(verdict.outcome);
            answers.known += verdict.known ? 'y' : 'n';
            answers.states.push_back(verdict.statistics.states);
            std::string run;
            if (verdict.counterexample)
                for (const refine::Step& step : verdict.counterexample->steps)
                    run += session.event_table().name(step.event) + " " + step.state + "\n";
            answers.runs.push_back(run);
        }
        return answers;
    }

    void expect_equal(const Answers& some, const Answers& others) {
        EXPECT_EQ(some.outcomes, others.outcomes);
        EXPECT_EQ(some.runs, others.runs);
        EXPECT_EQ(some.states, others.states);
    }

    diagnostics::Cache& cache() { return cache_; }

private:
    std::string error_;
    diagnostics::TemporaryFolder temporary_{"", error_};
    diagnostics::Cache cache_{temporary_.path() + "/cache", "test", 1U << 20U};
};

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    return text.replace(text.find(what), what.size(), by);
}

TEST_F(EarlierAnswersTest, TheSameQuestionsAreKnown) {
    const Answers without = check(script, false);
    // With mid hidden, Two is a buffer of at most two values, in order. The separate cells can perform mid.0 first,
    // which Two cannot. Two never deadlocks. With all events hidden it diverges. Each event leads to one state.
    EXPECT_EQ(without.outcomes, "hfhfh");
    const Answers first = check(script);
    EXPECT_EQ(first.known, "nnnnn");
    expect_equal(first, without);
    const Answers second = check(script);
    EXPECT_EQ(second.known, "yyyyy");
    expect_equal(second, without);
}

TEST_F(EarlierAnswersTest, EditsThatChangeNoProcessChangeNoQuestion) {
    (void)check(script);
    EXPECT_EQ(check("-- a comment\n\n" + script).known, "yyyyy");
    EXPECT_EQ(check(replaced(script, "a?x -> b!x -> Cell(a, b)", "a?y -> (b!y -> Cell(a, b))")).known, "yyyyy");
    EXPECT_EQ(check(replaced(script, "#s < 3", "not (#s >= 3)")).known, "yyyyy");
}

TEST_F(EarlierAnswersTest, WhatAnEditChangesIsAskedAgain) {
    (void)check(script);
    // A buffer for one value does not admit two values. Only the first assertion depends on the buffer.
    const Answers smaller = check(replaced(script, "#s < 3", "#s < 1"));
    EXPECT_EQ(smaller.outcomes, "ffhfh");
    EXPECT_EQ(smaller.known, "nyyyy");
    const Answers other = check(replaced(script, "b!x -> Cell", "b!(2-x) -> Cell"));
    EXPECT_EQ(other.known, "nnnnn");
    expect_equal(other, check(replaced(script, "b!x -> Cell", "b!(2-x) -> Cell"), false));
}

TEST_F(EarlierAnswersTest, NamesOfEventsArePartOfAQuestion) {
    (void)check(script);
    std::string renamed = script;
    for (std::size_t at = renamed.find("mid"); at != std::string::npos; at = renamed.find("mid", at + 1))
        renamed.replace(at, 3, "cut");
    EXPECT_EQ(check(renamed).known.substr(1, 1), "n");
}

TEST_F(EarlierAnswersTest, TheModelIsPartOfAQuestion) {
    (void)check(script);
    const Answers failures = check(replaced(script, "Buffer(<>) [T=", "Buffer(<>) [F="));
    EXPECT_EQ(failures.known, "nyyyy");
    // After one value the buffer must accept another, and so must the two cells.
    EXPECT_EQ(failures.outcomes, "ffhfh") << "the specification offers a third value while Two holds two";
}

TEST_F(EarlierAnswersTest, TheReductionIsPartOfAQuestion) {
    (void)check(script);
    const Answers reduced = check(script, true, true);
    EXPECT_EQ(reduced.known, "nnnnn") << "the figures of a reduced search are others";
    EXPECT_EQ(reduced.outcomes, "hfhfh");
    const Answers again = check(script, true, true);
    EXPECT_EQ(again.known, "yyyyy");
    expect_equal(again, reduced);
}

TEST_F(EarlierAnswersTest, FindingsThatAreNotConfirmedAreNotUsed) {
    Reading reading(script);
    Session session(reading.script);
    const auto system = session.system(session.assertions()[2]->assertion.specification);
    const Question question{AssertionKind::deadlock_free, refine::Model::failures, nullptr, system.get(), 1000};
    const auto key = key_of(question, diagnostics::unlimited, std::nullopt);
    ASSERT_TRUE(key);
    // Two does not deadlock in its initial state.
    std::vector<lts::Word> initial(system->width());
    system->initial(initial);
    refine::Findings wrong;
    wrong.violation = refine::Violation{refine::ViolationKind::deadlock, {initial, {}}, {}, {}};
    cache().store_entry(key->digest, refine::encode(wrong, key->named));
    refine::Limits limits;
    const refine::Verdict verdict = check_with_memory(question, *key, {&cache(), 0}, [&](refine::Earlier earlier) {
        return refine::deadlock_free(*system, refine::Model::failures, limits, earlier);
    });
    EXPECT_EQ(verdict.outcome, Outcome::holds);
    EXPECT_FALSE(verdict.known);
}

TEST_F(EarlierAnswersTest, ASpecificationThatCannotBeSeenAsAWholeHasNoKey) {
    const std::string endless = replaced(script, "#s < 3 & ", "");  // an unbounded buffer
    EXPECT_EQ(check(endless).known, "nnnnn");
    const Answers again = check(endless);
    EXPECT_EQ(again.known, "nyyyy");
    EXPECT_EQ(again.outcomes, "hfhfh");
}

TEST_F(EarlierAnswersTest, SmallSearchesAreNotKept) {
    for (int round = 0; round < 2; ++round) {
        Reading reading(script);
        Session session(reading.script);
        session.set_cache(cache());
        EXPECT_FALSE(session.check(*session.assertions()[0], {}).verdict.known);
    }
}

}  // namespace
}  // namespace robochart::cspm::test
