// SPDX-License-Identifier: Apache-2.0
// Tests answers with free values of computed data (docs/data.md, "Computed data"). What they state must be true of the
// model.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>

#include "driver/claims/model_claims.hpp"
#include "semantics/data/class_model.hpp"
#include "tests/rounds.hpp"

namespace robochart::driver {
namespace {

class PlainServices final : public Services {
public:
    diagnostics::Budget& budget() override { return budget_; }

private:
    diagnostics::Budget budget_;
};

struct Found {
    Answer answer = Answer::inconclusive;
    bool bounded = false;
};
/// The answers to the core properties, by names such as "S deadlock-free".
using Answers = std::map<std::string, Found>;

Answers decide(Project& project, const Settings& settings, Services& services) {
    ClaimResults results;
    check_assertions(project, SearchContext{settings, services}, results);
    Answers answers;
    for (const AssertionReport& one : results.assertions) {
        const std::string component = one.core->component.substr(one.core->component.rfind(' ') + 1);
        answers[component + " " + one.core->property] = {one.answer, !one.basis.empty()};
    }
    return answers;
}

struct Both {
    Answers concrete, free;
    std::size_t conditions = 0;  ///< number of free conditions
};

/// Returns the timed answers in the finite instantiation and with free values. With `only_free`, returns only the
/// latter.
Both answers_for(const std::string& model, bool only_free = false) {
    Settings settings;
    settings.load.inputs = {"m.rct"};
    settings.load.texts = {{"m.rct", model}};
    settings.claims.core = true;
    settings.claims.concrete = true;
    settings.claims.times = Times::timed;
    settings.instantiation.ranges = {"nat=0..3", "clock=0..3"};
    settings.limits.max_states = 20'000;
    PlainServices services;
    const auto project = load_project(settings, services.budget());
    Both result;
    EXPECT_TRUE(project->diagnostics.ok()) << model;
    auto free = ir::free_model(project->system, project->instantiation);
    if (!project->diagnostics.ok()) return result;
    if (!only_free) result.concrete = decide(*project, settings, services);
    if (!free) return result;
    result.conditions = free->free_conditions;
    const auto freed = with_data(*project, std::move(free->system), std::move(free->instantiation));
    freed->model = std::move(project->model);
    result.free = decide(*freed, settings, services);
    EXPECT_TRUE(freed->diagnostics.ok()) << model;
    return result;
}

// ---------------------------------------------------------------- random machines

/// Draws machines whose numbers stay in 0..3. So the answers in the finite instantiation are exact if they reach no
/// bound.
class Draw {
public:
    explicit Draw(std::uint64_t seed) : random_(seed) {}
    std::string machine();

private:
    int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
    const char* any(std::initializer_list<const char*> words) {
        return words.begin()[below(static_cast<int>(words.size()))];
    }
    std::string variable() { return any({"x", "y", "z"}); }
    std::string number(int depth = 0) {
        switch (below(depth < 2 ? 5 : 2)) {
            case 0:
                return std::to_string(below(4));
            case 1:
                return variable();
            case 2:
                return fmt::format("(({} + {}) % 4)", number(depth + 1), number(depth + 1));
            case 3:
                return fmt::format("(({} * {}) % 4)", number(depth + 1), number(depth + 1));
            default:
                return fmt::format("(if {} then {} else {} end)", condition(depth + 1), number(depth + 1),
                                   number(depth + 1));
        }
    }
    std::string comparison(int depth) {
        return fmt::format("{} {} {}", number(depth + 1), any({"<", "<=", ">", ">=", "==", "!="}), number(depth + 1));
    }
    std::string condition(int depth = 0) {
        switch (below(5)) {
            case 0:
                return fmt::format("({} /\\ {})", comparison(depth), comparison(depth));
            case 1:
                return fmt::format("({} \\/ not b)", comparison(depth));
            default:
                return comparison(depth);
        }
    }
    std::string statement(int depth = 0) {
        switch (below(depth < 2 ? 9 : 6)) {
            case 0:
                return fmt::format("snd ! {}", number());
            case 1:
                return fmt::format("b = ({})", condition());
            case 2:
                return fmt::format("m = (if {} then M::p else M::q end)", condition());
            case 3:
                return "e ? " + variable();
            case 6:
                return fmt::format("if {} then {} else {} end", condition(), statement(depth + 1),
                                   statement(depth + 1));
            case 7:
                return fmt::format("{} ; {}", statement(depth + 1), statement(depth + 1));
            case 8:
                return "wait(1)";
            default:
                return fmt::format("{} = {}", variable(), number());
        }
    }
    std::string trigger() {
        switch (below(4)) {
            case 0:
                return "trigger go";
            case 1:
                return "trigger f ? " + variable();
            case 2:
                return "trigger stop";
            default:
                return "";
        }
    }
    std::string guard() {
        if (below(4) == 0) return "condition m == M::p";
        return "condition " + condition();
    }
    std::string maybe(const std::string& word, int chance) {
        return below(chance) == 0 ? fmt::format(" {} {}", word, statement()) : "";
    }

    std::mt19937_64 random_;
};

std::string Draw::machine() {
    std::string text =
        "package p\nenumeration M { p q }\nstm S {\n event e : nat event f : nat event go event stop\n event snd : "
        "nat\n";
    for (const char* const name : {"x", "y", "z"}) text += fmt::format(" var {} : nat = {}\n", name, below(4));
    text += " var b : boolean var m : M\n initial i\n junction j\n";
    for (const char* const name : {"A", "B", "C"})
        text += fmt::format(" state {} {{{}{}{} }}\n", name, maybe("entry", 2), maybe("\n  during", 3),
                            maybe("\n  exit", 3));
    text += fmt::format(" transition t0 {{ from i to A{} }}\n transition t1 {{ from A to j {} {} }}\n",
                        maybe("action", 2), trigger(), guard());
    for (int t = 2; t < 8; ++t)
        text += fmt::format(" transition t{} {{ from {} to {} {} {}{} }}\n", t, any({"A", "B", "C"}),
                            any({"A", "B", "C", "j"}), trigger(), guard(), maybe("action", 2));
    return text + fmt::format(" transition t8 {{ from j to B {} }}\n transition t9 {{ from j to C {} }}\n}}\n", guard(),
                              guard());
}

/// The model refines the model with free values. So deadlock, divergence and timelock freedom carry over to the model,
/// and a state that is not reached with free values is not reached in the model.
TEST(FreeModels, WhatHoldsWithFreeValuesHoldsInTheFiniteInstantiation) {
    Draw draw(2026);
    std::size_t carried = 0, failing = 0, conditions = 0;
    for (std::size_t round = 0; round < tests::rounds(20); ++round) {
        const std::string model = draw.machine();
        const Both both = answers_for(model);
        conditions += both.conditions;
        for (const auto& [claim, found] : both.free) {
            if (claim.ends_with("deterministic") || claim.ends_with("fires")) continue;
            const bool reach = claim.ends_with("is reachable");
            const Found& concrete = both.concrete.at(claim);
            const bool fails = concrete.answer == (reach ? Answer::holds : Answer::fails);
            failing += fails ? 1U : 0U;
            if (found.answer != (reach ? Answer::fails : Answer::holds)) continue;
            ++carried;
            EXPECT_TRUE(!fails || concrete.bounded) << claim << "\n" << model;
        }
    }
    EXPECT_GT(conditions, tests::rounds(20));
    EXPECT_GT(carried, tests::rounds(20));
    EXPECT_GT(failing, tests::rounds(20));
}

// ---------------------------------------------------------------- what must not be done

std::string machine(const std::string& parts) {
    return "stm S { event e : nat event go event stop var x : nat = 3 var y : nat = 0 initial i " + parts + " }";
}
constexpr auto deadlock = "S deadlock-free";

void expect_deadlock(const Both& both) {
    EXPECT_EQ(both.concrete.at(deadlock).answer, Answer::fails);
    const auto free = both.free.find(deadlock);
    EXPECT_TRUE(free == both.free.end() || free->second.answer != Answer::holds);
}

/// A transition may interrupt a during action after an assignment. The condition must then be evaluated for the new
/// value. Here x * x < 4 is false for the 3 of the entry action, and true for the 0 of y.
TEST(FreeModels, AnInterruptedDuringActionLeavesNewAnswers) {
    for (const char* const during : {"x = (y * y) % 4", "e ? x"}) {
        const Both both = answers_for(machine(
            fmt::format("state A {{ entry x = 3 during {} }} state B {{ }} transition t0 {{ from i to A }} "
                        "transition t1 {{ from A to B trigger go }} transition t2 {{ from B to A trigger go condition "
                        "x * x >= 4 }}",
                        during)));
        expect_deadlock(both);
        EXPECT_EQ(both.conditions, 1U);
    }
}

/// After a value is received or assigned, the condition does not keep the answer of the old value.
TEST(FreeModels, EveryWriteChoosesAnswersAnew) {
    for (const char* const write : {"trigger e ? x", "trigger go action x = (y * y) % 4", "trigger go action e ? x"}) {
        const Both both = answers_for(
            machine(fmt::format("state A {{ entry x = 3 }} state B {{ }} transition t0 {{ from i to A }} "
                                "transition t1 {{ from A to B {} }} transition t2 {{ from B to A trigger go condition "
                                "x * x >= 4 }}",
                                write)));
        expect_deadlock(both);
        EXPECT_EQ(both.conditions, 1U);
    }
}

/// An exit action runs before the transition's action, and so before the answer for the received value is chosen.
TEST(FreeModels, AnExitActionThatTestsAReceivedValueIsNotFree) {
    const Both both = answers_for(
        machine("var stuck : boolean = false state A { exit if x * x < 4 then stuck = true else stuck = false end } "
                "state B { } state C { } transition t0 { from i to A } transition t1 { from A to B trigger e ? x } "
                "transition t2 { from B to C trigger go condition not stuck } "
                "transition t3 { from C to C trigger stop }"));
    expect_deadlock(both);
}

/// A guard on the received value decides which inputs are possible. If its answers were chosen freely, the process
/// would offer inputs that no value causes.
TEST(FreeModels, AGuardOnTheReceivedValueIsNotFree) {
    const Both both = answers_for(
        machine("state A { } state B { } transition t0 { from i to A } "
                "transition t1 { from A to B trigger e ? x condition x * x < y } transition t2 { from B to A "
                "trigger go action y = (x * x) % 4 }"));
    expect_deadlock(both);
    EXPECT_EQ(both.conditions, 0U);
}

/// A statement blocks if its condition is undefined. Here, head is applied to the tail of the empty sequence.
TEST(FreeModels, AnUndefinedStatementMayBlock) {
    const Both both = answers_for(
        "import sequence_toolkit::* stm S { event go var s : Seq(nat) = <1> var b : boolean = true initial i "
        "state A { } transition t0 { from i to A } "
        "transition t1 { from A to A trigger go action s = tail(s) ; if head(s) > 1 then b = true else b = false end } "
        "}");
    expect_deadlock(both);
}

/// Another machine may write a shared variable at any time, without choosing the answer of the condition.
TEST(FreeModels, AConditionOnASharedVariableIsNotFree) {
    const Both both = answers_for(
        "interface I { var x : nat } stm S { requires I event go initial i state A { } "
        "transition t0 { from i to A } "
        "transition t1 { from A to A trigger go condition x * x >= 4 } }");
    EXPECT_EQ(both.conditions, 0U);
}

/// The class of a computed number or list follows from the class of the number or list that it is computed from.
TEST(FreeModels, TheClassOfAComputedValueFollowsTheComputation) {
    struct Row {
        const char *start, *step, *wrong;
        bool possible;
    };
    const Row rows[] = {
        {"n = 0", "n = n + 1", "n < 0", false},
        {"n = 0", "n = n - 1", "n < 0", true},
        {"n = 1", "n = 2 * n", "n <= 0", false},
        {"n = 1", "n = 1 - 2 * n", "n == 0", false},
        {"n = 1", "n = 1 - n", "n == 0", true},
        {"n = 4", "n = if n > 2 then n - 1 else n end", "n < 2", false},
        {"n = 4", "n = if n > 2 then n - 3 else n end", "n < 2", true},
        {"s = <1>", "s = s ^ <2>", "s == <>", false},
        {"s = <1>", "s = tail(s)", "s == <>", true},
        {"s = <1, 2>", "s = tail(<3> ^ s)", "size(s) < 2", false},
        {"s = <1, 2>", "s = front(tail(<3> ^ s))", "size(s) < 2", true},
    };
    for (const Row& row : rows) {
        const Both both = answers_for(
            fmt::format(
                "import sequence_toolkit::* stm S {{ event go var n : int var s : Seq(nat) initial i state A {{ }} "
                "state Wrong {{ }} transition t0 {{ from i to A action {} }} "
                "transition t1 {{ from A to A trigger go action {} }} "
                "transition t2 {{ from A to Wrong condition {} }} }}",
                row.start, row.step, row.wrong),
            true);
        const Answer expected = row.possible ? Answer::holds : Answer::fails;
        EXPECT_EQ(both.free.at("S Wrong is reachable").answer, expected) << row.step << ", " << row.wrong;
    }
}

/// If one guard is the negation of another, both depend on one answer.
TEST(FreeModels, AConditionAndItsNegationExcludeEachOther) {
    const Both both = answers_for(machine(
        "state A { } junction j state B { } transition t0 { from i to A } "
        "transition t1 { from A to j trigger e ? x } transition t2 { from j to B condition x * x < y } "
        "transition t3 { from j to A condition y <= x * x } transition t4 { from B to A trigger go action y = x }"));
    EXPECT_EQ(both.conditions, 1U);
    EXPECT_EQ(both.free.at(deadlock).answer, Answer::holds);
}

}  // namespace
}  // namespace robochart::driver
