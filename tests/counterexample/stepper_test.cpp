// SPDX-License-Identifier: Apache-2.0
// Tests with random walks that the stepper offers exactly the steps of the compiled process, which is the process that
// verdicts are about.
#include "counterexample/stepper.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "base/diagnostics/splitmix64.hpp"
#include "tests/counterexample/animation.hpp"
#include "tests/random_models/models/well_formed.hpp"
#include "tests/rounds.hpp"
#include "tests/source_folder.hpp"

namespace robochart::runs {
namespace {

using csp_emit::Time;
using lts::Word;
using testing::Animation;

using Names = std::set<std::string>;

/// The states that the compiled process may have reached after the events of the walk.
class Shadow {
public:
    explicit Shadow(lts::TransitionSystem& system) : system_(&system) { restart(); }

    void restart() {
        std::vector<Word> first(system_->width());
        system_->initial(first);
        states_ = {first};
    }
    /// Keeps only the states with exactly these offers. Returns false if there is none. A state may have fewer steps
    /// with the same name than the stepper offers, because the compiler merges equivalent states.
    [[nodiscard]] bool offers(const Names& names) {
        std::erase_if(states_, [&](const std::vector<Word>& state) { return steps(state).names != names; });
        return !states_.empty();
    }
    void take(const std::string& name) {
        std::set<std::vector<Word>> next;
        for (const std::vector<Word>& state : states_) {
            const auto [begin, end] = steps(state).targets.equal_range(name);
            for (auto at = begin; at != end; ++at) next.insert(at->second);
        }
        states_.assign(next.begin(), next.end());
    }

private:
    struct Steps {
        std::multimap<std::string, std::vector<Word>> targets;
        Names names;
    };

    /// Caches steps, because walks return to the same states.
    const Steps& steps(const std::vector<Word>& state) {
        const auto [found, added] = known_.try_emplace(state);
        if (!added) return found->second;
        struct Sink : lts::SuccessorSink {
            Steps found;
            const lts::EventTable* events = nullptr;
            void add(lts::Event event, lts::StateView target, lts::Event) override {
                found.targets.insert({events->name(event), {target.begin(), target.end()}});
                found.names.insert(events->name(event));
            }
        } sink;
        sink.events = &system_->events();
        system_->successors(state, sink);
        found->second = std::move(sink.found);
        return found->second;
    }

    lts::TransitionSystem* system_;
    std::vector<std::vector<Word>> states_;
    std::map<std::vector<Word>, Steps> known_;
};

/// The offers of the stepper in a state: visible names and their targets. All hidden events have the same name here,
/// because the compiler merges states that differ only in hidden events.
struct Offered {
    std::vector<std::pair<std::string, process::TermId>> list;
    Names names;

    Offered(const Stepper& stepper, process::TermId state) {
        for (const Offer& offer : stepper.offers_at(state)) {
            list.emplace_back(offer.hidden ? "τ" : offer.name, offer.step.target);
            names.insert(list.back().first);
        }
    }
};

/// Walks randomly, and returns the number of steps that agreed. A difference fails the test. If no step is possible,
/// the walk restarts.
std::size_t walk(Animation& animation, std::size_t steps, std::uint64_t seed) {
    const auto system = animation.session.system(animation.process);
    Shadow shadow(*system);
    const process::TermId initial = animation.stepper->current_term();
    process::TermId here = initial;
    std::map<process::TermId, Offered> known;
    for (std::size_t i = 0; i < steps; ++i) {
        auto found = known.find(here);
        if (found == known.end()) found = known.emplace(here, Offered(*animation.stepper, here)).first;
        const Offered& offered = found->second;
        if (!shadow.offers(offered.names)) {
            ADD_FAILURE() << "step " << i << ": no state of the compiled process offers the same";
            return i;
        }
        if (offered.list.empty()) {
            here = initial;
            shadow.restart();
            continue;
        }
        const auto& [name, target] = offered.list[diagnostics::splitmix64(seed) % offered.list.size()];
        shadow.take(name);
        here = target;
    }
    return steps;
}

TEST(Stepper, OffersWhatTheCompiledCaseStudiesCanDo) {
    for (const Time time : {Time::untimed, Time::timed})
        for (const std::string study : {"aggregation", "swarm_taxis"}) {
            Animation animation(csp_emit::testing::project((tests::source_folder() / "corpus").string() + "/" + study),
                                time, "");
            EXPECT_EQ(walk(animation, 10'000, 1), 10'000U) << study;
        }
}

TEST(Stepper, OffersWhatCompiledRandomModelsCanDo) {
    for (std::uint64_t seed = 0; seed < tests::rounds(20); ++seed)
        for (const Time time : {Time::untimed, Time::timed}) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            std::vector<std::pair<std::string, std::string>> texts;
            for (const auto& file : random_models::well_formed(seed, random_models::Shape::timed_core()))
                texts.emplace_back(file.path, file.text);
            Animation animation(csp_emit::testing::model_of(texts), time, "");
            (void)walk(animation, 10'000, seed);
        }
}

const char* const lamp = R"(stm S { event e : nat event f initial i var x : nat clock T
state Off { } state On { entry #T; wait(2) }
transition t0 { from i to Off }
transition t1 { from Off to On trigger e?x condition x > 0 }
transition t2 { from On to Off trigger f condition since(T) >= 3 } })";

/// Returns the index of the offer with this text.
std::size_t offer(Stepper& stepper, const std::string& text) {
    const auto& offers = stepper.current_offers();
    for (std::size_t i = 0; i < offers.size(); ++i)
        if (offers[i].happening.event.text.find(text) != std::string::npos) return i;
    ADD_FAILURE() << "no offer " << text;
    return 0;
}

TEST(Stepper, GoesAndComesBack) {
    Animation animation(csp_emit::testing::load_model(lamp), Time::timed, "S");
    Stepper& stepper = *animation.stepper;
    stepper.take_forced_steps(100);
    const process::TermId rest = stepper.current_term();
    const std::size_t steps = stepper.steps_taken().size();
    ASSERT_EQ(stepper.current_machines().size(), 1U);
    EXPECT_EQ(stepper.current_machines().front().text, "in Off");
    EXPECT_EQ(stepper.current_offers().back().happening.event.kind, Kind::tock) << "time comes last";
    stepper.take_offer(offer(stepper, "input e with 2"));
    EXPECT_NE(stepper.current_term(), rest);
    stepper.back_to(steps);
    EXPECT_EQ(stepper.current_term(), rest);
    EXPECT_EQ(stepper.steps_taken().size(), steps);
    stepper.back_to(0);
    EXPECT_TRUE(stepper.steps_taken().empty());
    EXPECT_EQ(stepper.elapsed_time(), 0);
}

TEST(Stepper, SaysWhyATransitionIsNotOnOffer) {
    Animation animation(csp_emit::testing::load_model(lamp), Time::timed, "S");
    Stepper& stepper = *animation.stepper;
    stepper.take_forced_steps(100);
    EXPECT_TRUE(stepper.explain_absences().empty());
    stepper.take_offer(offer(stepper, "input e with 2"));
    stepper.take_forced_steps(100);
    ASSERT_EQ(stepper.explain_absences().size(), 1U);
    EXPECT_THAT(stepper.explain_absences().front().reason,
                ::testing::HasSubstr("the machine is not at rest: entry action of On"));
    while (stepper.current_machines().front().text != "in On") {
        stepper.take_offer(stepper.current_offers().size() - 1);
        stepper.take_forced_steps(100);
    }
    EXPECT_EQ(stepper.elapsed_time(), 2);
    ASSERT_EQ(stepper.explain_absences().size(), 1U);
    EXPECT_EQ(stepper.explain_absences().front().text, "t2: On -> Off");
    EXPECT_EQ(stepper.explain_absences().front().reason, "its condition `since(T) >= 3` does not hold (since(T) = 2)");
    stepper.take_offer(stepper.current_offers().size() - 1);
    EXPECT_TRUE(stepper.explain_absences().empty()) << "three units after the reset";
}

// `Silent` could send, but the controller connects no receiver to it.
TEST(Stepper, KnowsWhereTheSurroundingsDoNotTakePart) {
    Animation animation(csp_emit::testing::load_model(R"(
stm A { event e initial i state S { } state T { } transition t0 { from i to S } transition t1 { from S to T trigger e } }
stm B { event e initial i state S { entry wait(5); send e } transition t0 { from i to S } }
controller C { sref a = A sref b = B connection b on e to a on e })"),
                        Time::timed, "C");
    Stepper& stepper = *animation.stepper;
    for (int i = 0; i < 20 && (stepper.current_machines().empty() || stepper.elapsed_time() < 1); ++i)
        stepper.take_offer(0);
    const auto absences = stepper.explain_absences();
    ASSERT_EQ(absences.size(), 1U);
    EXPECT_EQ(absences.front().text, "t1: S -> T");
    EXPECT_THAT(absences.front().reason, ::testing::HasSubstr("its surroundings do not take part"));
}

// After the first step one machine has moved, and the other is still inside its initial definition.
TEST(Stepper, HasAllMachinesAtEveryStep) {
    Animation animation(csp_emit::testing::load_model(R"(
stm A { initial i state S { } transition t0 { from i to S } }
stm B { initial i state S { } transition t0 { from i to S } }
controller C { sref a = A sref b = B })"),
                        Time::untimed, "C");
    Stepper& stepper = *animation.stepper;
    for (int i = 0; i < 3; ++i) {
        std::vector<std::string> components;
        for (const Machine& machine : stepper.current_machines()) components.push_back(machine.component);
        EXPECT_EQ(components, (std::vector<std::string>{"C::a", "C::b"})) << "step " << i;
        stepper.take_offer(0);
    }
}

TEST(Stepper, MakesARunOfTheWay) {
    Animation animation(csp_emit::testing::load_model(lamp), Time::timed, "S");
    Stepper& stepper = *animation.stepper;
    stepper.take_forced_steps(100);
    stepper.take_offer(offer(stepper, "input e with 1"));
    stepper.take_forced_steps(100);
    stepper.take_offer(offer(stepper, "time unit"));
    const runs::Run run = stepper.run(Time::timed);
    EXPECT_EQ(run.time, 1);
    ASSERT_GE(run.steps.size(), 3U);
    EXPECT_TRUE(run.end.why.empty());
    const bool received =
        std::ranges::any_of(run.steps, [](const Step& step) { return step.event.text == "input e with 1"; });
    EXPECT_TRUE(received);
}

}  // namespace
}  // namespace robochart::runs
