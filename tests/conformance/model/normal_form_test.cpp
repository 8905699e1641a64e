// SPDX-License-Identifier: Apache-2.0
// Compares the two representations of the normal form: CSPM text and NormalFormSystem. They are equivalent in
// failures-divergences on random models. Reading registers in one fixed order loses no behaviour (docs/conformance.md,
// "One order of reading").
#include "conformance/model/normal_form.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/lts/graph.hpp"
#include "conformance/model/normal_form_system.hpp"
#include "tests/conformance/bench.hpp"

namespace robochart::conformance {
namespace {

namespace b = cspm::build;

Interface small_interface(std::vector<DroppedInput> drops = {}) {
    Interface interface;
    interface.drops = std::move(drops);
    interface.component = "T";
    interface.inputs = {{"a.in", {}, {}, {}}, {"v.in", {0, 1}, {"0", "1"}, {}}};
    interface.outputs = {{"xCall", {}}, {"y.out", {Carrier{}}}};
    return interface;
}

constexpr const char* declarations = R"(
datatype InOut = in | out
channel tock, silent
module T
exports
  channel a : InOut
  channel v : InOut.{0..1}
  channel xCall
  channel y : InOut.{0..1}
  channel terminate
endmodule
)";

/// Returns a process of a few states with random edges: inputs, outputs, time, internal steps, termination.
std::string random_model(unsigned seed, bool terminates) {
    std::mt19937 random(seed);
    const auto pick = [&](unsigned n) { return static_cast<unsigned>(random() % n); };
    const std::vector<const char*> events{"T::a.in",    "T::v.in.0", "T::v.in.1", "T::xCall", "T::y.out.0",
                                          "T::y.out.1", "silent",    "tock",      "tock",     "T::a.in"};
    const unsigned states = 2 + pick(4);
    std::string text = declarations;
    for (unsigned s = 0; s < states; ++s) {
        std::string body = terminates && s + 1 == states ? "SKIP" : "";
        for (unsigned e = 1 + pick(4); body != "SKIP" && e > 0; --e)
            body += fmt::format("{}{} -> P({})", body.empty() ? "" : " [] ", events[pick(10)], pick(states));
        text += fmt::format("P({}) = {}\n", s, body);
    }
    return text + "M = P(0) \\ {silent}\n";
}

cspm::Script read_script(const std::string& text) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics found;
    cspm::Script script = cspm::read(sources, sources.add("model.csp", text), found);
    EXPECT_TRUE(found.ok()) << text;
    return script;
}

/// The two normal forms of one model, in one session.
struct Both {
    Both(const std::string& source, std::uint32_t cycle_length, Reading reading, const char* process,
         const std::vector<DroppedInput>& drops = {})
        : Both(with_normal_form(source, cycle_length, reading, drops), cycle_length, process, drops) {}

    static cspm::Script with_normal_form(const std::string& source, std::uint32_t cycle_length, Reading reading,
                                         const std::vector<DroppedInput>& drops = {}) {
        cspm::Script script = read_script(source);
        process::EventTable scratch;
        const Alphabet alphabet(small_interface(drops), scratch);
        NormalFormScript form = normal_form(script, b::name("M"), alphabet, cycle_length, reading);
        script.decls.insert(script.decls.end(), form.decls.begin(), form.decls.end());
        cspm::Script order = read_script(
            "ORDER = (registerRead.absent__a -> SECOND) [] (registerRead.present__a -> SECOND)\n"
            "SECOND = registerRead.absent__v -> ORDER [] registerRead.present__v?x -> ORDER\n"
            "ORDERED = NF__ [| {| registerRead |} |] ORDER\n");
        script.decls.insert(script.decls.end(), order.decls.begin(), order.decls.end());
        return script;
    }

    Both(cspm::Script script, std::uint32_t cycle_length, const char* process,
         const std::vector<DroppedInput>& drops = {})
        : session(std::move(script)),
          text(session.system(b::name(process))),
          model(session.system(b::name("M"))),
          alphabet(small_interface(drops), session.event_table()),
          graph(*model, alphabet),
          direct(graph, alphabet, cycle_length) {}

    void expect_equal(const std::string& what) {
        const auto one = refine::refines(*text, direct, refine::Model::failures_divergences, {});
        const auto two = refine::refines(direct, *text, refine::Model::failures_divergences, {});
        EXPECT_EQ(one.outcome, refine::Outcome::holds) << what << describe_verdict(one);
        EXPECT_EQ(two.outcome, refine::Outcome::holds) << what << describe_verdict(two);
    }
    std::string describe_verdict(const refine::Verdict& verdict) const {
        std::string shown = "\n" + verdict.reason;
        if (!verdict.counterexample) return shown;
        for (const refine::Step& step : verdict.counterexample->steps)
            shown += fmt::format("\n  {} ({})", alphabet.events().name(step.event), step.state);
        return shown;
    }

    cspm::Session session;
    std::unique_ptr<lts::TransitionSystem> text, model;
    Alphabet alphabet;
    ModelGraph graph;
    NormalFormSystem direct;
};

TEST(NormalForm, TextAndSystemAgreeOnRandomModels) {
    for (unsigned seed = 0; seed < 150; ++seed) {
        const std::string model = random_model(seed, seed % 2 == 0);
        Both both(model, 1 + seed % 3 / 2, Reading::fixed_order, "NF__");
        both.expect_equal(model);
    }
}

/// Both forms drop the same inputs, even if dropping one input decides whether another is dropped.
TEST(NormalForm, TextAndSystemDropTheSameInputs) {
    const std::vector<std::vector<DroppedInput>> orders = {{{0, 1}}, {{1, 0}}, {{0, 1}, {1, 0}}, {{1, 0}, {0, 1}}};
    for (unsigned seed = 0; seed < 80; ++seed) {
        const std::string model = random_model(seed, seed % 2 == 0);
        Both both(model, 1 + seed % 3 / 2, Reading::fixed_order, "NF__", orders[seed % orders.size()]);
        both.expect_equal(model);
    }
}

/// With `a drops v`, v has no effect in a cycle with both.
TEST(NormalForm, DropsWhatAnotherInputDrops) {
    const std::string model =
        std::string(declarations) + "M = T::a.in -> M [] T::v.in?x -> T::y.out!x -> M [] tock -> M\n";
    for (const bool drops : {false, true}) {
        const std::vector<DroppedInput> order(drops ? 1 : 0, DroppedInput{0, 1});
        cspm::Script script = Both::with_normal_form(model, 1, Reading::fixed_order, order);
        const cspm::Script never = read_script(
            "NEVER(b) = registerRead.absent__a -> NEVER(false) [] registerRead.present__a -> NEVER(true)\n"
            "  [] registerRead.absent__v -> NEVER(b) [] registerRead.present__v?x -> NEVER(b)\n"
            "  [] tock -> NEVER(b) [] not b & registerWrite.wrote__y?v -> NEVER(b)\n");
        script.decls.insert(script.decls.end(), never.decls.begin(), never.decls.end());
        Both both(std::move(script), 1, "NF__", order);
        const auto allowed = both.session.system(b::call("NEVER", {b::boolean(false)}));
        const auto expected = drops ? refine::Outcome::holds : refine::Outcome::fails;
        EXPECT_EQ(refine::refines(*allowed, *both.text, refine::Model::traces, {}).outcome, expected);
        EXPECT_EQ(refine::refines(*allowed, both.direct, refine::Model::traces, {}).outcome, expected);
    }
}

/// Returns whether some reachable state can perform the event.
bool can_do(lts::TransitionSystem& system, process::Event event) {
    const lts::Exploration all = lts::explore(system, [](std::size_t) {});
    for (lts::StateIndex state = 0; state < all.graph.size(); ++state)
        for (const lts::Edge& edge : all.graph.edges(state))
            if (edge.event == event) return true;
    return false;
}

/// Outputs::once finds a repeated output in a cycle if and only if the CSPM text of the normal form has a trace with
/// one.
TEST(NormalForm, RepeatedOutputsAreThoseOfTheTraces) {
    unsigned repeating = 0;
    for (unsigned seed = 2000; seed < 2100; ++seed) {
        const std::string model = random_model(seed, seed % 2 == 0);
        cspm::Script script = Both::with_normal_form(model, 1, Reading::fixed_order);
        const cspm::Script once = read_script(
            "ONCE(s) = registerRead?r -> ONCE(s) [] tock -> ONCE({}) [] SKIP\n"
            "  [] not member(0, s) & registerWrite.wrote__xCall -> ONCE(union(s, {0}))\n"
            "  [] not member(1, s) & registerWrite.wrote__y?v -> ONCE(union(s, {1}))\n");
        script.decls.insert(script.decls.end(), once.decls.begin(), once.decls.end());
        Both both(std::move(script), 1, "NF__");
        const auto allowed = both.session.system(b::call("ONCE", {b::set({})}));
        const bool repeats =
            refine::refines(*allowed, *both.text, refine::Model::traces, {}).outcome == refine::Outcome::fails;
        Frame frame;
        frame.outputs = Outputs::once;
        NormalFormSystem strict(both.graph, both.alphabet, 1, frame);
        const bool marked = can_do(strict, strict.repeat_event());
        EXPECT_EQ(marked, repeats) << model;
        repeating += repeats ? 1U : 0U;
    }
    EXPECT_GT(repeating, 10U);
    EXPECT_LT(repeating, 90U);
}

// These models do not terminate, because ORDER does not terminate.
TEST(NormalForm, OneOrderOfReadingLosesNothing) {
    for (unsigned seed = 1000; seed < 1100; ++seed) {
        const std::string model = random_model(seed, false);
        Both both(model, 1, Reading::any_order, "ORDERED");
        both.expect_equal(model);
    }
}

// Compares text and system for a case study. The text is the one that FDR would get.
TEST(NormalForm, TextAndSystemAgreeOnAggregation) {
    test::Model model("corpus/aggregation");
    test::Bench bench(model, model.first_module());
    const Interface interface = bench.interface();
    process::EventTable scratch;
    const NormalFormScript form =
        normal_form(bench.script().definitions, bench.process(), Alphabet(interface, scratch), 1, Reading::fixed_order);
    cspm::Script script = bench.script().definitions;
    script.decls.insert(script.decls.end(), form.decls.begin(), form.decls.end());
    cspm::Session session(script);
    const auto text = session.system(form.process);
    const auto modelled = session.system(bench.process());
    const Alphabet alphabet(interface, session.event_table());
    ModelGraph graph(*modelled, alphabet);
    NormalFormSystem direct(graph, alphabet, 1);
    const auto fd = refine::Model::failures_divergences;
    EXPECT_EQ(refine::refines(*text, direct, fd, {}).outcome, refine::Outcome::holds);
    EXPECT_EQ(refine::refines(direct, *text, fd, {}).outcome, refine::Outcome::holds);
    EXPECT_GT(graph.size(), 10U);
}

TEST(NormalForm, PrintsAndReadsBack) {
    const cspm::Script script = Both::with_normal_form(random_model(3, true), 2, Reading::any_order);
    const cspm::Script again = read_script(cspm::print(script));
    EXPECT_TRUE(cspm::equal(script, again)) << cspm::print(script);
}

TEST(NormalForm, MissingChannelsAndTakenNamesAreErrors) {
    process::EventTable events;
    const Alphabet alphabet(small_interface(), events);
    const auto form = [&](const char* text) {
        (void)normal_form(read_script(text), b::name("M"), alphabet, 1, Reading::any_order);
    };
    EXPECT_THROW(form("channel tock"), AlphabetError);
    EXPECT_THROW(form((std::string(declarations) + "channel registerRead").c_str()), AlphabetError);
    EXPECT_THROW(form((std::string(declarations) + "NF__ = STOP").c_str()), AlphabetError);
    EXPECT_NO_THROW(form(declarations));
}

TEST(NormalForm, FindsChannelsThroughModules) {
    const cspm::Script script = read_script(
        "module P\nexports\nmodule S\n channel inner\nexports\n channel e, f : {0..1}\nendmodule\nendmodule\nchannel "
        "g");
    EXPECT_TRUE(find_channel(script, "P::S::f"));
    EXPECT_TRUE(find_channel(script, "P::S::inner"));
    EXPECT_TRUE(find_channel(script, "g"));
    EXPECT_FALSE(find_channel(script, "P::e"));
    EXPECT_FALSE(find_channel(script, "P::S::h"));
}

}  // namespace
}  // namespace robochart::conformance
