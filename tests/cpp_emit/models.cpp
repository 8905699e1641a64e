#include "tests/cpp_emit/models.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "diagnostics/render.hpp"
#include "frontend/project.hpp"
#include "semantics/lower.hpp"

namespace robochart::cpp_emit::testing {

namespace {

ir::System lowered(const diagnostics::SourceManager& sources, const frontend::Model& model,
                   diagnostics::Diagnostics& diagnostics) {
    if (!diagnostics.ok()) {
        ADD_FAILURE() << diagnostics::render_text(sources, diagnostics);
        return {};
    }
    ir::System system = ir::lower(model, sources, diagnostics);
    EXPECT_TRUE(diagnostics.ok()) << diagnostics::render_text(sources, diagnostics);
    return system;
}

}  // namespace

ir::System corpus(const std::string& name) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const auto model =
        frontend::load_project(sources, std::string(ROBOCHART_SOURCE_DIR) + "/corpus/" + name, diagnostics);
    return lowered(sources, *model, diagnostics);
}

ir::System model(const std::string& text) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const diagnostics::SourceId source = sources.add("test.rct", text);
    frontend::Model model;
    model.files.push_back(frontend::parse(sources, source, false, diagnostics));
    frontend::resolve(model, diagnostics);
    return lowered(sources, model, diagnostics);
}

}  // namespace robochart::cpp_emit::testing
