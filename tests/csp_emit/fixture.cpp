// SPDX-License-Identifier: Apache-2.0
#include "tests/csp_emit/fixture.hpp"

#include <fstream>
#include <sstream>

#include "base/diagnostics/render.hpp"
#include "frontend/project/project.hpp"
#include "frontend/syntax/parse.hpp"
#include "frontend/toolkits/toolkits.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/lower/lower.hpp"
#include "tests/codes.hpp"

namespace robochart::csp_emit::testing {
namespace {

void finish_model(Model& model, frontend::Model& parsed) {
    if (model.diagnostics.ok()) model.system = ir::lower(parsed, model.sources, model.diagnostics);
    if (model.diagnostics.ok()) model.instantiation = ir::instantiate_system(model.system, {}, model.diagnostics);
}

}  // namespace

std::string Model::messages() const {
    return diagnostics::render_text(sources, diagnostics);
}

std::vector<std::string> Model::codes() const {
    return robochart::tests::codes_but_advice(diagnostics);
}

Emission Model::emit(Time time, bool core) {
    return csp_emit::emit(system, instantiation, time, {core}, sources, diagnostics);
}

Emission Model::emit_with_memories(Time time, bool core) {
    return csp_emit::emit(system, instantiation, time, {core, 0}, sources, diagnostics);
}

std::unique_ptr<Model> model_of(const std::vector<std::pair<std::string, std::string>>& files) {
    auto result = std::make_unique<Model>();
    frontend::Model parsed;
    for (const auto& [path, text] : files)
        parsed.files.push_back(frontend::parse(result->sources, result->sources.add(path, text),
                                               path.ends_with(".assertions") || path.ends_with(".rsa"),
                                               result->diagnostics));
    frontend::add_toolkits(result->sources, parsed, result->diagnostics);
    frontend::resolve(parsed, result->diagnostics);
    finish_model(*result, parsed);
    return result;
}

std::unique_ptr<Model> load_model(const std::string& rct, const std::string& assertions) {
    if (assertions.empty()) return model_of({{"model.rct", rct}});
    return model_of({{"model.rct", rct}, {"model.assertions", assertions}});
}

std::unique_ptr<Model> model_file(const std::string& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return load_model(text.str());
}

std::unique_ptr<Model> project(const std::string& path) {
    auto result = std::make_unique<Model>();
    const auto parsed = frontend::load_project(result->sources, path, result->diagnostics);
    finish_model(*result, *parsed);
    return result;
}

}  // namespace robochart::csp_emit::testing
