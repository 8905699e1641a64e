// SPDX-License-Identifier: Apache-2.0
// Compares the decision process with its sources. The decision process is branching bisimilar to the process that is
// checked for refinement (otherwise ProcessEncoding throws std::logic_error). The values of a restricted class of
// schedulers are within the bounds for all schedulers.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>

#include "prism/assertions/process/subgraph.hpp"
#include "tests/contents.hpp"
#include "tests/prism/assertions/models.hpp"
#include "tests/random_models/models/well_formed.hpp"
#include "tests/random_models/tests/seeds.hpp"
#include "tests/source_folder.hpp"

namespace robochart::probability {
namespace {

using prism::Rational;
using testing::robotool_rows;

/// Returns the minimum and the maximum of rows with one value each, or nullopt if a value is unknown.
std::optional<std::pair<Rational, Rational>> bounds(const std::vector<Row>& rows) {
    if (rows.size() != 1 || !rows.front().error.empty()) return std::nullopt;
    for (const prism::Result& result : rows.front().results)
        if (result.kind != prism::Result::Kind::number || !result.low.is_exact()) return std::nullopt;
    return std::pair(rows.front().results.front().low.value(), rows.front().results.back().low.value());
}

/// Returns a shape of small timed models with probabilities.
random_models::Shape small_models() {
    random_models::Shape shape = random_models::Shape::timed_core();
    shape.probabilistic = true;
    shape.junctions = true;
    shape.controllers = {1, 1};
    shape.machines = {1, 2};
    shape.states = {1, 2};
    shape.data.largest = 1;
    return shape;
}

std::map<std::string, std::string> texts(std::uint64_t seed, const random_models::Shape& shape) {
    std::map<std::string, std::string> files;
    for (const random_models::Text& text : random_models::well_formed(seed, shape))
        if (!text.is_assertions()) files[text.path] = text.text;
    return files;
}

/// Returns an event on which a machine of the first module communicates, in the notation of rewards ("M::c::s::e.in"),
/// or "" if there is none.
std::string some_event(const ir::System& system) {
    if (system.modules.empty()) return "";
    ir::ComponentRef module;
    module.kind = ir::ComponentKind::module;
    module.definition = 0;
    module.path = system.modules[0].name;
    for (const Seat& seat : seats_in(system, module))
        for (const ir::Event& event : seat.machine->events)
            if (event.input || event.output)
                return fmt::format("{}::{}.{}", seat.path, event.name, event.input ? "in" : "out");
    return "";
}

/// Each process is compared with the one that is checked for refinement, also with an observer of one of its events.
/// Some models have no answer: probabilities that random expressions give need not sum to 1, and some models are too
/// large. tests/long.sh probability tries many more.
TEST(Agreement, OfRandomModels) {
    std::size_t answered = 0;
    std::size_t rewarded = 0;
    constexpr std::uint64_t most_states = 3000;
    for (const std::uint64_t seed : random_models::seeds(8)) {
        std::map<std::string, std::string> files = texts(seed, small_models());
        const std::string event = some_event(testing::load(files)->system);
        files["p.assertions"] = "prob property P : Prob=? of [Finally <=2 deadlock]\n";
        if (!event.empty())
            files["p.assertions"] +=
                "rewards r = [" + event + "] true : 1; endrewards\nprob property R : Reward {r} =? of [Cumul 1]\n";
        const auto loaded = testing::load(files);
        const auto decide = [&](const std::string& name, Scheduler scheduler) {
            return bounds(testing::process_rows(*loaded, name, scheduler, nullptr, most_states));
        };
        for (const std::string name : {"P", "R"}) {
            if (name == "R" && event.empty()) continue;
            const auto any = decide(name, Scheduler::any);
            if (!any) continue;
            ++(name == "P" ? answered : rewarded);
            const auto urgent = decide(name, Scheduler::urgent);
            const auto uniform = decide(name, Scheduler::uniform);
            if (name == "P") {
                ASSERT_TRUE(urgent && uniform) << seed;
            }
            for (const auto& fewer : {urgent, uniform}) {
                if (!fewer) continue;
                EXPECT_LE(any->first, fewer->first) << name << " " << seed;
                EXPECT_LE(fewer->second, any->second) << name << " " << seed;
            }
        }
    }
    RecordProperty("answered", fmt::format("{}", answered));
    RecordProperty("rewarded", fmt::format("{}", rewarded));
    std::cout << answered << " probabilities and " << rewarded << " rewards of events\n";
    EXPECT_GT(answered, 0u);
    EXPECT_GT(rewarded, 0u);
}

/// The bracket theorem: the Markov chain and the decision process have the same text. The chain resolves every choice
/// of the process by one scheduler, so its values are within the bounds. Many models have no counterpart in RoboTool's
/// encoding.
TEST(Agreement, TheChainLiesBetweenTheSchedulers) {
    random_models::Shape shape = random_models::Shape::untimed_core();
    shape.probabilistic = true;
    shape.controllers = {1, 1};
    shape.machines = {1, 2};
    shape.data.largest = 1;
    shape.depth = 0;
    shape.composite_states = shape.final_states = shape.during_actions = shape.exit_actions = shape.conditionals =
        false;
    shape.typed_events = shape.shared_variables = shape.unconnected_events = false;
    shape.platform_operations = shape.defined_operations = {0, 0};
    std::size_t answered = 0;
    for (const std::uint64_t seed : random_models::seeds(12)) {
        std::map<std::string, std::string> files = texts(seed, shape);
        const auto plain = testing::load(files);
        if (plain->system.modules.empty()) continue;
        const std::string event = some_event(plain->system);
        if (event.empty()) continue;
        files["p.assertions"] =
            "rewards r = [" + event + "] true : 1; endrewards\nprob property R : Reward {r} =? of [Cumul 12]\n";
        const auto loaded = testing::load(files);
        RoboToolOptions as_mdp = testing::small_ranges();
        as_mdp.preferences.kind = prism::ModelKind::mdp;
        as_mdp.max_states = 20'000;
        RoboToolOptions as_dtmc = testing::small_ranges();
        as_dtmc.max_states = as_mdp.max_states;
        const auto chain = robotool_rows(*loaded, "R", as_dtmc, {1e-9, false});
        const auto all = robotool_rows(*loaded, "R", as_mdp, {1e-9, false});
        const auto number = [](const Row& row) {
            return row.error.empty() && row.results.front().kind == prism::Result::Kind::number;
        };
        if (!number(chain.front()) || !number(all.front())) continue;
        ++answered;
        const auto value = chain.front().results.front().low.bounds();
        EXPECT_LE(all.front().results.front().low.bounds().low, value.high) << seed;
        EXPECT_GE(all.front().results.back().low.bounds().high, value.low) << seed;
    }
    std::cout << answered << " rewards of chains\n";
    EXPECT_GT(answered, 0u);
}

DecisionProcess fork(bool whole) {
    DecisionProcess made;
    markov::Model& model = made.model;
    model.kind = markov::Kind::mdp;
    model.initial = {0};
    model.numbers = {{1, 1}, {0.5, 0.5}};
    model.exact = {Rational(1), Rational(1, 2)};
    model.actions = {"", "tock", "loop"};
    // State 0 leads to 1 or 2 with probability one half each. In the whole process it also has a tock back to 0. States
    // 1 and 2 are absorbing.
    model.target = {1, 2};
    model.number = {1, 1};
    model.first_branch = {0, 2};
    model.action = {0};
    model.counted = {false};
    const auto to = [&](markov::State target, std::uint32_t action) {
        model.target.push_back(target);
        model.number.push_back(0);
        model.first_branch.push_back(model.target.size());
        model.action.push_back(action);
        model.counted.push_back(action == 1);
    };
    if (whole) to(0, 1);
    model.first_choice = {0, static_cast<std::uint32_t>(model.choices())};
    for (const markov::State state : {1U, 2U}) {
        to(state, 2);
        model.first_choice.push_back(static_cast<std::uint32_t>(model.choices()));
    }
    made.deadlocks = {false, true, true};
    made.origins = {7, 5, 3};
    return made;
}

TEST(Agreement, OfSubgraphs) {
    const auto part = [](const DecisionProcess& fewer) {
        return is_subgraph(fewer, fork(true), diagnostics::unlimited);
    };
    EXPECT_TRUE(part(fork(false)));
    EXPECT_TRUE(part(fork(true)));
    EXPECT_FALSE(is_subgraph(fork(true), fork(false), diagnostics::unlimited)) << "tock is none of its choices";
    DecisionProcess other = fork(false);
    other.origins = {7, 3, 5};
    EXPECT_TRUE(part(other)) << "numbers of states do not matter";
    other.origins = {7, 5, 4};
    EXPECT_FALSE(part(other)) << "a state that is not there";
    other = fork(false);
    other.deadlocks[1] = false;
    EXPECT_FALSE(part(other));
    other = fork(false);
    other.model.counted[0] = true;
    EXPECT_FALSE(part(other)) << "time passes";
    other = fork(false);
    other.model.exact[1] = Rational(1, 3);
    EXPECT_FALSE(part(other)) << "another distribution";
    other = fork(false);
    other.model.initial = {1};
    EXPECT_FALSE(part(other));
}

/// The test uses the decision process of the first component of each model. Urgent steps must be among all steps, or
/// ProcessEncoding throws std::logic_error.
TEST(Agreement, OfTheCorpus) {
    std::size_t compared_models = 0;
    for (const auto& folder : std::filesystem::directory_iterator(tests::source_folder() / "corpus")) {
        if (!folder.is_directory()) continue;
        std::map<std::string, std::string> files{
            {"p.assertions", "prob property P : Prob=? of [Finally <=1 deadlock]\n"}};
        for (const auto& file : std::filesystem::directory_iterator(folder))
            if (file.path().extension() == ".rct") files[file.path().filename()] = tests::read_contents(file.path());
        if (files.size() == 1) continue;
        const auto loaded = testing::load(files);
        std::uint64_t compared = 0;
        const auto rows = testing::process_rows(*loaded, "P", Scheduler::urgent, &compared, 20'000);
        if (compared > 0 && rows.front().error.empty()) ++compared_models;
    }
    std::cout << compared_models << " models of the corpus\n";
    EXPECT_GT(compared_models, 3u);
}

TEST(Agreement, OfTheForager) {
    const auto folder = tests::source_folder() / "corpus/foraging";
    const auto loaded =
        testing::load({{"foraging.rct", tests::read_contents(folder / "foraging.rct")},
                       {"p.assertions",
                        "import foraging::*\n"
                        "label searches = foraging::Robot::brain::forager is in foraging::Forager::Searching\n"
                        "prob property P : Prob=? of [Finally <=10 #searches]\n"
                        "prob property Q : Prob=? of [Finally <=30 foraging::Robot::brain::forager is in "
                        "foraging::Forager::Homing]"}});
    std::uint64_t compared = 0;
    // The robot rests for 5 units and then leaves with probability 0.25, so it has two chances to leave within 10
    // units.
    EXPECT_EQ(testing::rows_text(testing::process_rows(*loaded, "P", Scheduler::any, &compared)), "0.4375 to 0.4375");
    EXPECT_GT(compared, 30u);
    // Without food the robot searches for 20 units, so it has to leave within two rests. If it finds food immediately,
    // six units are enough.
    EXPECT_EQ(testing::rows_text(testing::process_rows(*loaded, "Q", Scheduler::any)), "0.4375 to 3367/4096");
    EXPECT_EQ(testing::rows_text(testing::process_rows(*loaded, "Q", Scheduler::urgent)), "0.4375 to 3367/4096");
}

}  // namespace
}  // namespace robochart::probability
