// Random models: emitted, compiled in batches, explored, compared with their semantics; no discrepancy is accepted.
// ROBOCHART_SEEDS=N and ROBOCHART_FIRST_SEED=N try others (scripts/random_conformance.sh).
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>

#include "conformance/batch.hpp"
#include "random_models/well_formed.hpp"
#include "semantics/lower.hpp"
#include "tests/random_models/seeds.hpp"
#include "tests/rounds.hpp"

namespace robochart::conformance {
namespace {

using random_models::Shape;

/// Small systems of several kinds: deep ones, ones of several machines or controllers, ones without time.
Shape shape_of(std::uint64_t seed) {
    if (std::getenv("ROBOCHART_OLD")) {
        Shape shape = seed % 2 == 0 ? Shape::timed_core() : Shape::untimed_core();
    shape.assertions = false;
    shape.events = {1, 2};
    shape.variables = {0, 1};
    shape.controllers = {1, seed % 3 == 0 ? 2U : 1U};
    shape.machines = {1, seed % 3 == 1 ? 2U : 1U};
    shape.states = {1, 2};
    shape.transitions = {0, 2};
    shape.platform_operations = {0, 1};
    shape.statements = {1, 2};
    return shape;
    }
    Shape shape = seed % 6 == 0 ? Shape::untimed_core() : Shape::timed_core();
    shape.paced = shape.time && seed % 6 != 1;
    shape.assertions = false;
    shape.inputs_in_actions = shape.else_conditions = true;
    shape.events = {1, 2};
    shape.variables = {0, 1};
    shape.controllers = {1, seed % 3 == 0 ? 2U : 1U};
    shape.machines = {1, seed % 3 == 1 ? 2U : 1U};
    shape.states = {1, seed % 3 == 2 ? 2U : 1U};
    shape.transitions = {0, 2};
    shape.platform_operations = {0, 1};
    shape.statements = {1, 2};
    if (seed % 9 == 2) shape.depth = 4;
    if (seed % 9 == 2) shape.composites = 75;
    if (seed % 9 == 2) shape.states = shape.transitions = {1, 1};
    return shape;
}

struct Tally {
    std::map<std::string, std::size_t> outcomes;
    double generating = 0, compiling = 0, judging = 0;
};

std::string told(const Result& result) {
    std::string text = "\nexpected: " + result.expected + "\n";
    for (const Cycle& cycle : result.cycles)
        text += fmt::format("in {} out {} state {}\n", fmt::join(cycle.inputs, ", "), fmt::join(cycle.outputs, ", "), cycle.state);
    return text;
}

double seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

class Random : public ::testing::Test {
protected:
    void add(std::uint64_t seed) {
        const auto loaded = random_models::load(random_models::well_formed(seed, shape_of(seed)));
        diagnostics::Diagnostics findings;
        ir::System system = ir::lower(loaded->model, loaded->sources, findings);
        const ir::Instantiation instantiation = ir::instantiate(system, {}, findings);
        const ir::Module& module = system.modules.at(0);
        const ir::ComponentRef ref{ir::ComponentKind::module, module.name, module.package, 0};
        std::unique_ptr<Candidate> ready;
        if (findings.ok()) ready = candidate(std::move(system), instantiation, ref, options_, loaded->sources, findings);
        if (!ready) {
            std::string codes;
            for (const auto& each : findings.sorted())
                if (each.rule->severity == diagnostics::Severity::error && codes.find(each.rule->code) == std::string::npos)
                    codes += fmt::format(" {}", each.rule->code);
            ++tally_.outcomes["refused" + codes];
            return;
        }
        candidates_.push_back(std::move(ready));
        seeds_.push_back(seed);
        if (candidates_.size() == at_once) judge_all();
    }

    void judge_all() {
        if (candidates_.empty()) return;
        std::string error;
        const auto start = std::chrono::steady_clock::now();
        const auto batch = Batch::build(std::move(candidates_), options_, error);
        candidates_.clear();
        tally_.compiling += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        ASSERT_TRUE(batch) << error.substr(0, 4000);
        const double before = seconds();
        for (std::size_t i = 0; i < batch->size(); ++i) {
            const auto begun = std::chrono::steady_clock::now();
            const Result result = batch->judge(i, begun + std::chrono::seconds(2));
            const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
            if (took > 0.5) fmt::print("seed {}: {:.1f} s, {} states {} cycles {} model\n", seeds_[i], took, result.code_states, result.code_cycles, result.model_states);
            static constexpr const char* names[] = {"conforms", "DIFFERS", "not schedulable", "not generated", "inconclusive"};
            std::string name = names[static_cast<int>(result.outcome)];
            if (result.outcome == Outcome::inconclusive) name += ": " + result.reason.substr(0, 60);
            if (result.outcome == Outcome::not_schedulable) name += ": " + (result.reason.find("infinitely") != std::string::npos ? std::string("diverges") : result.reason.substr(result.reason.rfind(';') + 1, 6));
            ++tally_.outcomes[name];
            EXPECT_NE(result.outcome, Outcome::differs) << "seed " << seeds_[i] << ": " << result.reason << told(result) << random_models::listing(random_models::well_formed(seeds_[i], shape_of(seeds_[i])));
        }
        tally_.judging += seconds() - before;
        seeds_.clear();
    }

    static constexpr std::size_t at_once = 50;
    Options options_ = [] {
        Options options;
        options.flags = "-std=c++17 -O0 -fno-exceptions -fno-rtti -Wall -Wextra -Wpedantic -Wconversion -Werror";
        options.limits.max_states = 30'000;
        return options;
    }();
    std::vector<std::unique_ptr<Candidate>> candidates_;
    std::vector<std::uint64_t> seeds_;
    Tally tally_;
};

TEST_F(Random, ModelsConform) {
    const double start = seconds();
    for (const std::uint64_t seed : random_models::seeds(tests::rounds(100))) {
        add(seed);
        if (HasFatalFailure()) return;
    }
    judge_all();
    for (const auto& [outcome, count] : tally_.outcomes) fmt::print("{:6} {}\n", count, outcome);
    fmt::print("{:.1f} s here, {:.1f} s judging, {:.1f} s compiling\n", seconds() - start, tally_.judging, tally_.compiling);
}

}  // namespace
}  // namespace robochart::conformance
