// SPDX-License-Identifier: Apache-2.0
#include "tests/conformance/bench.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "base/diagnostics/render.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "tests/conformance/support.hpp"
#include "tests/source_folder.hpp"

namespace robochart::conformance::test {

Model::Model(const std::string& folder, const ir::InstantiationOptions& options) {
    const std::string path = folder.front() == '/' ? folder : tests::source_folder().string() + "/" + folder;
    const auto model = frontend::load_project(sources, path, diagnostics);
    if (diagnostics.ok()) system = ir::lower(*model, sources, diagnostics);
    if (diagnostics.ok()) instantiation = ir::instantiate_system(system, options, diagnostics);
    EXPECT_TRUE(diagnostics.ok()) << diagnostics::render_text(sources, diagnostics);
}

ModelFolder changed_copy(const std::string& file, const std::string& from, const std::string& to) {
    std::ifstream in(tests::source_folder().string() + "/" + file);
    std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    std::size_t changes = 0;
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()), ++changes)
        text.replace(at, from.size(), to);
    EXPECT_GT(changes, 0U) << from;
    return ModelFolder(text);
}

ir::ComponentRef Model::first_module() const {
    const ir::Module& module = system.modules.at(0);
    return {ir::ComponentKind::module, module.name, module.package, 0};
}

ir::ComponentRef Model::first_controller() const {
    const ir::Controller& controller = system.controllers.at(0);
    return {ir::ComponentKind::controller, controller.name, controller.package, 0};
}

ir::ComponentRef Model::machine_named(const std::string& name) const {
    for (std::uint32_t m = 0; m < system.machines.size(); ++m) {
        if (system.machines[m].name == name) return {ir::ComponentKind::machine, name, system.machines[m].package, m};
    }
    ADD_FAILURE() << "no machine " << name;
    return {};
}

Bench::Bench(Model& model, ir::ComponentRef component) : model_(model), component_(std::move(component)) {
    script_ =
        csp_emit::emit(model.system, model.instantiation, csp_emit::Time::timed, {}, model.sources, model.diagnostics);
    EXPECT_TRUE(model.diagnostics.ok()) << diagnostics::render_text(model.sources, model.diagnostics);
    session_ = std::make_unique<cspm::Session>(script_.definitions);
    system_ = session_->system(process());
}

cpp_emit::Emission Bench::emit(cpp_emit::Fault fault, std::uint32_t site) {
    cpp_emit::Options options;
    options.fault = fault;
    options.fault_site = site;
    options.choices = choices_;
    return cpp_emit::emit(model_.system, model_.instantiation, component_, options, model_.diagnostics);
}

std::uint32_t Bench::site_count(cpp_emit::Fault fault) {
    return emit(fault, 0).fault_sites;
}

const Interface& Bench::interface() {
    if (interface_) return *interface_;
    interface_.emplace();
    const auto object = compile_fault(cpp_emit::Fault::none, 0);
    if (!object) return *interface_;
    *interface_ = interface_of(object->interface());
    complete_interface(*interface_, model_.system, model_.instantiation, component_, script_.provenance);
    return *interface_;
}

Result Bench::judge_schedulability() {
    const Alphabet alphabet(interface(), session_->event_table());
    ModelGraph graph(*system_, alphabet);
    return check_schedulability(graph, alphabet, 1, {});
}

std::unique_ptr<SharedObject> Bench::compile_fault(cpp_emit::Fault fault, std::uint32_t site) {
    std::string error;
    auto object = compile_quietly(emit(fault, site), error);
    EXPECT_TRUE(object) << error;
    return object;
}

Result Bench::check_code(cpp_emit::Fault fault, std::uint32_t site) {
    const auto object = compile_fault(fault, site);
    return object ? check_code(object->interface()) : Result{};
}

Result Bench::check_code(const rc_interface& code, Relation relation) {
    Interface interface = interface_of(code);
    complete_interface(interface, model_.system, model_.instantiation, component_, script_.provenance);
    const Alphabet alphabet(interface, session_->event_table());
    ModelGraph graph(*system_, alphabet);
    return refined_by(graph, alphabet, code, 1, {}, relation);
}

}  // namespace robochart::conformance::test
