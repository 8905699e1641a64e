// SPDX-License-Identifier: Apache-2.0
// Compares packed states with the terms that they encode. Both must give the same graph, the same answers and the same
// errors, even if the script is loaded again during the search.
#include <gtest/gtest.h>

#include "checker/cspm/packed/not_packed.hpp"
#include "checker/cspm/packed/packed_system.hpp"
#include "checker/cspm/session.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "checker/lts/graph.hpp"
#include "checker/process/term_system.hpp"
#include "tests/checker/cspm/support.hpp"

namespace robochart::cspm::test {
namespace {

constexpr std::size_t never = 1U << 30U;

/// A process X of a script.
struct Case {
    std::string name;
    std::string text;
};

const std::vector<Case>& cases() {
    static const std::vector<Case> all{
        {"Numbers", R"(channel inc, dec : {0..1}
X = C(0, -3)
C(x, y) = x < 4 & inc.0 -> C(x + 1, y) [] y < 2 & inc.1 -> C(x, y + 1)
 [] x > 0 & dec.0 -> C(x - 1, y) [] y > -3 & dec.1 -> C(x, y - 1))"},
        {"LargeNumbers", R"(channel a, b
X = P(1, -1)
P(m, n) = m < 4000000000000000000 & a -> P(2 * m, n) [] n > -300000 & b -> P(m, 3 * n))"},
        {"TruthValuesAndCharacters", R"(channel flip, next
X = P(false, 'a')
P(b, c) = flip -> P(not b, c) [] c == 'a' & next -> P(b, 'z') [] c == 'z' & next -> P(not b, 'a'))"},
        {"TuplesAndSequences", R"(channel put, get : {0..2}
X = Buffer(<>, (0, <>))
Buffer(s, (n, seen)) = #s < 3 & put?x -> Buffer(s ^ <x>, ((n + x) % 3, seen))
  [] not null(s) & get!head(s) -> Buffer(tail(s), (n, <head(s)>)))"},
        {"SetsAndMaps", R"(channel add, drop : {0..3}
channel swap
X = S({}, emptyMap)
S(s, m) = add?x:diff({0..3}, s) -> S(union(s, {x}), m)
  [] drop?x:s -> S(diff(s, {x}), if x == 0 then mapUpdate(m, card(s), s) else m)
  [] s == {1, 2} & swap -> S({{}} == {{}} & {0}, emptyMap))"},
        {"Datatypes", R"(datatype Shape = Dot | Line.{0..2} | Pair.Small.Bool
datatype Small = One | Two
channel show : Shape
X = P(Dot)
P(Dot) = show.Dot -> P(Line.0)
P(Line.n) = show.Line.n -> (if n < 2 then P(Line.(n + 1)) else P(Pair.One.true))
P(Pair.x.b) = show!Pair.x.b -> P(if x == One then Pair.Two.not(b) else Dot))"},
        {"FunctionsAsArguments", R"(channel a : {0..4}
add(n)(m) = (n + m) % 5
X = P(\ x @ x, 0)
P(f, n) = a!f(n) -> (if n == 0 then P(add(2), 1) else P(\ x @ (x + n) % 5, (n + 1) % 4)))"},
        {"LetsAndLocalDefinitions", R"(channel a, b : {0..3}
X = P(0)
P(n) = let next = (n + 1) % 4
           Q(m) = b!m -> (if m == n then P(next) else Q((m + 1) % 4))
           R = b.n -> P(next)
       within a.n -> (Q(next) [] a.next -> R))"},
        {"ProcessesAsArguments", R"(channel a, b : {0..2}
X = Twice(a.0 -> STOP, 0)
Twice(P, n) = b.n -> (P [] (n < 2 & b.2 -> Twice(a.n -> P, n + 1))))"},
        {"PrefixesBetweenCalls", R"(channel a, b : {0..2}
channel c : {0..2}.{0..2}
X = P(1)
P(n) = a?x -> b!x -> c.n?y:{0..x} -> (c!x!y -> P(y) [] b.0 -> SKIP))"},
        {"ChoicesOfAllKinds", R"(channel a, b : {0..2}
X = P(0)
P(n) = ([] x : {0..2} @ a.x -> Q(x)) [] ([] x : {} @ b.x -> STOP) [] b$y -> P(y)
Q(n) = a.n -> P(n) |~| b.n -> Q((n + 1) % 3) |~| (if n == 2 then STOP else SKIP))"},
        {"ChoicesWithTaus", R"(channel a, b : {0..2}
X = P(0)
P(n) = (a.n -> P((n + 1) % 3) |~| STOP) [] b.n -> Q(n)
Q(n) = (b.0 -> SKIP ; P(n)) [> (a.n -> Q(0)))"},
        {"SequentialComposition", R"(channel a, b : {0..2}
X = P(2) ; b.0 -> SKIP ; P(1)
P(n) = if n == 0 then SKIP else a.n -> P(n - 1) ; b.n -> SKIP)"},
        {"HidingAndRenaming", R"(channel a, b, c : {0..2}
X = P(0) \ {|b|}
P(n) = a.n -> Q(n) [] b.n -> P((n + 1) % 3)
Q(n) = (R(n) \ {c.1}) [[a.0 <- a.1, a.0 <- a.2, c.2 <- b.2]]
R(n) = c?x -> R(x) [] a.0 -> R(n) [] n == 2 & b.0 -> SKIP)"},
        {"OtherOperators", R"(channel a, b, c : {0..2}
channel stop
X = (P(0) [| {|b|} |] P(1)) /\ stop -> STOP
P(n) = a.n -> b?x -> P(x) [] n == 2 & c.0 -> (Q(n) [| {c.1} |> SKIP)
Q(n) = c.n -> c.1 -> Q(0) ||| b.0 -> SKIP
Y = X [+ {a.0} +] X)"},
        {"RunsAndBuffers", R"(channel a, b : {0..1}
X = a.0 -> RUN({|b|}) [] a.1 -> CHAOS({b.0}) [] b.0 -> P(1)
P(n) = BUFFER(2, {(a.0, b.0), (a.1, b.1)}))"},
        {"ArgumentsThatNothingReads", R"(channel a : {0..2}
X = P(0, 7)
P(n, last) = a.n -> P((n + 1) % 3, n))"},
        {"Modules", R"(module Cell(T)
  Start = Empty
  Empty = put?x -> Full(x)
  Full(x) = get!x -> Empty [] put?y -> Full(y)
exports
  channel put, get : T
  C = Start
endmodule
instance Small = Cell({0..2})
X = Small::C)"},
        {"StatesThatGrow", R"(channel a : {0..1}
X = P(<>)
P(s) = #s < 60 & a!(#s % 2) -> P(s ^ <#s % 2>))"},
    };
    return all;
}

std::string script_of(const Case& test_case) {
    return test_case.text + "\nassert X :[deadlock free]\n";
}

class Loaded {
public:
    explicit Loaded(const Case& test_case) : reading_(script_of(test_case)) {
        EXPECT_TRUE(reading_.ok()) << reading_.report();
        session.emplace(reading_.script);
        assertion = session->assertions().front();
    }
    [[nodiscard]] const Script& script() const { return reading_.script; }
    std::optional<Session> session;
    DeclPtr assertion;

private:
    Reading reading_;
};

lts::Graph graph_of(lts::TransitionSystem& system) {
    const auto bound = [](std::size_t states) {
        if (states > 20'000) throw std::runtime_error("the process has too many states");
    };
    return lts::explore(system, bound).graph;
}

struct PackedGraph {
    lts::Graph graph;
    std::size_t loads;
    std::uint64_t direct_answers;
};

PackedGraph packed_graph(Loaded& loaded, const PackedProcesses::Settings& settings) {
    const ExprPtr process = loaded.assertion->assertion.specification;
    const auto processes = std::make_shared<PackedProcesses>(loaded.script(), loaded.session->event_table(), settings);
    PackedSystem system(processes, processes->add(process, *loaded.assertion), process->span);
    for (;;) {
        try {
            lts::Graph graph = graph_of(system);
            return {std::move(graph), processes->load_count(), processes->direct_answers()};
        } catch (const RowsTooNarrow&) {
            system.widen_rows();
        }
    }
}

TEST(PackedStatesTest, HaveTheGraphOfTheTerms) {
    for (const Case& test_case : cases()) {
        SCOPED_TRACE(test_case.name);
        Loaded loaded(test_case);
        process::OperationalSemantics semantics(loaded.session->terms());
        process::TermSystem terms(semantics, loaded.session->process(loaded.assertion->assertion.specification));
        const lts::Graph expected = graph_of(terms);
        EXPECT_GT(expected.size(), 2U);
        PackedProcesses::Settings settings;
        const PackedGraph direct = packed_graph(loaded, settings);
        EXPECT_TRUE(direct.graph == expected) << direct.graph.size() << " states, not " << expected.size();
        EXPECT_GT(direct.direct_answers, 0U);
        settings.terms_alone = true;
        const PackedGraph by_terms = packed_graph(loaded, settings);
        EXPECT_TRUE(by_terms.graph == expected) << by_terms.graph.size() << " states, not " << expected.size();
        EXPECT_EQ(by_terms.direct_answers, 0U);
    }
}

// The script is loaded again for each state, so terms, values, events and sets get different numbers each time.
TEST(PackedStatesTest, DoNotDependOnWhatIsKept) {
    for (const Case& test_case : cases()) {
        SCOPED_TRACE(test_case.name);
        Loaded loaded(test_case);
        PackedProcesses::Settings settings;
        const PackedGraph all_kept = packed_graph(loaded, settings);
        for (const bool terms_alone : {false, true}) {
            settings.terms_alone = terms_alone;
            settings.most_kept = 0;
            settings.forget_each_state = true;
            const PackedGraph forgetting = packed_graph(loaded, settings);
            EXPECT_EQ(forgetting.graph.size(), all_kept.graph.size());
            EXPECT_EQ(forgetting.graph.edge_count(), all_kept.graph.edge_count());
            EXPECT_GT(forgetting.loads, all_kept.graph.size());
        }
    }
}

/// Returns the answers to the assertions of a script, and the errors that end them.
std::vector<std::string> answers_of(const std::string& text, const Packing& packing) {
    Reading reading(text);
    EXPECT_TRUE(reading.ok()) << reading.report();
    Session session(reading.script);
    session.set_packing(packing);
    std::vector<std::string> result;
    refine::Limits limits;
    limits.max_states = 20'000;
    for (const DeclPtr& assertion : session.assertions()) {
        try {
            const refine::Verdict verdict = session.check(*assertion, limits).verdict;
            std::string line = verdict.outcome == refine::Outcome::holds ? "holds" : "fails";
            line += " " + std::to_string(verdict.statistics.states) + " " +
                    std::to_string(verdict.statistics.transitions) + " " + verdict.reason;
            if (verdict.counterexample) {
                line += " " + verdict.counterexample->initial;
                for (const refine::Step& step : verdict.counterexample->steps)
                    line += " " + session.event_table().name(step.event) + " " + step.state;
            }
            result.push_back(line);
        } catch (const EvaluationError& error) {
            std::string line = std::string(error.what()) + " at " + reading.sources.path_and_line(error.span);
            for (const std::string& call : error.stack) line += " in " + call;
            result.push_back(line);
        }
    }
    return result;
}

void expect_same_answers(const std::string& text, std::size_t assertions) {
    const std::vector<std::string> expected = answers_of(text, {never, std::nullopt, false});
    EXPECT_EQ(expected.size(), assertions);
    EXPECT_EQ(answers_of(text, {0, std::nullopt, false}), expected);
    EXPECT_EQ(answers_of(text, {0, std::nullopt, true}), expected);
    EXPECT_EQ(answers_of(text, {0, 0, false}), expected);
    EXPECT_EQ(answers_of(text, {10, 1, false}), expected);
}

TEST(PackedStatesTest, AssertionsOfAllKindsAreAnsweredAlike) {
    expect_same_answers(R"(channel a, b : {0..3}
channel t
P(n) = a.n -> P((n + 1) % 4) [] n == 2 & b.0 -> Q(n)
Q(n) = n < 3 & b.n -> Q(n + 1) [] n == 3 & t -> P(0)
L(n) = t -> L((n + 1) % 3) [] n == 0 & a.0 -> STOP
R(n) = a.n -> R((n + 1) % 4) |~| b.0 -> Q(2)
D(n) = a.0 -> D(n) [] a.0 -> (if n < 3 then D(n + 1) else STOP)
assert P(0) :[deadlock free]
assert Q(0) :[deadlock free]
assert L(0) :[deadlock free]
assert L(0) \ {t} :[divergence free]
assert P(0) \ {|b, t|} :[divergence free]
assert P(0) :[deterministic]
assert D(0) :[deterministic]
assert D(0) :[deadlock free [F]]
assert P(0) [T= P(0)
assert P(0) [FD= P(0)
assert R(0) [T= P(0)
assert P(0) [F= R(0)
assert P(1) [T= P(0)
assert Q(0) [FD= L(1)
assert RUN({|a, b, t|}) [T= R(0)
assert R(0) [T= RUN({|a|})
assert P(0) :[has trace [T]]: <a.0, a.1, b.0, b.2, t>
assert P(0) :[has trace [T]]: <a.0, a.1, b.0, b.1>
)",
                        18);
}

// An assertion has the scope of the place where it is written. In a timed section, time passes while events wait.
TEST(PackedStatesTest, ModulesTimedSectionsAndPriorities) {
    expect_same_answers(R"(channel a, b : {0..2}
channel tock
OneStep(_) = 1
module M
  limit = 2
  P(n) = n < limit & a.n -> P(n + 1) [] n == limit & b.0 -> P(0)
exports
  Out = P(0)
endmodule
Timed(OneStep) {
  T(n) = a.n -> T((n + 1) % 3) [] b?x -> (WAIT(x) ; SKIP ; T(x))
  U = a.0 -> STOP
  assert T(0) :[deadlock free]
  assert (\ n @ T(n))(1) [F= T(0)
  assert U :[deadlock free]
}
J(n) = a.n -> J((n + 1) % 3) [] tock -> J(n)
H(n) = J(n) \ {a.0}
assert M::Out [T= a.0 -> STOP
assert H(0) :[divergence free] :[tau priority]: {tock}
assert H(0) [T= H(1) :[tau priority]: {tock}
)",
                        6);
}

TEST(PackedStatesTest, FaultsAreThoseOfTheTerms) {
    expect_same_answers(R"(channel a : {0..5}
channel t
P(n) = a.n -> P(n + 1)
Q(n) = n < 3 & a.n -> Q(n + 1) [] n == 3 & a!(1 / 0) -> STOP
f(0) = 0
R(n) = t -> R(f(n) + 1)
S(n) = t -> (if n == 2 then error("no") else S(n + 1))
T(n) = n == 2 & T(n) [] n < 3 & t -> T(n + 1)
-- Two faults in one state: which of them is met first is the same.
U(n) = n == 1 & a!(7 / 0) -> STOP [] n / (1 - n) > 5 & t -> STOP [] n == 0 & t -> U(1)
assert P(0) :[deadlock free]
assert Q(0) :[deadlock free]
assert R(0) :[deadlock free]
assert S(0) :[deadlock free]
assert T(0) :[deadlock free]
assert U(0) :[deadlock free]
assert P(0) [T= RUN({t})
)",
                        7);
}

// A state after three steps has an error. The error does not occur, because a state after two steps has a deadlock and
// ends the search.
TEST(PackedStatesTest, NothingBehindTheFirstViolationIsEvaluated) {
    expect_same_answers(R"(channel a : {0..5}
P(n) = a.n -> (if n == 1 then STOP else P(n + 1)) [] a.0 -> Q(n)
Q(n) = n < 2 & a.n -> Q(n + 1) [] n == 2 & a.(1 / 0) -> STOP
assert P(0) :[deadlock free]
)",
                        1);
    EXPECT_TRUE(answers_of(R"(channel a : {0..5}
P(n) = a.n -> (if n == 1 then STOP else P(n + 1)) [] a.0 -> Q(n)
Q(n) = n < 2 & a.n -> Q(n + 1) [] n == 2 & a.(1 / 0) -> STOP
assert P(0) :[deadlock free]
)",
                           {0, std::nullopt, false})
                    .front()
                    .starts_with("fails"));
}

// Compressions, infinite sequences and sets of processes have no packed form, so the search uses terms for them.
TEST(PackedStatesTest, WhatHasNoBytesStaysATerm) {
    const std::string text = R"(transparent normal
channel a : {0..3}
C(n) = if n == 3 then normal(a.0 -> C(0)) else a.n -> C(n + 1)
S(s, n) = n < 3 & a!head(s) -> S(tail(s), n + 1)
M(ps) = a.0 -> M({a.1 -> STOP, STOP}) [] ([] p : ps @ p)
assert C(0) :[deadlock free]
assert S(<x % 4 | x <- <0..>>, 0) :[deadlock free]
assert M({STOP}) :[deadlock free]
)";
    expect_same_answers(text, 3);
    for (const char* process : {"C(0)", "S(<x % 4 | x <- <0..>>, 0)", "M({STOP})"}) {
        SCOPED_TRACE(process);
        Loaded loaded({"", text + "X = " + process});
        const ExprPtr expr = loaded.session->assertions().back()->assertion.specification;
        loaded.assertion = loaded.session->assertions().back();
        EXPECT_THROW((void)packed_graph(loaded, {}), NotPacked);
    }
}

TEST(PackedStatesTest, TakeLittleMemory) {
    const std::string text = R"(channel inc : {0..2}
C(x, y, z) = x < 40 & inc.0 -> C(x + 1, y, z) [] y < 40 & inc.1 -> C(x, y + 1, z) [] z < 40 & inc.2 -> C(x, y, z + 1)
assert C(0, 0, 0) :[deadlock free]
)";
    Reading reading(text);
    Session session(reading.script);
    session.set_packing({1000, std::nullopt, false});
    const refine::Verdict verdict = session.check(*session.assertions().front(), {}).verdict;
    EXPECT_EQ(verdict.statistics.states, 41U * 41U * 41U);
    EXPECT_LT(session.terms().size(), 5000U)
        << "the session itself has only the terms of the first states, and the run";
}

}  // namespace
}  // namespace robochart::cspm::test
