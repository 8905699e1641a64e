// SPDX-License-Identifier: Apache-2.0
// Tests how many names a check needs so that its answer is valid for all values (docs/conformance.md, "Few values for
// all"). The mutants are generated from changed models. The expected numbers are counted by hand: the values that a
// model can hold after a trace and may still send, plus the values that it reads next, plus one.
#include "conformance/check/enough_names.hpp"

#include <gtest/gtest.h>

#include "conformance/check/conform.hpp"
#include "conformance/model/representatives.hpp"
#include "cpp_emit/plan/resolve_component.hpp"
#include "tests/conformance/bench.hpp"
#include "tests/conformance/support.hpp"

namespace robochart::conformance {
namespace {

/// A model with one machine, and this machine as a component.
struct NamedModel {
    explicit NamedModel(const std::string& text)
        : folder("record R { a : real b : real c : real d : real e : real f : real }\n" + text),
          model(folder.path()),
          component(model.machine_named(model.system.machines.front().name)),
          resolved(cpp_emit::resolve_component(model.system, model.instantiation, component, model.diagnostics)) {}

    [[nodiscard]] EnoughNames enough() {
        const RenamedSystem renamed = renamed_system(model.system, model.instantiation, model.diagnostics);
        return enough_names(renamed, component, *resolved, {}, model.sources);
    }
    [[nodiscard]] Representatives representatives(std::size_t names) const {
        return choose_representatives(model.system, model.instantiation, *resolved, names);
    }
    [[nodiscard]] Result conform_for_all() {
        Options options;
        options.walks.cycles = 0;
        return conform(model.system, model.instantiation, component, options, model.sources, model.diagnostics);
    }

    test::ModelFolder folder;
    test::Model model;
    ir::ComponentRef component;
    std::optional<cpp_emit::Component> resolved;
};

/// Compares the code of a changed model with the original model, for this number of names.
Outcome judge_mutant(NamedModel& original, const std::string& mutant_text, std::size_t names) {
    const Representatives few = original.representatives(names);
    const csp_emit::Emission script = csp_emit::emit(original.model.system, few.instantiation, csp_emit::Time::timed,
                                                     {}, original.model.sources, original.model.diagnostics);
    NamedModel mutant(mutant_text);
    const cpp_emit::Emission code = cpp_emit::emit(mutant.model.system, mutant.representatives(names).instantiation,
                                                   mutant.component, {}, mutant.model.diagnostics);
    std::string error;
    const auto object = test::compile_quietly(code, error);
    EXPECT_TRUE(object) << error;
    if (!object) return Outcome::error;
    Options options;
    options.walks.cycles = 0;
    return judge_code(script, original.model.system, few.instantiation, original.component, object->interface(),
                      options)
        .outcome;
}

/// Returns a machine that merges two senders. The first sender has priority for two time units. The model does not say
/// which of two commands of one cycle comes first. After a trace it can hold the two commands that it has read, or one
/// of them before it is sent. It sends no command twice.
std::string merge(const std::string& to_held, const std::string& in_free, const std::string& more = "") {
    return "stm Merge { event first : R event second : R event out_ : R clock T var t : R " + more +
           " initial i\n"
           "state Free { } state Held { entry out_ ! t }\n"
           "transition t0 { from i to Free action #T }\n"
           "transition t1 { from Free to Held trigger " +
           to_held +
           " #T }\n"
           "transition t2 { from Free to Free trigger " +
           in_free +
           " }\n"
           "transition t3 { from Held to Held trigger first ? t #T }\n"
           "transition t4 { from Held to Free condition since(T) > 2 } }\n";
}

constexpr const char* from_first = "first ? t";
constexpr const char* send_second = "second ? t action out_ ! t";

TEST(EnoughNames, AreOneMoreThanTheModelMayStillSend) {
    NamedModel subject(merge(from_first, send_second));
    EXPECT_EQ(subject.enough().names, 3U);
    const Result result = subject.conform_for_all();
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
    ASSERT_EQ(result.represented.size(), 1U);
    EXPECT_EQ(result.represented[0].values, 4U) << "the initial value and three names";
    EXPECT_EQ(result.code_states, 25U) << "the class model that was written by hand";
}

TEST(EnoughNames, FindWrongCode) {
    NamedModel original(merge(from_first, send_second));
    const std::string older = "second ? t action out_ ! older ; older = t";
    const std::string mutants[] = {
        merge(from_first, older, "var older : R"),                           // the command before this one
        merge(from_first, "second ? t action out_ ! none", "var none : R"),  // the same command each time
        merge("second ? t", "first ? t action out_ ! t"),                    // the senders are exchanged
        merge(from_first, "second ? t"),                                     // the second sender is ignored
    };
    EXPECT_EQ(judge_mutant(original, merge(from_first, send_second), 3), Outcome::conforms);
    for (const std::string& mutant : mutants) EXPECT_EQ(judge_mutant(original, mutant, 3), Outcome::differs) << mutant;
}

/// Returns a machine that stores the last of four commands. It sends a and b and then must send `last`, or it begins
/// with another command and then sends b and c.
std::string chain(const std::string& last) {
    return "stm Chain { event one : R event answer : R var a : R var b : R var c : R\n"
           "var old : R initial i state A { } state B { } state C { } junction j junction k\n"
           "transition t0 { from i to A }\n"
           "transition t1 { from A to B trigger one ? a }\n"
           "transition t2 { from B to C trigger one ? b }\n"
           "transition t3 { from C to j trigger one ? c }\n"
           "transition a1 { from j to k action answer ! a }\n"
           "transition a2 { from j to A action answer ! b ; answer ! b ; answer ! c }\n"
           "transition a3 { from j to A action answer ! c ; answer ! b ; answer ! c }\n"
           "transition a4 { from j to A action answer ! old ; answer ! b ; answer ! c }\n"
           "transition b1 { from k to A action answer ! b ; answer ! " +
           last +
           " ; old = a }\n"
           "transition b2 { from k to A action answer ! c ; answer ! c }\n"
           "transition b3 { from k to A action answer ! old ; answer ! c } }\n";
}

/// The mutant sends a, b and c instead of a, b and `old`. If two of the four commands are equal, the model may send a,
/// b and c too, because it may have taken another path. So four different commands are needed: three names and the
/// initial value.
TEST(EnoughNames, TooFewHideADifference) {
    NamedModel original(chain("old"));
    EXPECT_EQ(judge_mutant(original, chain("c"), 2), Outcome::conforms) << "the test has lost its meaning";
    const EnoughNames enough = original.enough();
    ASSERT_TRUE(enough.names) << enough.reason;
    EXPECT_EQ(*enough.names, 5U) << "a, b, c and old may still be sent";
    EXPECT_EQ(judge_mutant(original, chain("c"), *enough.names), Outcome::differs);
}

/// After any number of inputs, the model may still send each of them.
TEST(EnoughNames, AreUnknownIfTheModelMaySendMoreAndMoreValues) {
    NamedModel subject(
        "stm S { event one : R event go event answer : R var x : R var y : R\n"
        "initial i state A { } junction j transition t0 { from i to A }\n"
        "transition t1 { from A to j trigger one ? y } transition t2 { from j to A action x = y }\n"
        "transition t3 { from j to A } transition t4 { from A to A trigger go action answer ! x } }\n");
    const Result result = subject.conform_for_all();
    EXPECT_EQ(result.outcome, Outcome::inconclusive);
    EXPECT_NE(result.reason.find("do not represent all values"), std::string::npos) << result.reason;
    EXPECT_NE(result.reason.find("may still be written"), std::string::npos) << result.reason;
}

/// A specification without a choice needs two names, for any number of values that it holds.
TEST(EnoughNames, AreTwoWithoutAChoice) {
    NamedModel subject(
        "stm S { event one : R event go event answer : R var x : R var y : R var z : R\n"
        "initial i state A { } transition t0 { from i to A }\n"
        "transition t1 { from A to A trigger one ? x action answer ! z ; z = y ; y = x ; wait(1) } }\n");
    EXPECT_EQ(subject.enough().names, least_names);
}

}  // namespace
}  // namespace robochart::conformance
