// SPDX-License-Identifier: Apache-2.0
// Tests the verb `cspm` as users of FDR's `refines` see it: its JSON, its plain text, limits, progress, exports.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <algorithm>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "app/command/progress.hpp"
#include "tests/app/command.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::app::testing::refines_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* failing = R"(channel a, b, c, h
P = a -> h -> b -> STOP
Q = h -> c -> Q
SYSTEM = (P [| {h} |] Q) \ {h}
SPEC = a -> (b -> SPEC [] c -> SPEC)
assert SPEC [T= SYSTEM
assert SPEC [F= SYSTEM
assert SYSTEM :[deadlock free [F]]
assert SYSTEM [T= STOP
LOOP = h -> LOOP
assert not (LOOP \ {h}) :[divergence free]
assert (a -> STOP [] a -> b -> STOP) :[deterministic [F]]
print 1 + 2
)";

std::vector<Json> lines(const std::string& text) {
    std::vector<Json> result;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) result.push_back(Json::parse(line));
    return result;
}

Json refines(const std::string& path, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{"cspm", path, "--format", "json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ran ran = run(arguments);
    const std::vector<Json> objects = lines(ran.out);
    EXPECT_EQ(objects.size(), 1U) << ran.out << ran.err;
    return objects.empty() ? Json::object() : objects.front();
}

/// Translates a list of event numbers to names, with the map of the same object.
std::vector<std::string> named(const Json& object, const Json& numbers) {
    std::vector<std::string> names;
    for (const Json& number : numbers) names.push_back(object["event_map"][std::to_string(number.get<int>())]);
    return names;
}

TEST(Refines, ResultsAreNumbersAsWorded) {
    const TemporaryFile script("failing.csp", failing);
    const Json object = refines(script.path());
    EXPECT_EQ(object["file_name"], script.path());
    std::vector<Json> results;
    for (const Json& result : object["results"]) results.push_back(result["result"]);
    // In T, b and c are possible in any order after a and the hidden h. SPEC allows one of them and then a again.
    EXPECT_THAT(results, ElementsAre(0, 0, 0, 1, 1, 0));
    EXPECT_EQ(object["results"][4]["is_negated"], 1);
    EXPECT_EQ(object["results"][0]["assertion_string"], "SPEC [T= SYSTEM");
    EXPECT_EQ(object["print_statement_results"][0]["result"], "3");
    EXPECT_EQ(object["event_map"]["1"], "τ");
    EXPECT_EQ(object["event_map"]["2"], "✓");
}

// Some components take no step, and another component does. The test compares every format. A compressed component has
// its own trace, so the last event of the whole is not one of its events.
TEST(Refines, PartsThatTakeNoStepAreReported) {
    const TemporaryFile script("idle.csp", R"(transparent normal, sbisim
channel a, b
assert STOP [T= normal(STOP) [] a -> STOP
assert RUN({b}) [T= sbisim(a -> STOP) ||| sbisim(b -> STOP)
assert b -> STOP [T= normal(b -> STOP) ||| (b -> a -> STOP)
assert normal(b -> STOP) ||| sbisim(STOP) :[deadlock free [F]]
D = a -> D
assert sbisim(b -> STOP) ||| (normal(D) \ {a}) :[divergence free]
)");
    const Json object = refines(script.path(), {"--reveal-taus"});
    ASSERT_EQ(object["results"].size(), 5U);
    const auto part = [&](int result, std::size_t which) -> Json {
        const Json whole =
            object["results"][static_cast<std::size_t>(result)]["counterexamples"][0]["implementation_behaviour"];
        return whole["child_behaviours"][which];
    };
    const auto events = [&](const Json& behaviour) { return named(object, behaviour["trace"]); };
    const auto offence = [&](const Json& behaviour) {
        return named(object, Json::array({behaviour["error_event"]})).front();
    };
    EXPECT_EQ(offence(part(0, 0)), "0") << "normal(STOP) did nothing, then nothing else than a";
    EXPECT_THAT(events(part(0, 0)["child_behaviours"][0]), IsEmpty());
    EXPECT_EQ(offence(part(0, 1)), "a");
    EXPECT_EQ(offence(part(1, 0)["child_behaviours"][0]), "a") << "inside the compression too";
    EXPECT_EQ(offence(part(1, 1)["child_behaviours"][0]), "0");
    for (const char* format : {"plain", "text", "framed_json", "json"}) {
        const Ran ran = run({"cspm", script.path(), "--format", format, "--split"});
        EXPECT_EQ(ran.exit, 1) << format << ran.err;
        EXPECT_FALSE(ran.out.empty());
    }
}

// Earlier versions hung on these inputs. Each run must end by its limit, with its partial results.
TEST(Refines, LimitsEndEveryPhase) {
    const TemporaryFile prints("prints.csp", R"(print 1 + 1
print card({(x, y, z) | x <- {0..200}, y <- {0..200}, z <- {0..100}})
f(0) = 1
f(n) = f(n - 1) + f(n - 1)
print f(60)
print 2 + 2
)");
    const Json reported = refines(prints.path(), {"--timeout", "1"});
    EXPECT_EQ(reported["print_statement_results"][0]["result"], "2");
    EXPECT_EQ(run({"cspm", prints.path(), "--timeout", "1"}).exit, 3);
    const TemporaryFile endless("endless.csp", R"(transparent normal
channel a, b, c
P(n) = a -> P(n + 1) [] b -> normal(a -> b -> STOP) [] c -> (P(n) ||| P(n + 1))
assert normal(P(0)) :[deadlock free [F]]
assert P(0) ||| P(1) :[deadlock free [F]]
N(n) = [] x : {0..40} @ a -> N(n + x)
assert ([|{a}|] x : {0..30} @ N(x)) :[deadlock free [F]]
)");
    const Json stopped = refines(endless.path(), {"--timeout", "1", "--max-states", "20000"});
    ASSERT_EQ(stopped["results"].size(), 3U);
    for (const Json& result : stopped["results"]) EXPECT_TRUE(result["result"].is_null()) << result;
}

TEST(Refines, ATraceCounterexampleIsSplit) {
    const TemporaryFile script("failing.csp", failing);
    const Json object = refines(script.path(), {"--assertion", "1", "--reveal-taus"});
    ASSERT_EQ(object["results"].size(), 1U);
    const Json& reported = object["results"][0]["counterexamples"][0];
    EXPECT_EQ(reported["type"], "trace");
    EXPECT_EQ(reported["replayed_by"], "terms");
    const Json& implementation = reported["implementation_behaviour"];
    EXPECT_EQ(implementation["machine_name"], "SYSTEM");
    EXPECT_THAT(named(object, implementation["trace"]), ElementsAre("a", "τ", "b"));
    EXPECT_THAT(named(object, implementation["revealed_trace"]), ElementsAre("a", "h", "b"));
    EXPECT_EQ(named(object, Json::array({implementation["error_event"]})).front(), "c");
    // SYSTEM = (P [|{h}|] Q) \ {h}: the parallel composition is below the hiding, and P and Q are below the parallel
    // composition.
    const Json& parallel = implementation["child_behaviours"][0];
    EXPECT_THAT(named(object, parallel["trace"]), ElementsAre("a", "h", "b"));
    const Json& p = parallel["child_behaviours"][0];
    const Json& q = parallel["child_behaviours"][1];
    EXPECT_EQ(p["machine_name"], "P");
    EXPECT_THAT(named(object, p["trace"]), ElementsAre("a", "h", "b"));
    EXPECT_EQ(p["error_event"], 0) << "P does not take part in c";
    EXPECT_EQ(q["trace"][0], 0);
    EXPECT_EQ(named(object, Json::array({q["error_event"]})).front(), "c");
    const Json& specification = reported["specification_behaviour"];
    EXPECT_EQ(specification["machine_name"], "SPEC");
    EXPECT_THAT(named(object, specification["trace"]), ElementsAre("a", "b"));
    EXPECT_THAT(named(object, specification["allowed"][0]), ElementsAre("a"));
}

TEST(Refines, FailuresLoopsAndDeadlocksHaveTheirFields) {
    const TemporaryFile script("failing.csp", failing);
    const Json object = refines(script.path());
    const auto behaviour = [&](std::size_t number) {
        return object["results"][number]["counterexamples"][0]["implementation_behaviour"];
    };
    EXPECT_EQ(object["results"][2]["counterexamples"][0]["type"], "deadlock");
    EXPECT_EQ(behaviour(2)["acceptance"], Json::array());
    EXPECT_EQ(object["results"][4]["counterexamples"][0]["type"], "divergence");
    EXPECT_EQ(behaviour(4)["type"], "loop");
    EXPECT_EQ(behaviour(4)["loop_start"], 0);
    EXPECT_THAT(named(object, behaviour(4)["trace"]), ElementsAre("τ"));
    EXPECT_EQ(object["results"][5]["counterexamples"][0]["type"], "determinism");
}

// Before the hidden h, the process accepts l. After h, it refuses l.
TEST(Refines, DeterminismIsShownByTwoRuns) {
    const TemporaryFile script("leak.csp", R"(channel h, l
Leak = (h -> STOP [] l -> STOP) \ {h}
assert Leak :[deterministic [F]]
)");
    const Json object = refines(script.path());
    const Json& reported = object["results"][0]["counterexamples"][0];
    EXPECT_THAT(named(object, reported["implementation_behaviour"]["trace"]), ElementsAre("τ"));
    EXPECT_EQ(named(object, Json::array({reported["event"]})).front(), "l");
    EXPECT_THAT(named(object, reported["accepting_behaviour"]["trace"]), ElementsAre("l"));
    EXPECT_EQ(reported["accepting_behaviour"]["states"].size(), 2U);
    const std::string text = run({"cspm", script.path()}).out;
    EXPECT_THAT(text, AllOf(HasSubstr("trace <τ>\n"), HasSubstr("then refuses l: the state offers {}\n"),
                            HasSubstr("and accepts l after <>\n")));
    EXPECT_THAT(run({"cspm", script.path(), "--format", "plain"}).out, HasSubstr("Accepted: <l>\n"));
}

// A process that can terminate may do so without its environment, so its minimal acceptance is {✓}, even if it also
// offers other events.
TEST(Refines, TheLeastAcceptanceOfWhatCanTerminate) {
    const TemporaryFile script("tick.csp", "channel a\nassert SKIP [] a -> STOP :[deterministic [F]]\n");
    const Json object = refines(script.path());
    const Json& reported = object["results"][0]["counterexamples"][0]["implementation_behaviour"];
    EXPECT_THAT(named(object, reported["acceptance"]), ElementsAre("✓"));
    EXPECT_THAT(run({"cspm", script.path()}).out, HasSubstr("then refuses a: the state offers {✓}"));
}

// A specification that performs taus forever has no stable failures. In the failures model, no implementation with a
// stable state refines it.
TEST(Refines, ASpecificationWithoutStableStates) {
    const TemporaryFile script("restless.csp", R"(channel a, h
Restless = (h -> Restless0) \ {h}
Restless0 = h -> Restless0 [] a -> STOP
assert Restless [F= a -> STOP
assert Restless [F= STOP
assert Restless [T= STOP
assert STOP [T= a -> STOP
)");
    const Ran ran = run({"cspm", script.path()});
    EXPECT_THAT(ran.out, AllOf(HasSubstr("then is stable and offers {a}; the specification has no stable state"),
                               HasSubstr("then is stable and offers {}; the specification has no stable state"),
                               HasSubstr("where the specification allows no event, so not a"),
                               HasSubstr("1 of 4 checks hold, 3 fail")));
    EXPECT_THAT(run({"cspm", script.path(), "--format", "plain"}).out, HasSubstr("Allowed: no stable state\n"));
}

// A `print` that fails is an error of the script. The assertions are still decided.
TEST(Refines, APrintThatFailsIsSaid) {
    const TemporaryFile script("prints.csp", "print 1 / 0\nassert STOP [T= STOP\n");
    const Ran ran = run({"cspm", script.path()});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.out, AllOf(HasSubstr("division by zero"), HasSubstr("1 of 1 checks hold")));
    EXPECT_EQ(run({"cspm", script.path(), "--format", "json"}).exit, 2);
}

TEST(Refines, FaultsArePlacedWhereTheyAre) {
    const TemporaryFile recursion("recursion.csp",
                                  "channel a\nQ = R\nR = Q\nP = a -> STOP [] Q\nassert P :[deadlock free]\n");
    const Ran ran = run({"cspm", recursion.path()});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.out, AnyOf(HasSubstr("recursion.csp:2: the process"), HasSubstr("recursion.csp:3: the process")));
    const TemporaryFile open("open.csp", "channel a\nQ(x) = if x > 2 then STOP\n\nP = a -> P\n");
    EXPECT_THAT(run({"cspm", open.path()}).err, HasSubstr("open.csp:2:"));
}

// Calls that differ only in an argument that is never read denote the same process. A counterexample still shows the
// values of the argument.
TEST(Refines, ArgumentsThatNothingReadsAreShown) {
    const TemporaryFile script("unread.csp", R"(channel a, b : {0..1}
P(i, c, x) = a.x -> Done(i, c)
Done(i, c) = b.0 -> Done(i, 'y')
assert STOP [T= P(1, 'x', 0) ||| P(0, 'z', 1)
assert (P(7, 'x', 0) \ {|a, b|}) :[divergence free]
)");
    const Json object = refines(script.path());
    const Json& parts = object["results"][0]["counterexamples"][0]["implementation_behaviour"]["child_behaviours"];
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0]["states"], Json::array({"P(1,'x',0)", "Done(1,'x')"}));
    EXPECT_EQ(parts[1]["machine_name"], "P(0,'z',1)");
    const std::string looping = object["results"][1].dump();
    EXPECT_THAT(looping, AllOf(HasSubstr("Done(_,_)"), Not(HasSubstr("'_'"))));
}

// In the failures-divergences model, every process refines a specification that diverges immediately. But the
// implementation must be a process, so it is an error if it cannot be evaluated.
TEST(Refines, WhatCannotBeEvaluatedRefinesNothing) {
    const TemporaryFile script("diverging.csp", R"(channel a : {1, 2}
L = a.1 -> L
Spec = L \ {|a|}
assert Spec [FD= a.3 -> STOP
assert Spec [FD= a.2 -> a.3 -> STOP
)");
    const Ran ran = run({"cspm", script.path()});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.out, AllOf(HasSubstr("a.3"), HasSubstr("1 of 2 checks hold, 1 cannot be evaluated")));
}

// The process performs fifty events in any order, so 1, 50 and 1,225 states are 0, 1 and 2 steps away. A limit of 3,000
// states stops the search within the next level.
TEST(Refines, ALimitSaysWhatIsKnown) {
    const TemporaryFile script("many.csp", R"(channel a : {0..49}
S = ||| i : {0..49} @ a.i -> STOP
assert S :[deadlock free [F]]
assert CHAOS({|a|}) [T= S
assert CHAOS({|a|}) [FD= S
assert STOP [T= STOP
)");
    const Ran ran = run({"cspm", script.path(), "--max-states", "3000", "--no-reduction", "--threads", "1"});
    EXPECT_EQ(ran.exit, 3);
    EXPECT_THAT(ran.out,
                AllOf(HasSubstr("the limit of 3000 states was reached; no violation in runs of up to 1 step\n"),
                      HasSubstr("no violation in runs of up to 1 step, divergence aside\n"),
                      HasSubstr("1 of 4 checks hold, 3 inconclusive")));
}

// A process with 61 * 59 * ... * 37 states, too many for --no-reduction, and two claims that are decided immediately.
const std::string too_large = R"(channel a, b, c, d, e, f, g : {0..60}
C(ch, n, m) = ch!n -> C(ch, (n + 1) % m, m)
Big = C(a,0,61) ||| C(b,0,59) ||| C(c,0,53) ||| C(d,0,47) ||| C(e,0,43) ||| C(f,0,41) ||| C(g,0,37)
Small = a!0 -> Small
assert Big :[deadlock free]
assert Small :[deadlock free]
assert STOP [T= Small
)";

TEST(Refines, OneThatIsNotDecidedDoesNotKeepTheOthersFromTheirAnswers) {
    const TemporaryFile script("large.csp", too_large);
    const Ran ran = run({"cspm", script.path(), "--no-cache", "--no-reduction", "--timeout", "4", "--format", "json"});
    EXPECT_EQ(ran.exit, 1);
    const Json results = Json::parse(ran.out)["results"];
    ASSERT_EQ(results.size(), 3U);  // in the order of the script
    EXPECT_EQ(results[0]["answer"], "inconclusive");
    EXPECT_THAT(results[0]["errors"][0].get<std::string>(), HasSubstr("no violation in runs of up to"));
    EXPECT_EQ(results[1]["answer"], "holds");
    EXPECT_EQ(results[2]["answer"], "fails");
    EXPECT_EQ(results[2]["counterexamples"].size(), 1U);
}

// A ring of hidden events in which each process waits for the one before it. Each process also has a visible event.
TEST(Refines, AnAnswerWithoutASearchSaysWhy) {
    const TemporaryFile script("ring.csp", R"(channel turn, work : {0..19}
Part(i) = turn.i -> work.i -> turn.((i + 1) % 20) -> Part(i)
First = turn.1 -> Part(0)
Ring = || i : {0..19} @ [{turn.i, turn.((i + 1) % 20), work.i}] if i == 0 then First else Part(i)
assert Ring \ {|turn|} :[divergence free]
assert Ring :[deterministic [FD]]
assert Ring :[deadlock free [F]]
)");
    const Json results = refines(script.path())["results"];
    ASSERT_EQ(results.size(), 3U);
    const auto decision = [&](std::size_t i) {
        return std::pair(results[i]["decided_by"].get<std::string>(), results[i]["visited_states"].get<int>());
    };
    EXPECT_EQ(decision(0), std::pair(std::string("no tau cycle"), 0));
    EXPECT_EQ(decision(1), std::pair(std::string("no choice"), 0));
    EXPECT_EQ(decision(2).first, "search");
    for (const Json& result : results) EXPECT_EQ(result["answer"], "holds");
    EXPECT_THAT(run({"cspm", script.path()}).out,
                AllOf(HasSubstr("no search was necessary: no cycle of hidden events is possible\n"),
                      HasSubstr("no search was necessary: no event is hidden, and each event has only one way")));
    EXPECT_THAT(run({"cspm", script.path(), "--format", "plain"}).out,
                HasSubstr("Decided By: no search was necessary: no cycle of hidden events"));
    for (const Json& result : refines(script.path(), {"--no-reduction"})["results"]) {
        EXPECT_EQ(result["decided_by"], "search");
        EXPECT_GT(result["visited_states"], 1);
        EXPECT_EQ(result["answer"], "holds");
    }
}

TEST(Refines, EachAssertionMayHaveATimeLimit) {
    const TemporaryFile script("large.csp", too_large);
    const Ran ran = run({"cspm", script.path(), "--no-cache", "--no-reduction", "--assertion-timeout", "1"});
    EXPECT_EQ(ran.exit, 1);
    EXPECT_THAT(ran.out, AllOf(HasSubstr("its time limit was reached (--assertion-timeout 1); no violation in runs"),
                               HasSubstr("--assertion-timeout gives each assertion more time"),
                               HasSubstr("1 of 3 checks hold, 1 fail, 1 inconclusive")));
}

TEST(Refines, OneThatReachesTheMemoryLimitDoesNotEndTheOthers) {
    const TemporaryFile script("large.csp", too_large);
    const Ran ran =
        run({"cspm", script.path(), "--no-cache", "--no-reduction", "--memory", "150MiB", "--timeout", "100"});
    EXPECT_EQ(ran.exit, 1) << ran.out << ran.err;
    EXPECT_THAT(ran.out, AllOf(HasSubstr("the memory limit of 150 MiB was reached"), HasSubstr("--disk DIR keeps"),
                               HasSubstr("1 of 3 checks hold, 1 fail, 1 inconclusive")));
}

// The memory of the script's session (its terms and values) is freed as well.
TEST(Refines, NeitherDoesOneWhoseTermsReachIt) {
    const TemporaryFile script("longer.csp", R"(channel a : {0..99}
N(s) = a?x -> N(s ^ <x>)
Small = a!0 -> Small
assert N(<>) :[divergence free]
assert Small :[deadlock free]
)");
    const Ran ran = run({"cspm", script.path(), "--no-cache", "--memory", "150MiB", "--timeout", "100"});
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("1 of 2 checks hold, 1 inconclusive"));
}

// P can perform the hidden `a` forever, so the failures model records no refusals in this state.
TEST(Refines, WhatTheFailuresModelDoesNotLookAtIsSaid) {
    const TemporaryFile script("restless.csp", R"(channel a, b
P = a -> P [] b -> P
Restless = P \ {a}
assert Restless :[deadlock free [F]]
assert Restless :[deterministic [F]]
assert RUN({b}) [F= Restless
assert RUN({b}) [T= Restless
assert RUN({a,b}) [F= P
)");
    const Ran ran = run({"cspm", script.path(), "--format", "json"});
    EXPECT_EQ(ran.exit, 0) << ran.out;
    const Json results = Json::parse(ran.out)["results"];
    ASSERT_EQ(results.size(), 5U);
    for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_EQ(results[i]["basis"].size(), 1U) << i;
        EXPECT_EQ(results[i]["basis"][0]["kind"], "neverAtRest");
    }
    EXPECT_FALSE(results[3].contains("basis")) << "traces refuse nothing";
    EXPECT_FALSE(results[4].contains("basis")) << "P comes to rest";
    EXPECT_THAT(run({"cspm", script.path()}).out, HasSubstr("rests on: it can go on internally for ever"));
}

// Only one search at a time can store its states in files, so the claims after it have to wait.
TEST(Refines, WhatWasNotBegunIsSaid) {
    const TemporaryFile script("large.csp", too_large);
    const Folder folder;
    const Ran ran =
        run({"cspm", script.path(), "--no-cache", "--no-reduction", "--timeout", "1", "--disk", folder / "kept"});
    EXPECT_EQ(ran.exit, 3);
    EXPECT_THAT(ran.out, AllOf(HasSubstr("not begun: the time limit was reached while deciding Big"),
                               Not(HasSubstr("while reading"))));
}

TEST(Refines, AScriptThatOnlyPrintsHasAFrame) {
    const TemporaryFile script("prints.csp", "print 1 + 2\n");
    const std::vector<Json> frames = lines(run({"cspm", script.path(), "--format", "framed_json"}).out);
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0]["print_statement_results"][0]["result"], "3");
}

/// Collects the names of all fields in a JSON value, with the path to each field.
void collect_fields(const Json& value, const std::string& above, std::set<std::string>& out) {
    if (value.is_array())
        for (const Json& element : value) collect_fields(element, above, out);
    if (!value.is_object()) return;
    for (const auto& [name, inside] : value.items()) {
        const std::string path = above + "/" + name;
        if (above != "/event_map") out.insert(path);
        collect_fields(inside, path, out);
    }
}

/// Reads a recorded file of FDR, which is a concatenation of JSON objects. Each object follows a "results":.
std::vector<Json> recorded_objects(const std::string& text) {
    std::vector<Json> result;
    const std::string mark = "\"results\": { \"copyright_notice\"";
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1)) {
        std::size_t end = text.find("\"errors\": []} }", text.find("\"event_map\"", at));
        if (end == std::string::npos) end = text.find("\"errors\":[]} }", text.find("\"event_map\"", at));
        EXPECT_NE(end, std::string::npos);
        const std::size_t begin = at + std::string("\"results\": ").size();
        result.push_back(Json::parse(text.substr(begin, text.find('}', end) + 1 - begin)));
    }
    return result;
}

TEST(Refines, EveryFieldOfARecordedRunIsOurs) {
    const fs::path recorded =
        tests::shared_folder() / "suite/robotool/accept/DuringAndDeadline2/fdr-4.2.7-recorded.json";
    if (!fs::exists(recorded)) GTEST_SKIP() << recorded << " is not here";
    std::ifstream in(recorded);
    std::ostringstream text;
    text << in.rdbuf();
    std::set<std::string> theirs;
    const std::vector<Json> objects = recorded_objects(text.str());
    ASSERT_EQ(objects.size(), 2U);
    for (const Json& object : objects) collect_fields(object, "", theirs);
    ASSERT_TRUE(theirs.contains("/results/counterexamples/implementation_behaviour/loop_start")) << "read in vain";
    const TemporaryFile script("failing.csp", failing);
    std::set<std::string> ours;
    collect_fields(refines(script.path()), "", ours);
    for (const std::string& field : theirs) EXPECT_TRUE(ours.contains(field)) << field;
}

TEST(Refines, BadScriptsAreJsonToo) {
    const TemporaryFile broken("broken.csp", "P = (\n");
    const Ran ran = run({"cspm", broken.path(), "--format", "json"});
    EXPECT_EQ(ran.exit, 2);
    const Json object = Json::parse(ran.out);
    EXPECT_THAT(object["errors"], Not(IsEmpty()));
    EXPECT_THAT(object["results"], IsEmpty());
}

TEST(Refines, SeveralScriptsGiveOneObjectEachAndTheWorstExit) {
    const TemporaryFile good("good.csp", "assert SKIP [T= STOP\n");
    const TemporaryFile bad("bad.csp", "assert STOP :[deadlock free]\n");
    const Ran ran = run({"cspm", good.path(), bad.path(), "--format", "json"});
    EXPECT_EQ(ran.exit, 1);
    const std::vector<Json> objects = lines(ran.out);
    ASSERT_EQ(objects.size(), 2U);
    EXPECT_EQ(objects[0]["results"][0]["result"], 1);
    EXPECT_EQ(objects[1]["results"][0]["result"], 0);
}

TEST(Refines, FramesAreOneAnAssertion) {
    const TemporaryFile script("failing.csp", failing);
    const std::vector<Json> frames = lines(run({"cspm", script.path(), "--format", "framed_json"}).out);
    ASSERT_EQ(frames.size(), 6U);
    for (const Json& frame : frames) EXPECT_EQ(frame["results"].size(), 1U);
    EXPECT_EQ(frames[3]["results"][0]["number"], 4);
}

TEST(Refines, PlainTextIsGreppable) {
    const TemporaryFile script("failing.csp", failing);
    const Ran brief = run({"cspm", "--brief", "--quiet", "--format", "plain", script.path()});
    EXPECT_THAT(brief.out, HasSubstr("SPEC [T= SYSTEM: Failed\n"));
    EXPECT_THAT(brief.out, HasSubstr("SYSTEM [T= STOP: Passed\n"));
    EXPECT_EQ(std::ranges::count(brief.out, '\n'), 6);
    const Ran whole = run({"cspm", "--format", "plain", script.path(), "--assertion", "1"});
    EXPECT_THAT(whole.out, AllOf(HasSubstr("    Result: Failed\n"), HasSubstr("Visited States:"),
                                 HasSubstr("Trace: <a, b>"), HasSubstr("Error Event: c")));
}

TEST(Refines, TextShowsWhatEachPartDid) {
    const TemporaryFile script("failing.csp", failing);
    const Ran ran = run({"cspm", script.path(), "--assertion", "1"});
    EXPECT_THAT(ran.out, AllOf(HasSubstr("trace <a, τ, b, c>"), HasSubstr("does not allow c, only {a}"),
                               HasSubstr("P  <a, h, b>, now STOP offering {}"), HasSubstr("Q  <h, c>")));
    EXPECT_THAT(run({"cspm", script.path(), "--assertion", "1", "--reveal-taus"}).out, HasSubstr("τ(h)"));
}

TEST(Refines, StandardInputIsAScriptThatMayInclude) {
    const TemporaryFile included("included.csp", "channel a\nP = a -> P\n");
    const Ran ran = run({"cspm", "-"}, "include \"" + included.path() + "\"\nassert P :[deadlock free]\n");
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
    EXPECT_EQ(run({"cspm", "-"}, "include \"nobody.csp\"\n").exit, 2);
}

TEST(Refines, SeveralAssertionsAreDecidedInTheOrderOfTheScript) {
    const TemporaryFile script("several.csp",
                               "assert STOP :[divergence free]\nassert STOP :[deadlock free]\n"
                               "assert SKIP :[divergence free]\n");
    const Ran ran =
        run({"cspm", "--brief", "--quiet", "--format", "plain", script.path(), "--assertion", "3", "--assertion", "2"});
    EXPECT_EQ(ran.out, "STOP :[deadlock free]: Failed\nSKIP :[divergence free]: Passed\n");
    EXPECT_EQ(run({"cspm", script.path(), "--assertion", "1", "--assertion", "4"}).exit, 4);
}

TEST(Refines, AnAssertionThatIsNotThereIsSaid) {
    const TemporaryFile script("failing.csp", failing);
    const Ran ran = run({"cspm", script.path(), "--assertion", "7"});
    EXPECT_EQ(ran.exit, 4);
    EXPECT_THAT(ran.err, HasSubstr("--assertion 7: " + script.path() + " has 6 assertions"));
    EXPECT_EQ(run({"cspm", script.path(), "--assertion", "first"}).exit, 4);
}

// ---------------------------------------------------------------- limits

constexpr const char* wide =
    "channel t : {0..11}.{0..3}\nC(i,k) = t.i.k -> C(i,(k+1)%4)\n"
    "SYSTEM = ||| i:{0..11} @ C(i,0)\nassert SYSTEM :[deadlock free [F]]\n";

TEST(Limits, AreInconclusiveWithFigures) {
    const TemporaryFile script("wide.csp", wide);
    for (const std::vector<std::string>& limit : {std::vector<std::string>{"--no-reduction", "--max-states", "5000"},
                                                  {"--no-reduction", "--timeout", "0.2"},
                                                  {"--no-reduction", "--memory", "80MiB"}}) {
        const Json object = refines(script.path(), limit);
        const Json& result = object["results"][0];
        EXPECT_TRUE(result["result"].is_null()) << limit[0];
        EXPECT_EQ(result["answer"], "inconclusive");
        EXPECT_THAT(result["errors"][0].get<std::string>(), HasSubstr("limit"));
        EXPECT_GT(result["visited_states"], 1000) << limit[0];
    }
    EXPECT_EQ(run({"cspm", script.path(), "--no-reduction", "--max-states", "5000"}).exit, 3);
}

// A sequential process with 10^8 states: all the time goes into compilation.
constexpr const char* endless =
    "channel a, b\nP(n) = a -> P(n+1) [] b -> P(n+2)\nassert P(0) ||| P(1) :[deadlock free [F]]\n";
// Only the evaluation of this script takes time.
constexpr const char* thinking =
    "f(n) = if n == 0 then 0 else f(n-1)\ng(n) = if n == 0 then 0 else g(n-1) + f(150)\n"
    "h(n) = if n == 0 then 0 else h(n-1) + g(150)\nk(n) = if n == 0 then 0 else k(n-1) + h(150)\n"
    "P = if k(150) == 0 then STOP else SKIP\nassert P :[deadlock free [F]]\n";

TEST(Limits, HoldWhileEvaluating) {
    const TemporaryFile script("thinking.csp", thinking);
    const Ran ran = run({"cspm", script.path(), "--timeout", "0.3"});
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("time limit"));
}

TEST(Limits, WhileCompilingTellTheComponentInALine) {
    std::string wide_menu =
        "channel a, tick_tock_tick_tock_tick_tock_tick_tock_tick_tock_tick_tock_tick_tock_tick_tock_tick_tock\n";
    wide_menu +=
        "P(n) = a -> P(n+1) [] "
        "tick_tock_tick_tock_tick_tock_tick_tock_tick_tock_tick_tock_tick_tock_tick_tock_tick_tock -> P(n+2)\n";
    const TemporaryFile script("endless.csp", wide_menu + "assert P(0) ||| P(1) :[deadlock free [F]]\n");
    const Ran ran = run({"cspm", script.path(), "--timeout", "0.15"});
    EXPECT_EQ(ran.exit, 3);
    EXPECT_THAT(ran.out,
                AllOf(HasSubstr("while compiling"), HasSubstr("states of a → …"), HasSubstr("…, component 1 of 2")));
}

class Signal : public ::testing::TestWithParam<std::tuple<const char*, int>> {};

TEST_P(Signal, EndsWithWhatIsKnown) {
    const auto [text, signal] = GetParam();
    const TemporaryFile script("long.csp", text);
    const Ran ran = run_and_signal({"cspm", "--no-reduction", script.path()}, signal);
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("interrupted"));
}

INSTANTIATE_TEST_SUITE_P(Phases, Signal,
                         ::testing::Combine(::testing::Values(wide, endless, thinking),
                                            ::testing::Values(SIGINT, SIGTERM)));

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SANITIZED 1
#endif
#endif

TEST(Limits, AddressSpaceThatIsNotThereIsNoCrash) {
#ifdef SANITIZED
    GTEST_SKIP() << "the sanitizer needs the address space for itself";
#endif
    for (const char* text : {wide, endless}) {
        const TemporaryFile script("large.csp", text);
        const Ran ran = run_with_address_space({"cspm", "--no-reduction", script.path()}, std::uint64_t{200} << 20U);
        EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
        EXPECT_THAT(ran.out + ran.err, HasSubstr("memory"));
    }
}

TEST(Progress, JsonEventsTellBothPhases) {
    const TemporaryFile script("wide.csp", wide);
    const Ran ran = run({"cspm", "--no-reduction", script.path(), "--progress", "json", "--timeout", "0.6"});
    const std::vector<Json> events = lines(ran.err);
    ASSERT_FALSE(events.empty());
    std::uint64_t states = 0;
    for (const Json& event : events) {
        EXPECT_EQ(event["event"], "progress");
        EXPECT_EQ(event["subject"], "SYSTEM :[deadlock free [F]]");
        if (event["phase"] != "searching") continue;
        EXPECT_GE(event["states"], states) << "states are never forgotten";
        states = event["states"];
    }
    EXPECT_GT(states, 1000U);
    const TemporaryFile compiling("endless.csp", endless);
    const std::vector<Json> while_compiling =
        lines(run({"cspm", compiling.path(), "--progress", "json", "--timeout", "0.6"}).err);
    ASSERT_FALSE(while_compiling.empty());
    EXPECT_EQ(while_compiling.front()["phase"], "compiling");
    EXPECT_THAT(while_compiling.front()["part"].get<std::string>(), HasSubstr("a → …"));
    EXPECT_EQ(while_compiling.front()["components"], 2);
    EXPECT_THAT(run({"cspm", "--no-reduction", script.path(), "--timeout", "0.3"}).err, IsEmpty())
        << "no terminal, no progress";
}

TEST(Progress, TheLineFitsTheTerminal) {
    refine::Progress progress;
    progress.states = 2'000'000;
    progress.transitions = 12'345'678;
    progress.frontier = 45'600;
    progress.depth = 17;
    progress.seconds = 4;
    progress.resident_bytes = 100ULL << 20U;
    progress.grown_bytes = 40'000'000;
    EXPECT_EQ(
        progress_text(progress, 200),
        "searching 4 s: 2.00 M states, 12.35 M transitions, 500.0 k/s, 45.6 k waiting, depth 17, 100 MiB, 20 B/state");
    EXPECT_EQ(progress_text(progress, 20), "searching 4 s: 2.00 ");
    progress.phase = refine::Progress::Phase::compiling;
    progress.component = 3;
    progress.components = 12;
    progress.part = "P(1) ‖ Q";
    EXPECT_EQ(progress_text(progress, 200),
              "compiling 4 s: component 3 of 12, 2.00 M states, 100 MiB, 20 B/state, P(1) ‖ Q");
    EXPECT_EQ(progress_text(progress, 78),
              "compiling 4 s: component 3 of 12, 2.00 M states, 100 MiB, 20 B/state, P(1) ‖ Q");
    EXPECT_EQ(progress_text(progress, 77),
              "compiling 4 s: component 3 of 12, 2.00 M states, 100 MiB, 20 B/state, P(1) ‖ ");
}

/// Logs get one line for every 30 seconds of a phase. The next phase counts its seconds from zero.
TEST(Progress, LogsHaveALineNowAndThen) {
    ProgressLog log("A [timed] S\nx");
    refine::Progress progress;
    std::vector<int> seconds;
    for (const auto phase : {refine::Progress::Phase::compiling, refine::Progress::Phase::searching})
        for (int second = 0; second <= 70; ++second) {
            progress.phase = phase;
            progress.seconds = second;
            const auto line = log.next_line(progress);
            if (!line) continue;
            seconds.push_back(second);
            EXPECT_THAT(*line, HasSubstr("A [timed] S\\nx: "));
            EXPECT_THAT(*line, HasSubstr(phase == refine::Progress::Phase::compiling ? "compiling" : "searching"));
        }
    EXPECT_THAT(seconds, ElementsAre(30, 60, 30, 60));
}

// ---------------------------------------------------------------- exports

constexpr const char* exported = R"(datatype D = A | B.{ -1..1}
channel c : D.Bool
channel a, b, h
P = c.B.(-1)?x -> (a -> P [] h -> (STOP |~| b -> P)) [] b -> SKIP
SYSTEM = (P [| {h} |] (h -> h -> STOP)) \ {h}
assert SYSTEM :[deadlock free]
print 1
)";

TEST(Export, AldebaranAndGraphviz) {
    const TemporaryFile script("small.csp", "channel a, b\nP = a -> b -> P\n");
    const Ran aut = run({"cspm", script.path(), "--export", "aut", "P \\ {b}"});
    EXPECT_EQ(aut.exit, 0) << aut.err;
    EXPECT_EQ(aut.out, "des (0,2,2)\n(0,\"a\",1)\n(1,\"tau\",0)\n");
    EXPECT_THAT(run({"cspm", script.path(), "--export", "dot", "P"}).out, HasSubstr("0 -> 1 [label=\"a\"]"));
}

TEST(Export, CspReadsBackEqual) {
    const TemporaryFile script("exported.csp", exported);
    const Ran ran = run({"cspm", script.path(), "--export", "csp", "SYSTEM"});
    ASSERT_EQ(ran.exit, 0) << ran.err;
    const TemporaryFile again("again.csp", ran.out);
    const Json object = refines(again.path());
    ASSERT_EQ(object["results"].size(), 2U) << "the script's own assertions are left out\n" << ran.out;
    for (const Json& result : object["results"]) EXPECT_EQ(result["result"], 1) << result;
}

TEST(Export, MistakesAreSaid) {
    const TemporaryFile script("exported.csp", exported);
    EXPECT_EQ(run({"cspm", script.path(), "--export", "svg", "SYSTEM"}).exit, 4);
    const Ran unknown = run({"cspm", script.path(), "--export", "aut", "NOBODY"});
    EXPECT_EQ(unknown.exit, 2);
    EXPECT_THAT(unknown.err, HasSubstr("NOBODY"));
    EXPECT_THAT(run({"cspm", script.path(), "--export", "aut", "1 + 1"}).err, HasSubstr("CSPM-T"));
    const TemporaryFile large("wide.csp", wide);
    const Ran limited = run({"cspm", large.path(), "--export", "aut", "SYSTEM", "--max-states", "1000"});
    EXPECT_EQ(limited.exit, 3);
    EXPECT_THAT(limited.out, IsEmpty());
}

}  // namespace
}  // namespace robochart::app::testing::refines_test
