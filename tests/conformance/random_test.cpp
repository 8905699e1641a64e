// Random models of the language's reactive core: emitted, compiled in batches, explored over all inputs, compared with
// their semantics. No discrepancy is accepted. ROBOCHART_SEEDS=N and ROBOCHART_FIRST_SEED=N try others,
// ROBOCHART_REPORT=FILE has a line for each count written there (scripts/random_conformance.sh).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "tests/conformance/constructs.hpp"
#include "tests/conformance/random_campaign.hpp"
#include "tests/conformance/random_shapes.hpp"
#include "tests/random_models/seeds.hpp"
#include "tests/rounds.hpp"

namespace robochart::conformance::test {
namespace {

/// Where a thousand models are tried; fewer do not have everything.
void expect_everything(const Tally& tally) {
    if (tally.models < 1000) return;
    for (const std::string& word : claimed_constructs())
        EXPECT_GT(tally.constructs.count(word), 0U) << word << " is in no model that conforms";
}

void print(const Tally& tally) {
    fmt::print("{} models, {} conform in {} cycles\n", tally.models, tally.conforming, tally.cycles);
    for (const auto& [outcome, count] : tally.outcomes) fmt::print("{:8} {}\n", count, outcome);
    std::string used;
    for (const auto& [word, count] : tally.constructs)
        used += fmt::format("{}{}: {}", used.empty() ? "" : ", ", word, count);
    fmt::print("models that conform and have: {}\n", used);
}

/// For a script that adds up several runs: `models N`, `outcome N what`, `construct N what`, `SEED` and what differs.
void write_report(const Campaign& campaign, std::size_t to_shrink) {
    const char* path = std::getenv("ROBOCHART_REPORT");
    if (path == nullptr) return;
    const Tally& tally = campaign.tally();
    std::ofstream out(path);
    out << fmt::format("models {}\nconforming {}\ncycles {}\n", tally.models, tally.conforming, tally.cycles);
    for (const auto& [outcome, count] : tally.outcomes) out << fmt::format("outcome {} {}\n", count, outcome);
    for (const auto& [word, count] : tally.constructs) out << fmt::format("construct {} {}\n", count, word);
    for (std::size_t i = 0; i < tally.disagreements.size(); ++i) {
        const Disagreement& found = tally.disagreements[i];
        out << fmt::format("disagreement {} {}\n", found.seed, found.what.substr(0, found.what.find('\n')));
    }
    for (std::size_t i = 0; i < std::min(to_shrink, tally.disagreements.size()); ++i)
        out << "shrunk\n" << campaign.shrunk(tally.disagreements[i], 150) << "end of shrunk\n";
}

Campaign run(random_models::Shape (*shape_of)(std::uint64_t), bool all_choices, std::size_t models) {
    Campaign campaign(shape_of, all_choices);
    for (const std::uint64_t seed : random_models::seeds(models)) campaign.add(seed);
    campaign.finish();
    for (const Disagreement& found : campaign.tally().disagreements)
        ADD_FAILURE() << "seed " << found.seed << ": " << found.what;
    constexpr std::size_t to_shrink = 3;
    write_report(campaign, to_shrink);
    return campaign;
}

TEST(RandomModels, Conform) {
    const Campaign campaign = run(core_shape, false, tests::rounds(1000));
    print(campaign.tally());
    EXPECT_GE(campaign.tally().conforming * 2, campaign.tally().models) << "too few can be explored";
    expect_everything(campaign.tally());
}

/// With what the core leaves out. By scripts/random_conformance.sh, until the generator takes all of it.
TEST(RandomModels, ConformWidened) {
    if (std::getenv("ROBOCHART_WIDENED") == nullptr) GTEST_SKIP() << "ROBOCHART_WIDENED is not set";
    print(run(widened_shape, false, tests::rounds(1000)).tally());
}

/// Whatever the code answers where the model leaves a choice, it does what the model allows.
TEST(RandomModels, ConformInAllChoices) {
    const Campaign campaign = run(core_shape, true, tests::rounds(50));
    EXPECT_GE(campaign.tally().conforming * 2, campaign.tally().models) << "too few can be explored";
}

}  // namespace
}  // namespace robochart::conformance::test
