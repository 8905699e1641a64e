// Random models of the language's reactive core: emitted, compiled in batches, explored over all inputs, compared with
// their semantics. No discrepancy is accepted. ROBOCHART_SEEDS=N and ROBOCHART_FIRST_SEED=N try others
// (scripts/random_conformance.sh).
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <map>
#include <set>

#include "conformance/batch.hpp"
#include "random_models/well_formed.hpp"
#include "semantics/lower.hpp"
#include "tests/conformance/constructs.hpp"
#include "tests/random_models/seeds.hpp"
#include "tests/rounds.hpp"

namespace robochart::conformance {
namespace {

using random_models::Shape;
using std::chrono::steady_clock;

/// Small systems of several kinds: deep ones, ones of several machines or controllers, ones without time. In most of
/// them actions take time, without which few models can be run in cycles.
Shape shape_of(std::uint64_t seed) {
    const bool deep = seed % 9 == 2;
    Shape shape = seed % 6 == 0 ? Shape::untimed_core() : Shape::timed_core();
    shape.paced = shape.time && seed % 6 != 1;
    shape.assertions = false;
    shape.inputs_in_actions = shape.else_conditions = shape.buffers = true;
    shape.probabilistic = seed % 5 == 0;
    shape.events = {1, 2};
    shape.variables = {0, 1};
    shape.controllers = {1, seed % 3 == 0 ? 2U : 1U};
    shape.machines = {1, seed % 3 == 1 ? 2U : 1U};
    shape.states = {1, seed % 3 == 2 && !deep ? 2U : 1U};
    shape.transitions = {deep ? 1U : 0U, deep ? 1U : 2U};
    shape.platform_operations = {0, 1};
    shape.statements = {1, 2};
    shape.depth = deep ? 4 : 1;
    shape.composites = deep ? 75 : 25;
    return shape;
}

/// What happened to the models.
struct Tally {
    std::map<std::string, std::size_t> outcomes;
    std::map<std::string, std::size_t> constructs;  ///< in models that conform
    std::size_t models = 0, conforming = 0, cycles = 0;
};

std::string causes(const diagnostics::Diagnostics& findings) {
    std::set<std::string> codes;
    for (const auto& each : findings.sorted())
        if (each.rule->severity == diagnostics::Severity::error) codes.emplace(each.rule->code);
    return fmt::format("refused: {}", fmt::join(codes, " "));
}

std::string kind_of(const Result& result) {
    switch (result.outcome) {
        case Outcome::conforms:
            return "conforms";
        case Outcome::differs:
            return "DIFFERS";
        case Outcome::not_schedulable:
            return "not schedulable";
        default:
            return "inconclusive: " + result.reason.substr(0, 60);
    }
}

std::string told(std::uint64_t seed, const Result& result) {
    std::string text = fmt::format("seed {}: {}\nexpected: {}\n", seed, result.reason, result.expected);
    for (const Cycle& cycle : result.cycles)
        text += fmt::format("in {} out {} state {}\n", fmt::join(cycle.inputs, ", "), fmt::join(cycle.outputs, ", "),
                            cycle.state);
    return text + random_models::listing(random_models::well_formed(seed, shape_of(seed)));
}

class RandomModels : public ::testing::Test {
protected:
    void add(std::uint64_t seed) {
        ++tally_.models;
        const auto loaded = random_models::load(random_models::well_formed(seed, shape_of(seed)));
        diagnostics::Diagnostics findings;
        const ir::System system = ir::lower(loaded->model, loaded->sources, findings);
        const ir::Instantiation instantiation = ir::instantiate(system, {}, findings);
        std::unique_ptr<Candidate> ready;
        if (findings.ok()) {
            const ir::Module& module = system.modules.at(0);
            const ir::ComponentRef ref{ir::ComponentKind::module, module.name, module.package, 0};
            ready = candidate(system, instantiation, ref, options(), loaded->sources, findings);
        }
        if (!ready) {
            ++tally_.outcomes[causes(findings)];
            return;
        }
        candidates_.push_back(std::move(ready));
        seeds_.push_back(seed);
        if (candidates_.size() == at_once) judge_all();
    }

    void judge_all() {
        if (candidates_.empty()) return;
        std::string error;
        const auto batch = Batch::build(std::move(candidates_), options(), error);
        candidates_.clear();
        ASSERT_TRUE(batch) << fmt::format("seeds {}\n{}", fmt::join(seeds_, " "), error.substr(0, 4000));
        for (std::size_t i = 0; i < batch->size(); ++i)
            count(seeds_[i], batch->candidate(i), batch->judge(i, steady_clock::now() + std::chrono::seconds(4)));
        seeds_.clear();
    }

    void count(std::uint64_t seed, const Candidate& candidate, const Result& result) {
        ++tally_.outcomes[kind_of(result)];
        EXPECT_NE(result.outcome, Outcome::differs) << told(seed, result);
        EXPECT_TRUE(result.warnings.empty()) << told(seed, result);
        if (result.outcome != Outcome::conforms) return;
        ++tally_.conforming;
        tally_.cycles += result.code_cycles;
        for (const std::string& word : test::constructs(candidate.system)) ++tally_.constructs[word];
    }

    /// Where a thousand models are tried; fewer do not have everything.
    void expect_everything() const {
        if (tally_.models < 1000) return;
        for (const std::string& word : test::claimed_constructs())
            EXPECT_GT(tally_.constructs.count(word), 0U) << word << " is in no model that conforms";
    }

    static constexpr std::size_t at_once = 50;
    [[nodiscard]] Options options() const {
        Options options;
        options.generator.choices = all_choices_;
        options.flags = "-std=c++17 -O0 -fno-exceptions -fno-rtti -Wall -Wextra -Wpedantic -Wconversion -Werror";
        if (const char* compiler = std::getenv("ROBOCHART_COMPILER")) options.compiler = compiler;
        options.limits.max_states = 30'000;
        options.walks.cycles = 0;  // what is too large is counted
        return options;
    }

    std::vector<std::unique_ptr<Candidate>> candidates_;
    std::vector<std::uint64_t> seeds_;
    bool all_choices_ = false;
    Tally tally_;
};

TEST_F(RandomModels, Conform) {
    for (const std::uint64_t seed : random_models::seeds(tests::rounds(1000))) {
        add(seed);
        if (HasFatalFailure()) return;
    }
    judge_all();
    fmt::print("{} models, {} conform in {} cycles\n", tally_.models, tally_.conforming, tally_.cycles);
    for (const auto& [outcome, count] : tally_.outcomes) fmt::print("{:8} {}\n", count, outcome);
    std::string used;
    for (const auto& [word, count] : tally_.constructs)
        used += fmt::format("{}{}: {}", used.empty() ? "" : ", ", word, count);
    fmt::print("models that conform and have: {}\n", used);
    EXPECT_GE(tally_.conforming * 2, tally_.models) << "too few can be explored";
    expect_everything();
}

/// Whatever the code answers where the model leaves a choice, it does what the model allows.
TEST_F(RandomModels, ConformInAllChoices) {
    all_choices_ = true;
    for (const std::uint64_t seed : random_models::seeds(tests::rounds(50))) {
        add(seed);
        if (HasFatalFailure()) return;
    }
    judge_all();
    EXPECT_GE(tally_.conforming * 2, tally_.models) << "too few can be explored";
}

}  // namespace
}  // namespace robochart::conformance
