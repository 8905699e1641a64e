// SPDX-License-Identifier: Apache-2.0
// Tests that all models in accept/ of RoboTool's regression suite can be lowered.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "semantics/instantiate/instantiate.hpp"
#include "semantics/ir/instantiation.hpp"
#include "tests/semantics/lower/lowering_fixture.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::ir {
namespace {

using namespace samples;
namespace fs = std::filesystem;

std::unique_ptr<Lowered> read(const fs::path& folder) {
    auto result = std::make_unique<Lowered>();
    const auto model = frontend::load_project(result->sources, folder.string(), result->diagnostics);
    if (result->diagnostics.ok()) result->system = lower(*model, result->sources, result->diagnostics);
    return result;
}

std::vector<fs::path> models() {
    std::vector<fs::path> folders;
    const fs::path accept = robochart::tests::shared_folder() / "suite/robotool/accept";
    if (!fs::exists(accept)) return folders;
    for (const auto& entry : fs::directory_iterator(accept))
        if (entry.is_directory()) folders.push_back(entry.path());
    std::ranges::sort(folders);
    return folders;
}

TEST(Suite, AcceptedModelsLower) {
    const auto folders = models();
    if (folders.empty()) GTEST_SKIP() << "RoboTool's models are absent (set ROBOCHART_SHARED)";
    for (const auto& folder : folders) {
        const auto lowered = read(folder);
        EXPECT_TRUE(lowered->diagnostics.ok()) << folder << "\n" << lowered->messages();
        if (!lowered->diagnostics.ok()) continue;
        const auto inst = instantiate_system(lowered->system, {}, lowered->diagnostics);
        EXPECT_TRUE(lowered->diagnostics.ok()) << folder << "\n" << lowered->messages();
        EXPECT_EQ(inst.scale, 1) << folder;
    }
}

}  // namespace
}  // namespace robochart::ir
