// Every counterexample that tests can make is replayed from its JSON.
#include "tests/app/replay.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "random_models/well_formed.hpp"
#include "tests/app/command.hpp"
#include "tests/rounds.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::app::testing {
namespace {

namespace fs = std::filesystem;

void show(const char* what, const Replayed& sum) {
    if (std::getenv("ROBOCHART_SHOW") == nullptr) return;
    std::printf("%s: %zu assertions, %zu counterexamples, %zu steps, %zu states of machines\n", what, sum.assertions,
                sum.counterexamples, sum.steps, sum.machines);
    for (const auto& [kind, count] : sum.endings) std::printf("  end %s: %zu\n", kind.c_str(), count);
    for (const auto& [kind, count] : sum.kinds) std::printf("  step %s: %zu\n", kind.c_str(), count);
}

void expect_no_faults(const Replayed& sum) {
    std::string all;
    for (std::size_t i = 0; i < sum.faults.size() && i < 10; ++i) all += sum.faults[i] + "\n";
    EXPECT_TRUE(sum.faults.empty()) << sum.faults.size() << " faults\n" << all;
}

TEST(Replay, OfTheCorpusAndItsFalseClaims) {
    Replayed sum;
    replay({repository("corpus/aggregation"), repository("corpus/false_claims/aggregation.assertions")}, true, sum);
    replay({repository("corpus/swarm_taxis"), repository("corpus/false_claims/swarm_taxis.assertions")}, true, sum);
    show("corpus", sum);
    expect_no_faults(sum);
    EXPECT_GE(sum.counterexamples, 3U);
}

TEST(Replay, OfRandomModelsCoreAssertions) {
    Replayed sum;
    std::size_t count = tests::rounds(30);
    std::size_t first = 0;
    if (const char* wanted = std::getenv("ROBOCHART_SEEDS")) count = std::stoull(wanted);
    if (const char* wanted = std::getenv("ROBOCHART_FIRST_SEED")) first = std::stoull(wanted);
    for (std::size_t seed = first; seed < first + count; ++seed) {
        const TemporaryFile folder("README", "");
        const std::string path = fs::path(folder.path()).parent_path().string();
        const std::string error = random_models::write(random_models::well_formed(seed, random_models::Shape::timed_core()), path);
        ASSERT_EQ(error, "");
        if (std::getenv("ROBOCHART_SHOW") != nullptr) std::printf("seed %zu\n", seed), std::fflush(stdout);
        replay({path}, true, sum);
    }
    show("random models", sum);
    expect_no_faults(sum);
    EXPECT_GE(sum.counterexamples, count);
}

TEST(Replay, OfSuitesWhereTheyAre) {
    const fs::path shared = tests::shared_folder();
    if (shared.empty()) GTEST_SKIP() << "no shared material";
    Replayed sum;
    for (const char* suite : {"suite/robotool/accept", "suite/findings/agreeing"}) {
        if (!fs::is_directory(shared / suite)) continue;
        for (const auto& entry : fs::directory_iterator(shared / suite))
            if (entry.is_directory()) replay({entry.path().string()}, true, sum);
    }
    show("suites", sum);
    expect_no_faults(sum);
    EXPECT_GE(sum.counterexamples, 50U);
}

}  // namespace
}  // namespace robochart::app::testing
