// SPDX-License-Identifier: Apache-2.0
// Tests the adapter for Enki. The generated controller aggregates in Enki too, and faulty controllers do not. Scenarios
// with features that Enki lacks are rejected.
#include "simulation/adapters/enki/enki_stage.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "simulation/report/report.hpp"
#include "simulation/report/run.hpp"
#include "tests/simulation/harness.hpp"
#include "tests/source_folder.hpp"

namespace robochart::simulation {
namespace {

using testing::Experiment;
using testing::read_file;
using testing::replaced;

const std::string corpus = tests::source_folder().string() + "/corpus/";

RunResult run_in_enki(Experiment& experiment) {
    return experiment.run(1, enki_stage);  // Enki's random generator is global
}

TEST(Enki, OneClusterInAllTenTrials) {
    Experiment experiment(read_file(corpus + "aggregation/aggregation.rct"),
                          read_file(corpus + "aggregation/aggregation.scenario"));
    const RunResult result = run_in_enki(experiment);
    EXPECT_TRUE(result.all_hold()) << bands_text(experiment.scenario, result) << experiment.messages();
}

TEST(Enki, BrokenControllersFail) {
    const std::string model = read_file(corpus + "aggregation/aggregation.rct");
    const std::string scenario =
        replaced(read_file(corpus + "aggregation/aggregation.scenario"), "trials 10", "trials 2");
    for (const std::string& text : testing::broken_aggregation(model)) {
        Experiment experiment(text, scenario);
        const RunResult result = run_in_enki(experiment);
        ASSERT_TRUE(experiment.diagnostics.ok()) << experiment.messages();
        EXPECT_FALSE(result.bands.at(0).holds) << bands_text(experiment.scenario, result);
    }
}

TEST(Enki, SameSeedSameBits) {
    Experiment experiment(read_file(corpus + "aggregation/aggregation.rct"),
                          replaced(read_file(corpus + "aggregation/aggregation.scenario"), "trials 10", "trials 1"));
    const RunResult one = run_in_enki(experiment);
    const RunResult two = run_in_enki(experiment);
    for (std::size_t r = 0; r < 20; ++r)
        EXPECT_EQ(one.trials.at(0).frames.back().poses[r].at, two.trials.at(0).frames.back().poses[r].at);
}

TEST(Enki, RefusesWhatItLacks) {
    Experiment experiment(read_file(corpus + "swarm_taxis/swarm_taxis.rct"),
                          read_file(corpus + "swarm_taxis/swarm_taxis.scenario"));
    (void)run_in_enki(experiment);
    EXPECT_NE(experiment.codes().find("RC-M15 RC-M15"), std::string::npos) << experiment.messages();
}

/// A robot in Enki and one in the embedded world follow the same path.
TEST(Enki, DrivesAsTheEmbeddedWorldDoes) {
    std::string text = replaced(read_file(corpus + "aggregation/aggregation.scenario"), "trials 10", "trials 1");
    text = replaced(text, "noise 5 %", "");
    text = replaced(text, "robots 20", "robots 1");
    text = replaced(text, "place random in (-125 cm, -125 cm) to (125 cm, 125 cm)",
                    "place at (0 cm, 0 cm) heading 30 deg");
    Experiment experiment(read_file(corpus + "aggregation/aggregation.rct"), text);
    const RunResult enki = run_in_enki(experiment);
    const RunResult own = experiment.run(1);
    const auto& a = enki.trials.at(0).frames;
    const auto& b = own.trials.at(0).frames;
    ASSERT_EQ(a.size(), b.size());
    // The path is a circle of 14.5 cm. After ten seconds the positions differ by at most a few millimetres.
    for (std::size_t f = 0; f <= 20; ++f) EXPECT_LT(length(a[f].poses[0].at - b[f].poses[0].at), 1.0) << a[f].time;
}

}  // namespace
}  // namespace robochart::simulation
