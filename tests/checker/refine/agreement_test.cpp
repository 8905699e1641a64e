// SPDX-License-Identifier: Apache-2.0
// Compares the checker with the naive reference on random processes over all operators, in every model, with every
// engine. ROBOCHART_RANDOM_CHECKS and ROBOCHART_RANDOM_SEED select more and other cases (docs/testing.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <iostream>
#include <map>
#include <random>

#include "checker/machine/compiler.hpp"
#include "checker/refine/verdict/check.hpp"
#include "checker/refine/verdict/level_strategy.hpp"
#include "tests/checker/processes/naive.hpp"
#include "tests/checker/processes/on_disk.hpp"
#include "tests/checker/processes/random_cases.hpp"
#include "tests/checker/processes/random_process.hpp"
#include "tests/checker/processes/thread_programs.hpp"
#include "tests/checker/processes/translate.hpp"
#include "tests/checker/refine/by_definition.hpp"

namespace robochart::refine {
namespace {

using naive::Behaviour;
using naive::Semantics;

/// Counts each answer, so that the test can show that it is not vacuous.
struct Seen {
    int checks = 0;
    int holds = 0;
    int fails = 0;
    void count(bool held) { ++checks, ++(held ? holds : fails); }
};

/// The options with which a question is answered.
struct Way {
    enum class Form { terms, compressing_terms, machines };
    Form form = Form::machines;
    bool taus = false;      ///< follow confluent taus
    bool symmetry = false;  ///< reduce symmetric states
    unsigned threads = 1;   ///< of the ordinary search, also for small systems
    unsigned ranks = 0;     ///< 0: the ordinary search; otherwise the level search
    bool disk = false;      ///< level search: rows on disk

    [[nodiscard]] bool leaves_out() const { return form == Form::machines && (taus || symmetry); }
};

constexpr unsigned most_threads = 3;
constexpr unsigned most_ranks = 4;  // four ranks in memory are two programs with two threads each

std::string way_text(const Way& way) {
    const char* const forms[] = {"as terms", "with compressions", "compiled"};
    std::string result = forms[static_cast<int>(way.form)];
    if (way.taus) result += ", confluent taus";
    if (way.symmetry) result += ", symmetry";
    if (way.ranks == 0) return result + ", threads: " + std::to_string(way.threads);
    return result + (way.disk ? ", on disk" : "") + ", ranks: " + std::to_string(way.ranks);
}

/// A sequence of ways to answer that depends only on the seed, not on the compiler.
class RandomWays {
public:
    explicit RandomWays(std::uint64_t seed) : numbers_(seed) {}
    Way next(bool compressible) {
        Way way;
        const unsigned form = below(8);
        if (form == 0) way.form = Way::Form::terms;
        if (form == 1 && compressible) way.form = Way::Form::compressing_terms;
        way.taus = below(2) == 0;
        way.symmetry = below(2) == 0;
        const unsigned where = below(3);
        if (where == 0) {
            way.threads = 1 + below(most_threads);
        } else {
            way.ranks = 1 + below(most_ranks);
            way.disk = where == 2;
        }
        return way;
    }
    unsigned below(unsigned end) { return static_cast<unsigned>(numbers_() % end); }

private:
    std::mt19937_64 numbers_;
};

/// A system that supports the reductions of all ways to answer.
class Reducible final : public lts::TransitionSystem {
public:
    Reducible(std::unique_ptr<lts::TransitionSystem> inner, bool taus, bool symmetry)
        : inner_(std::move(inner)), taus_(taus), symmetry_(symmetry) {}
    [[nodiscard]] std::size_t width() const override { return inner_->width(); }
    void initial(std::span<lts::Word> state) override { inner_->initial(state); }
    void successors(lts::StateView state, lts::SuccessorSink& sink) override { inner_->successors(state, sink); }
    [[nodiscard]] std::unique_ptr<lts::TransitionSystem> clone_for_thread() const override {
        auto more = inner_->clone_for_thread();
        return more ? std::make_unique<Reducible>(std::move(more), taus_, symmetry_) : nullptr;
    }
    [[nodiscard]] const process::EventTable& events() const override { return inner_->events(); }
    void set_budget(diagnostics::Pollable& budget) override { inner_->set_budget(budget); }
    [[nodiscard]] std::unique_ptr<lts::ReducedSystem> make_reduced_system(
        lts::Followed followed, diagnostics::Pollable& budget) const override {
        return taus_ ? inner_->make_reduced_system(followed, budget) : nullptr;
    }
    [[nodiscard]] bool excludes_tau_cycles(diagnostics::Pollable& budget) const override {
        return inner_->excludes_tau_cycles(budget);
    }
    [[nodiscard]] bool excludes_choices(diagnostics::Pollable& budget) const override {
        return inner_->excludes_choices(budget);
    }
    [[nodiscard]] std::unique_ptr<lts::TransitionSystem> make_cycle_system(
        diagnostics::Pollable& budget) const override {
        return inner_->make_cycle_system(budget);
    }
    [[nodiscard]] std::vector<lts::ReplicaSet> replicas(diagnostics::Pollable& budget) const override {
        return symmetry_ ? inner_->replicas(budget) : std::vector<lts::ReplicaSet>();
    }
    [[nodiscard]] std::string describe(lts::StateView state) const override { return inner_->describe(state); }

private:
    std::unique_ptr<lts::TransitionSystem> inner_;
    bool taus_, symmetry_;
};

/// Puts the second process in parallel with itself to create replicas. The seed decides how they are linked.
void double_process(Case& test_case, RandomWays& numbers) {
    naive::Tree both;
    both.kind = naive::Kind::parallel;
    both.operands = {test_case.script.mains[1], test_case.script.mains[1]};
    for (naive::Letter letter = 0; letter < naive::letters_used; ++letter)
        if (numbers.below(3) == 0) both.set.insert(letter);
    test_case.script.mains[1] = std::make_shared<const naive::Tree>(std::move(both));
}

bool contains_kind(const naive::Process& process, naive::Kind kind) {
    if (process->kind == kind) return true;
    return std::ranges::any_of(process->operands,
                               [kind](const naive::Process& operand) { return contains_kind(operand, kind); });
}

bool contains_kind(const naive::Script& script, naive::Kind kind) {
    const auto somewhere = [kind](const std::vector<naive::Process>& list) {
        return std::ranges::any_of(list, [kind](const auto& process) { return contains_kind(process, kind); });
    };
    return somewhere(script.definitions) || somewhere(script.mains);
}

/// Returns whether the script has compressions but no `chase`, because a compression may change which tau it follows.
bool compressible(const naive::Script& script) {
    return !contains_kind(script, naive::Kind::chase) && contains_kind(script, naive::Kind::compress);
}

Model model(Semantics semantics) {
    if (semantics == Semantics::T) return Model::traces;
    return semantics == Semantics::F ? Model::failures : Model::failures_divergences;
}

Verdict ask(const Question& question, lts::TransitionSystem& left, lts::TransitionSystem& right,
            const std::vector<process::Event>& trace, const Limits& limits) {
    switch (question.kind) {
        case Question::Kind::refinement:
            return refines(left, right, model(question.semantics), limits);
        case Question::Kind::deadlock_free:
            return deadlock_free(left, model(question.semantics), limits);
        case Question::Kind::divergence_free:
            return divergence_free(left, limits);
        case Question::Kind::deterministic:
            return deterministic(left, model(question.semantics), limits);
        case Question::Kind::has_trace:
            return has_trace(left, trace, model(question.semantics), limits);
    }
    return {};
}

/// A case with its systems in all forms. A system is created when it is needed.
class Systems {
public:
    explicit Systems(const Case& test_case)
        : asked_(test_case), plain_(test_case.script), compressing_(test_case.script, true) {}

    Translation& translation(Way::Form form) { return form == Way::Form::compressing_terms ? compressing_ : plain_; }
    /// Returns the system of the main process with this number. A process that is not compiled stays a term.
    std::unique_ptr<lts::TransitionSystem> system(int main, const Way& way) {
        const naive::Process& process = asked_.script.mains[static_cast<std::size_t>(main)];
        if (way.form == Way::Form::machines)
            if (auto machine = compiled(main))
                return std::make_unique<Reducible>(std::move(machine), way.taus, way.symmetry);
        return std::make_unique<process::TermSystem>(translation(way.form).system(process));
    }
    [[nodiscard]] bool is_compiled(int main) { return compiled(main) != nullptr; }
    naive::Letter letter_of(Way::Form form, process::Event event) {
        if (event == process::tau) return naive::tau;
        for (naive::Letter letter = 0; letter < naive::letters_used; ++letter)
            if (translation(form).event(letter) == event) return letter;
        return naive::tick;
    }

private:
    std::unique_ptr<lts::TransitionSystem> compiled(int main) {
        auto& made = machines_[static_cast<std::size_t>(main)];
        if (!made) {
            machine::Compiler compiler(plain_.semantics());
            made.emplace(compiler.compile(plain_.term(asked_.script.mains[static_cast<std::size_t>(main)]),
                                          diagnostics::unlimited));
        }
        return *made ? (*made)->clone_for_thread() : nullptr;
    }

    const Case& asked_;
    Translation plain_, compressing_;
    std::optional<std::unique_ptr<lts::TransitionSystem>> machines_[2];
};

class Agreement : public testing::Test {
protected:
    Limits limits_of(const Way& way);
    Verdict ask_by(Systems& systems, const Question& question, const Case& test_case, const Way& way);
    /// Returns the difference between the answer in this way and the expected answer, if there is any.
    std::optional<std::string> fault(Systems& systems, const Question& question, const Case& test_case,
                                     const Graphs& graphs, const Way& way);
    bool check_agreement(Systems& systems, const Question& question, const Case& test_case, const Graphs& graphs,
                         const Way& way);

    ThreadPrograms in_memory_[most_ranks] = {{1, 1}, {1, 2}, {1, 3}, {2, 2}};
    OnDisk on_disk_[most_ranks] = {OnDisk(1), OnDisk(2), OnDisk(3), OnDisk(4)};
    std::map<std::string, Seen> seen_;
    std::map<std::string, int> ways_;
    int checks_ = 0;
    int compared_ = 0;  ///< searches compared in size with one of all states in memory by one thread
    int smaller_ = 0;   ///< searches with fewer states
    int by_symmetry_ = 0;
    int compiled_ = 0;
    int left_as_terms_ = 0;
};

Limits Agreement::limits_of(const Way& way) {
    Limits limits;
    limits.reduction = way.taus || way.symmetry;
    limits.threads = way.threads;
    limits.wide_level = way.threads > 1 ? 1 : limits.wide_level;
    if (way.ranks > 0) {
        LevelStrategy& strategy = way.disk ? static_cast<LevelStrategy&>(on_disk_[way.ranks - 1])
                                           : static_cast<LevelStrategy&>(in_memory_[way.ranks - 1]);
        limits.by_levels = &strategy;
    }
    return limits;
}

Verdict Agreement::ask_by(Systems& systems, const Question& question, const Case& test_case, const Way& way) {
    std::vector<process::Event> trace;
    for (naive::Letter letter : test_case.trace) trace.push_back(systems.translation(way.form).event(letter));
    const auto left = systems.system(question.left, way);
    const auto right = systems.system(question.right, way);
    return ask(question, *left, *right, trace, limits_of(way));
}

std::optional<std::string> Agreement::fault(Systems& systems, const Question& question, const Case& test_case,
                                            const Graphs& graphs, const Way& way) {
    const bool holds = expected(question, graphs, test_case.trace);
    Verdict verdict;
    try {
        verdict = ask_by(systems, question, test_case, way);
    } catch (const std::logic_error& internal) {
        return std::string("is an internal error: ") + internal.what();
    }
    const Outcome by_definition = holds ? Outcome::holds : Outcome::fails;
    if (verdict.outcome != by_definition) return holds ? "should hold" : "should fail";
    if (verdict.counterexample.has_value() == holds) return "has a counterexample too many or too few";
    if (!holds) {
        const auto letter = [&](process::Event event) { return systems.letter_of(way.form, event); };
        return wrong_by_definition(*verdict.counterexample, question, graphs, way.form != Way::Form::compressing_terms,
                                   letter);
    }
    Way whole;
    whole.form = way.form;
    const Statistics all = ask_by(systems, question, test_case, whole).statistics;
    const Statistics& actual = verdict.statistics;
    ++compared_;
    // Determinism needs several searches. Later searches depend on the result of the first.
    if (actual.states > all.states && question.kind != Question::Kind::deterministic)
        return "has more states than there are";
    if (actual.states < all.states) ++smaller_;
    if (actual.replicas > 0) ++by_symmetry_;
    if (!way.leaves_out() && (actual.states != all.states || actual.transitions != all.transitions))
        return "has other figures than by one thread in memory";
    return std::nullopt;
}

/// Decides one question. If the engine is wrong, shrinks and prints the case.
bool Agreement::check_agreement(Systems& systems, const Question& question, const Case& test_case, const Graphs& graphs,
                                const Way& way) {
    if (!fault(systems, question, test_case, graphs, way)) return true;
    const auto wrong = [&](const Case& other) -> std::optional<std::string> {
        const auto explored = explore(other, largest_graph);
        if (!explored) return std::nullopt;
        Systems its(other);
        return fault(its, question, other, *explored, way);
    };
    const Case least = shrink(test_case, [&](const Case& other) { return wrong(other).has_value(); });
    ADD_FAILURE() << way_text(way) << ": " << assertion(question, least.trace) << " " << wrong(least).value_or("?")
                  << "\n"
                  << show(least.script);
    return false;
}

TEST_F(Agreement, OnRandomProcesses) {
    const int required_checks = wanted_checks(1'000);
    RandomCases cases(1);
    RandomWays ways(1);
    bool agreed = true;
    while (agreed && checks_ < required_checks) {
        RandomCases::Explored explored = cases.next();
        if (ways.below(4) == 0) {
            Case more = explored.test_case;
            double_process(more, ways);
            if (auto graphs = explore(more, largest_graph)) explored = {std::move(more), std::move(*graphs)};
        }
        Systems systems(explored.test_case);
        for (const int main : {0, 1}) ++(systems.is_compiled(main) ? compiled_ : left_as_terms_);
        for (const Question& question : questions()) {
            const Way way = ways.next(compressible(explored.test_case.script));
            agreed = agreed && check_agreement(systems, question, explored.test_case, explored.graphs, way);
            ++checks_;
            ++ways_[way_text(way)];
            seen_[assertion_kind(question)].count(expected(question, explored.graphs, explored.test_case.trace));
        }
    }
    ASSERT_TRUE(agreed);
    std::uint64_t rolled_back = 0;
    for (const OnDisk& disk : on_disk_) rolled_back += disk.rolled_back();
    std::cout << checks_ << " random checks agree, in " << ways_.size() << " ways; of " << compared_ << " that hold "
              << smaller_ << " with fewer states, " << by_symmetry_ << " by symmetry; searches on disk went back "
              << rolled_back << " times\n";
    RecordProperty("checks", checks_);
    for (const auto& [question, seen] : seen_) {
        RecordProperty(question, std::to_string(seen.holds) + " hold, " + std::to_string(seen.fails) + " fail");
        EXPECT_GT(seen.holds * 20, seen.checks) << question << " held too rarely to be tested: " << seen.holds;
        EXPECT_GT(seen.fails * 20, seen.checks) << question << " failed too rarely to be tested: " << seen.fails;
    }
    constexpr std::size_t of_compiled_processes = 2 * 2 * (most_threads + 2 * most_ranks);
    EXPECT_GE(ways_.size(), of_compiled_processes);
    EXPECT_GT(smaller_ * 50, checks_);
    EXPECT_GT(by_symmetry_ * 100, checks_);
    EXPECT_GT(rolled_back * 40, static_cast<std::uint64_t>(checks_));
    EXPECT_GT(compiled_ * 15, left_as_terms_) << "too few processes were compiled: " << compiled_;
}

// The test detects a checker that confuses external with internal choice, and shows it by a minimal case.
TEST_F(Agreement, AFaultIsFoundAndShrunk) {
    const std::function<naive::Process(const naive::Process&)> confused = [&](const naive::Process& process) {
        naive::Tree tree = *process;
        for (naive::Process& operand : tree.operands) operand = confused(operand);
        if (tree.kind == naive::Kind::internal) tree.kind = naive::Kind::external;
        return std::make_shared<const naive::Tree>(std::move(tree));
    };
    const auto wrong = [&](const Case& test_case) {
        Case other = test_case;
        for (naive::Process& main : other.script.mains) main = confused(main);
        for (naive::Process& definition : other.script.definitions) definition = confused(definition);
        const auto graphs = explore(test_case, largest_graph);
        const auto others = explore(other, largest_graph);
        if (!graphs || !others) return false;
        return std::ranges::any_of(questions(), [&](const Question& question) {
            return expected(question, *graphs, test_case.trace) != expected(question, *others, test_case.trace);
        });
    };
    RandomCases cases(2);
    Case found = cases.next().test_case;
    while (!wrong(found)) found = cases.next().test_case;
    const Case least = shrink(found, wrong);
    // M0 is STOP. M1 is a choice of two different leaves, or a smaller process.
    EXPECT_TRUE(contains_kind(least.script, naive::Kind::internal)) << show(least.script);
    for (const naive::Process& main : least.script.mains) EXPECT_LE(show(main).size(), 40U) << show(least.script);
}

}  // namespace
}  // namespace robochart::refine
