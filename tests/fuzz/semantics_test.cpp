// SPDX-License-Identifier: Apache-2.0
// Tests the components after the front end on well-formed and almost well-formed models: random models, the corpus, and
// models of the tests. ROBOCHART_SEEDS=N tries N models, and ROBOCHART_FIRST_SEED=N begins with another seed.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/contents.hpp"
#include "tests/fuzz/targets/targets.hpp"
#include "tests/random_models/changes/near.hpp"
#include "tests/random_models/models/well_formed.hpp"
#include "tests/random_models/tests/seeds.hpp"
#include "tests/rounds.hpp"
#include "tests/source_folder.hpp"

namespace robochart::fuzz {
namespace {

using tests::read_contents;

namespace fs = std::filesystem;

using random_models::Project;
using random_models::Shape;

/// Returns the project in the target's input format.
std::string bytes_of(const Project& project) {
    std::string bytes;
    for (const random_models::Text& file : project)
        bytes += (bytes.empty() ? "" : "\f") + std::string(file.is_assertions() ? "!" : "") + file.text;
    return bytes;
}

/// Returns the projects in the subfolders of these folders.
std::vector<Project> kept_projects() {
    std::vector<Project> projects;
    for (const char* folder : {"corpus", "tests/app/agreeing", "tests/conformance/models", "tests/cpp_emit/models"}) {
        std::vector<fs::path> models;
        for (const auto& entry : fs::directory_iterator(tests::source_folder() / folder))
            if (entry.is_directory()) models.push_back(entry.path());
        std::ranges::sort(models);
        for (const fs::path& model : models) {
            Project project;
            for (const auto& entry : fs::directory_iterator(model))
                if (entry.path().extension() == ".rct" || entry.path().extension() == ".assertions")
                    project.push_back({entry.path().filename(), read_contents(entry.path())});
            std::ranges::sort(project, [](const auto& a, const auto& b) { return a.path < b.path; });
            if (!project.empty()) projects.push_back(std::move(project));
        }
    }
    return projects;
}

/// Returns a shape of small models with all constructs of the language.
Shape small_shape(std::uint64_t seed) {
    Shape shape = Shape::whole_language();
    shape.files = {1, 2};
    shape.controllers = shape.machines = {1, 1};
    shape.states = {1, 2};
    shape.transitions = {0, 1};
    shape.variables = {0, 2};
    shape.events = {1, 2};
    shape.depth = seed % 3;
    shape.data.expression_depth = 1;
    shape.data.largest = 3;
    shape.statements = {1, 2};
    shape.broadcast = seed % 4 == 0;
    return shape;
}

TEST(Semantics, TakesOrRefusesWellFormedModels) {
    for (const std::uint64_t seed : random_models::seeds(24))
        EXPECT_EQ(run_semantics(bytes_of(random_models::well_formed(seed, small_shape(seed)))), "") << "seed " << seed;
}

TEST(Semantics, TakesOrRefusesNearlyWellFormedModels) {
    const std::vector<Project> projects = kept_projects();
    ASSERT_GE(projects.size(), 40U);
    for (const std::uint64_t seed : random_models::seeds(160)) {
        random_models::Random random(seed);
        const Project base =
            random.chance(50) ? random_models::well_formed(seed, small_shape(seed)) : random.pick(projects);
        const Project near = random_models::mutate_project(base, random);
        EXPECT_EQ(run_semantics(bytes_of(near)), "") << "seed " << seed << "\n" << random_models::listing(near);
    }
}

}  // namespace
}  // namespace robochart::fuzz
