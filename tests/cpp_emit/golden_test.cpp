// SPDX-License-Identifier: Apache-2.0
// Tests the layout of generated text, as a reader of the code sees it, for one small machine (golden/door.rct). After
// an intended change of layout, read the new text and store it in golden/.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "base/diagnostics/render.hpp"
#include "frontend/project/project.hpp"
#include "semantics/lower/lower.hpp"
#include "tests/cpp_emit/harness.hpp"
#include "tests/source_folder.hpp"

namespace robochart::cpp_emit::golden_test {
namespace {

const std::string folder = tests::source_folder().string() + "/tests/cpp_emit/golden/";

std::string read_golden(const std::string& name) {
    std::ostringstream text;
    text << std::ifstream(folder + name).rdbuf();
    return text.str();
}

TEST(Golden, TheDoorsCodeIsLaidOutAsStored) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const auto model = frontend::load_project(sources, folder + "door.rct", diagnostics);
    const ir::System system = ir::lower(*model, sources, diagnostics);
    ASSERT_TRUE(diagnostics.ok()) << diagnostics::render_text(sources, diagnostics);
    Options options;
    options.sources = &sources;
    const Emission emission = testing::emit_ok(system, testing::component_named(system, "Door"), options);
    for (const OutputFile& file : emission.files) {
        if (file.path != "Door_core.hpp" && file.path != "Door.hpp") continue;
        EXPECT_EQ(file.text, read_golden(file.path)) << file.path;
        if (const char* target = std::getenv("ROBOCHART_STORE_GOLDEN"))
            std::ofstream(std::string(target) + "/" + file.path) << file.text;
    }
}

}  // namespace
}  // namespace robochart::cpp_emit::golden_test
