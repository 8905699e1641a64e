// SPDX-License-Identifier: Apache-2.0
// Generates random models of the language's reactive core, compiles their code in batches, explores it over all inputs
// and compares it with the semantics. No discrepancy is accepted. ROBOCHART_SEEDS=N sets the number of models and
// ROBOCHART_FIRST_SEED=N the first one. ROBOCHART_REPORT=FILE writes one line per count to FILE
// (tests/long.sh conformance).
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <map>

#include "semantics/lower/lower.hpp"
#include "tests/conformance/random/constructs.hpp"
#include "tests/conformance/random/random_campaign.hpp"
#include "tests/conformance/random/random_shapes.hpp"
#include "tests/random_models/models/well_formed.hpp"
#include "tests/random_models/tests/seeds.hpp"
#include "tests/rounds.hpp"

namespace robochart::conformance::test {
namespace {

struct NamedShape {
    std::string_view name;
    random_models::Shape (*of)(std::uint64_t seed);
};
constexpr std::array shapes = {NamedShape{"core", core_shape}, NamedShape{"widened", widened_shape},
                               NamedShape{"toolkits", toolkits_shape}, NamedShape{"hostile", hostile_shape}};

/// Checks coverage, but only for campaigns of at least a thousand models. Fewer models do not cover every construct.
void expect_everything(const Tally& tally) {
    if (tally.models < 1000) return;
    for (const std::string& word : claimed_constructs())
        EXPECT_GT(tally.constructs.count(word), 0U) << word << " is in no model that conforms";
}

double seconds(int who) {
    rusage used{};
    getrusage(who, &used);
    const auto in_seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
    };
    return in_seconds(used.ru_utime) + in_seconds(used.ru_stime);
}

void print(const Tally& tally) {
    fmt::print("{:.0f} CPU seconds here, {:.0f} in compilers\n", seconds(RUSAGE_SELF), seconds(RUSAGE_CHILDREN));
    fmt::print("{} models, {} conform in {} cycles\n", tally.models, tally.conforming, tally.cycles);
    for (const auto& [outcome, count] : tally.outcomes) fmt::print("{:8} {}\n", count, outcome);
    std::string used;
    for (const auto& [word, count] : tally.constructs)
        used += fmt::format("{}{}: {}", used.empty() ? "" : ", ", word, count);
    fmt::print("models that conform and have: {}\n", used);
}

/// Writes lines for a script that adds up several runs: `models N`, `outcome N what`, `construct N what`, `disagreement
/// SEED what`, and `whole` at the end. If there is a single model, which a person will inspect, it also writes a shrunk
/// model that disagrees.
void write_report(const Campaign& campaign) {
    const char* path = std::getenv("ROBOCHART_REPORT");
    if (path == nullptr) return;
    const Tally& tally = campaign.tally();
    std::ofstream out(path);
    out << fmt::format("models {}\nconforming {}\ncycles {}\n", tally.models, tally.conforming, tally.cycles);
    for (const auto& [outcome, count] : tally.outcomes) out << fmt::format("outcome {} {}\n", count, outcome);
    for (const auto& [word, count] : tally.constructs) out << fmt::format("construct {} {}\n", count, word);
    for (const Disagreement& found : tally.disagreements)
        out << fmt::format("disagreement {} {}\n", found.seed, found.what.substr(0, found.what.find('\n')));
    constexpr std::size_t budget = 200;
    if (tally.models == 1)
        for (const Disagreement& found : tally.disagreements) out << campaign.shrink_disagreement(found, budget);
    out << "whole\n";
}

Campaign run(random_models::Shape (*shape_of)(std::uint64_t), bool all_choices, std::size_t models) {
    Campaign campaign(shape_of, all_choices);
    for (const std::uint64_t seed : random_models::seeds(models)) campaign.add_model(seed);
    campaign.judge_remaining();
    for (const Disagreement& found : campaign.tally().disagreements)
        ADD_FAILURE() << "seed " << found.seed << ": " << found.what;
    write_report(campaign);
    return campaign;
}

TEST(RandomModels, Conform) {
    const Campaign campaign = run(core_shape, false, 100);
    print(campaign.tally());
    EXPECT_GE(campaign.tally().conforming * 2, campaign.tally().models) << "too few can be explored";
    expect_everything(campaign.tally());
}

/// ROBOCHART_MODELS names the shape of the models (tests/long.sh conformance).
TEST(RandomModels, Campaign) {
    const char* named = std::getenv("ROBOCHART_MODELS");
    if (named == nullptr) GTEST_SKIP() << "ROBOCHART_MODELS is not set";
    const auto shape = std::ranges::find_if(shapes, [&](const auto& candidate) { return candidate.name == named; });
    ASSERT_NE(shape, shapes.end()) << named;
    print(run(shape->of, false, 1000).tally());
}

/// The widened shape generates all of its constructs in small models. The test counts them without generating code.
TEST(RandomModels, WidenedHaveEveryConstruct) {
    std::map<std::string, std::size_t> counts;
    constexpr std::size_t models = 1500;
    for (std::uint64_t seed = 0; seed < models; ++seed) {
        const auto loaded = random_models::load(random_models::well_formed(seed, widened_shape(seed)));
        ASSERT_EQ(loaded->findings.error_count(), 0U) << "seed " << seed << "\n" << loaded->report();
        const ir::System system = ir::lower(loaded->model, loaded->sources, loaded->findings);
        for (const std::string& word : constructs_in(system)) ++counts[word];
    }
    for (const std::string& word : widened_constructs()) EXPECT_GE(counts[word], 3U) << word << " is made too seldom";
}

/// The models contain calls that may violate a precondition. The widened shape has such calls only for the model's own
/// functions.
TEST(RandomModels, OfToolkitsCallWhatHasPreconditions) {
    std::size_t found = 0;
    constexpr std::size_t models = 200;
    for (std::uint64_t seed = 0; seed < models; ++seed) {
        const auto loaded = random_models::load(random_models::well_formed(seed, toolkits_shape(seed)));
        ASSERT_EQ(loaded->findings.error_count(), 0U) << "seed " << seed << "\n" << loaded->report();
        const ir::System system = ir::lower(loaded->model, loaded->sources, loaded->findings);
        found += constructs_in(system).count("call of a toolkit function with a precondition");
    }
    EXPECT_GE(found, 3U);
}

/// Tests a few models of each other shape. tests/long.sh conformance runs many.
TEST(RandomModels, OfTheOtherShapesConform) {
    for (const NamedShape& shape : shapes) {
        if (shape.of == core_shape) continue;
        SCOPED_TRACE(shape.name);
        const Campaign campaign = run(shape.of, false, 75);
        EXPECT_GE(campaign.tally().conforming * 2, campaign.tally().models) << "too few can be explored";
    }
}

/// The code conforms for every answer at every choice.
TEST(RandomModels, ConformInAllChoices) {
    const Campaign campaign = run(core_shape, true, 50);
    EXPECT_GE(campaign.tally().conforming * 2, campaign.tally().models) << "too few can be explored";
}

}  // namespace
}  // namespace robochart::conformance::test
