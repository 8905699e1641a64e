// The checker against the naive reference on random processes over all operators, in every model, by every engine.
// ROBOCHART_RANDOM_CHECKS and ROBOCHART_RANDOM_SEED ask for more and for others (docs/testing.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>

#include "checker/machine/compiler.hpp"
#include "checker/refine/verdict/check.hpp"
#include "checker/refine/verdict/level_strategy.hpp"
#include "tests/checker/processes/naive.hpp"
#include "tests/checker/processes/on_disk.hpp"
#include "tests/checker/processes/random_cases.hpp"
#include "tests/checker/processes/random_process.hpp"
#include "tests/checker/processes/translate.hpp"

namespace robochart::refine {
namespace {

using naive::Behaviour;
using naive::Semantics;

/// How often each answer was seen, so that the test cannot become empty.
struct Seen {
    int checks = 0;
    int holds = 0;
    int fails = 0;
    void count(bool held) { ++checks, ++(held ? holds : fails); }
};

enum class Engine {
    terms,
    terms_by_levels,
    compressing_terms,
    machines,
    reduced_machines,
    ranks,
    reduced_ranks,
    disk,
    reduced_disk
};

bool is_compiled(Engine engine) {
    return engine != Engine::terms && engine != Engine::terms_by_levels && engine != Engine::compressing_terms;
}

/// Reduced machines are searched by several threads as well, however few states they have.
Limits limits_of(Engine engine) {
    static ThreadRanks two(2);
    static ThreadRanks three(3);
    static OneRank one;
    static OnDisk disk(1);
    static OnDisk two_on_disk(2);
    Limits limits;
    if (engine == Engine::ranks) limits.by_levels = &two;
    if (engine == Engine::reduced_ranks) limits.by_levels = &three;
    if (engine == Engine::terms_by_levels) limits.by_levels = &one;
    if (engine == Engine::disk) limits.by_levels = &disk;
    if (engine == Engine::reduced_disk) limits.by_levels = &two_on_disk;
    limits.reduction =
        engine == Engine::reduced_machines || engine == Engine::reduced_ranks || engine == Engine::reduced_disk;
    if (engine != Engine::reduced_machines) return limits;
    limits.threads = 2;
    limits.wide_level = 1;
    return limits;
}

bool uses(const naive::Process& process, naive::Kind kind) {
    if (process->kind == kind) return true;
    return std::any_of(process->operands.begin(), process->operands.end(),
                       [kind](const naive::Process& operand) { return uses(operand, kind); });
}

bool uses(const naive::Script& script, naive::Kind kind) {
    const auto somewhere = [kind](const std::vector<naive::Process>& list) {
        return std::any_of(list.begin(), list.end(), [kind](const auto& each) { return uses(each, kind); });
    };
    return somewhere(script.definitions) || somewhere(script.mains);
}

/// Compressions may change what chase follows.
bool compressible(const naive::Script& script) {
    return !uses(script, naive::Kind::chase) && uses(script, naive::Kind::compress);
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

class Agreement : public testing::Test {
protected:
    /// The first question that the engine answers otherwise than the definitions say, in words; none if there is none.
    std::optional<std::string> disagreement(const Case& asked, const Graphs& graphs, Engine engine, bool counted);
    std::unique_ptr<lts::TransitionSystem> system(Translation& translation, const naive::Process& process,
                                                  Engine engine);
    bool agrees(const RandomCases::Explored& each, Engine engine);

    std::map<std::string, Seen> seen_;
    int checks_ = 0;
    int plain_ = 0;
    int compressed_ = 0;
    int compiled_ = 0;
    int left_as_terms_ = 0;
};

std::unique_ptr<lts::TransitionSystem> Agreement::system(Translation& translation, const naive::Process& process,
                                                         Engine engine) {
    if (is_compiled(engine)) {
        machine::Compiler compiler(translation.semantics());
        if (auto compiled = compiler.compile(translation.term(process), {})) return ++compiled_, std::move(compiled);
        ++left_as_terms_;
    }
    return std::make_unique<process::TermSystem>(translation.system(process));
}

/// What is wrong with the verdict, if anything.
std::optional<std::string> fault(const Question& question, const Verdict& verdict, const Graphs& graphs, bool holds,
                                 bool compressing) {
    if (verdict.outcome != (holds ? Outcome::holds : Outcome::fails)) return holds ? "should hold" : "should fail";
    if (verdict.counterexample.has_value() == holds) return "has a counterexample too many or too few";
    const bool measured = question.kind == Question::Kind::refinement && question.semantics != Semantics::FD;
    if (holds || compressing || !measured) return std::nullopt;
    const Behaviour left(graphs.graphs[question.left], naive::letters_used);
    const Behaviour right(graphs.graphs[question.right], naive::letters_used);
    const auto shortest = naive::shortest_violation(left, right, question.semantics);
    return verdict.counterexample->steps.size() == shortest ? std::nullopt
                                                            : std::optional<std::string>("has no shortest run");
}

std::optional<std::string> Agreement::disagreement(const Case& asked, const Graphs& graphs, Engine engine,
                                                   bool counted) {
    const bool compressing = engine == Engine::compressing_terms;
    Translation translation(asked.script, compressing);
    const std::unique_ptr<lts::TransitionSystem> systems[] = {system(translation, asked.script.mains[0], engine),
                                                              system(translation, asked.script.mains[1], engine)};
    std::vector<process::Event> trace;
    for (naive::Letter each : asked.trace) trace.push_back(translation.event(each));
    for (const Question& question : questions()) {
        const bool holds = expected(question, graphs, asked.trace);
        Verdict verdict;
        try {
            verdict = ask(question, *systems[question.left], *systems[question.right], trace, limits_of(engine));
        } catch (const std::logic_error& internal) {
            return assertion(question, asked.trace) + " is an internal error: " + internal.what();
        }
        if (const auto wrong = fault(question, verdict, graphs, holds, compressing))
            return assertion(question, asked.trace) + " " + *wrong;
        if (!counted) continue;
        ++checks_;
        seen_[topic(question)].count(holds);
    }
    if (counted && (engine == Engine::terms || engine == Engine::machines || compressing))
        ++(compressing ? compressed_ : plain_);
    return std::nullopt;
}

/// Shrinks and prints a case on which the engine is wrong.
bool Agreement::agrees(const RandomCases::Explored& each, Engine engine) {
    if (!disagreement(each.asked, each.graphs, engine, true)) return true;
    const auto wrong = [&](const Case& asked) -> std::optional<std::string> {
        const auto graphs = explore(asked, largest_graph);
        if (!graphs) return std::nullopt;
        return disagreement(asked, *graphs, engine, false);
    };
    const Case least = shrink(each.asked, [&](const Case& asked) { return wrong(asked).has_value(); });
    const char* const names[] = {"as terms",       "as terms by levels", "with compressions",      "compiled",
                                 "reduced",        "by two ranks",       "reduced by three ranks", "on disk",
                                 "reduced on disk"};
    const char* const name = names[static_cast<int>(engine)];
    ADD_FAILURE() << name << ": " << wrong(least).value_or("?") << "\n" << show(least.script);
    return false;
}

TEST_F(Agreement, OnRandomProcesses) {
    const int wanted = wanted_checks(12'000);
    RandomCases cases(1);
    bool agreed = true;
    while (agreed && checks_ < wanted) {
        const RandomCases::Explored each = cases.next();
        for (const Engine engine : {Engine::terms, Engine::terms_by_levels, Engine::machines, Engine::reduced_machines,
                                    Engine::ranks, Engine::reduced_ranks, Engine::disk, Engine::reduced_disk})
            agreed = agreed && agrees(each, engine);
        if (agreed && compressible(each.asked.script)) agreed = agrees(each, Engine::compressing_terms);
    }
    ASSERT_TRUE(agreed);
    std::cout << checks_ << " random checks agree\n";
    RecordProperty("checks", checks_);
    for (const auto& [question, seen] : seen_) {
        RecordProperty(question, std::to_string(seen.holds) + " hold, " + std::to_string(seen.fails) + " fail");
        EXPECT_GT(seen.holds * 20, seen.checks) << question << " held too rarely to be tested: " << seen.holds;
        EXPECT_GT(seen.fails * 20, seen.checks) << question << " failed too rarely to be tested: " << seen.fails;
    }
    EXPECT_GE(checks_, 5000);
    EXPECT_GT(compiled_ * 15, left_as_terms_) << "too few processes were compiled: " << compiled_;
    EXPECT_GT(compressed_ * 10, plain_) << "too few pairs with compressions: " << compressed_;
}

// A checker that takes external for internal choice is found out, and by a case as small as they come.
TEST_F(Agreement, AFaultIsFoundAndShrunk) {
    const std::function<naive::Process(const naive::Process&)> confused = [&](const naive::Process& process) {
        naive::Tree tree = *process;
        for (naive::Process& operand : tree.operands) operand = confused(operand);
        if (tree.kind == naive::Kind::internal) tree.kind = naive::Kind::external;
        return std::make_shared<const naive::Tree>(std::move(tree));
    };
    const auto wrong = [&](const Case& asked) {
        Case other = asked;
        for (naive::Process& main : other.script.mains) main = confused(main);
        for (naive::Process& definition : other.script.definitions) definition = confused(definition);
        const auto graphs = explore(asked, largest_graph);
        const auto others = explore(other, largest_graph);
        if (!graphs || !others) return false;
        return std::any_of(questions().begin(), questions().end(), [&](const Question& question) {
            return expected(question, *graphs, asked.trace) != expected(question, *others, asked.trace);
        });
    };
    RandomCases cases(2);
    Case found = cases.next().asked;
    while (!wrong(found)) found = cases.next().asked;
    const Case least = shrink(found, wrong);
    // M0 = STOP, M1 = a choice of two different leaves, or an even smaller one.
    EXPECT_TRUE(uses(least.script, naive::Kind::internal)) << show(least.script);
    for (const naive::Process& main : least.script.mains) EXPECT_LE(show(main).size(), 40U) << show(least.script);
}

}  // namespace
}  // namespace robochart::refine
