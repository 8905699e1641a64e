// SPDX-License-Identifier: Apache-2.0
#include "tests/cpp_emit/models.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "base/diagnostics/render.hpp"
#include "frontend/project/project.hpp"
#include "frontend/syntax/parse.hpp"
#include "frontend/toolkits/toolkits.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/lower/lower.hpp"
#include "tests/source_folder.hpp"

namespace robochart::cpp_emit::testing {

const char* const typed_model = R"(package p
enumeration Light { Red Green }
interface I { go(a : real, b : nat) lamp(l : Light) var level : int }
interface E { event see : Light event count : nat event done : nat }
stm M { requires I uses E var l : Light var n : nat initial i
    state A { entry go(0.5, 3) }
    final F
    transition t0 { from i to A }
    transition t1 { from A to A trigger see?l action lamp(l) ; level = 7 }
    transition t2 { from A to F trigger count?n action done!n } }
controller C { requires I uses E sref m = M connection C on see to m on see connection C on count to m on count
    connection m on done to C on done }
robotic platform R { provides I uses E }
module Mod { rref r = R cref c = C connection r on see to c on see (_async) connection r on count to c on count (_async)
    connection c on done to r on done (_async) }
)";

namespace {

ir::System lower_model(const diagnostics::SourceManager& sources, const frontend::Model& model,
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

ir::System load_corpus(const std::string& name) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const auto model =
        frontend::load_project(sources, tests::source_folder().string() + "/corpus/" + name, diagnostics);
    return lower_model(sources, *model, diagnostics);
}

ir::System load_model(const std::string& text, const std::string& path) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const diagnostics::SourceId source = sources.add(path, text);
    frontend::Model model;
    model.files.push_back(frontend::parse(sources, source, false, diagnostics));
    frontend::add_toolkits(sources, model, diagnostics);
    frontend::resolve(model, diagnostics);
    return lower_model(sources, model, diagnostics);
}

std::size_t emit_all(const std::string& project, const Folder& folder, const Options& options) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const auto model = frontend::load_project(sources, project, diagnostics);
    if (!diagnostics.ok()) return 0;
    const ir::System system = ir::lower(*model, sources, diagnostics);
    if (!diagnostics.ok()) return 0;  // invalid models are never generated
    const ir::Instantiation inst = ir::instantiate_system(system, {}, diagnostics);
    std::size_t generated = 0;
    const auto emit_each = [&](const auto& items, ir::ComponentKind kind) {
        for (std::uint32_t i = 0; i < items.size(); ++i) {
            ir::ComponentRef ref;
            ref.kind = kind;
            ref.definition = i;
            diagnostics::Diagnostics refusals;
            Emission emission = emit(system, inst, ref, options, refusals);
            if (emission.files.empty()) continue;
            const std::string name = std::to_string(std::hash<std::string>{}(project)) + "_" +
                                     std::to_string(static_cast<int>(kind)) + "_" + std::to_string(i);
            for (OutputFile& file : emission.files) file.path.insert(0, name + "/");
            folder.write(emission);
            ++generated;
        }
    };
    emit_each(system.machines, ir::ComponentKind::machine);
    emit_each(system.controllers, ir::ComponentKind::controller);
    emit_each(system.modules, ir::ComponentKind::module);
    return generated;
}

}  // namespace robochart::cpp_emit::testing
