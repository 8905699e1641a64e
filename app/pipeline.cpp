#include "app/pipeline.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "app/rules.hpp"
#include "checker/cspm/types.hpp"
#include "diagnostics/render.hpp"
#include "frontend/project.hpp"
#include "frontend/units.hpp"
#include "semantics/lower.hpp"

namespace robochart::app {
namespace fs = std::filesystem;
namespace {

std::string project_name(const std::string& input) {
    const fs::path path = fs::path(input).lexically_normal();
    const fs::path last = path.has_filename() ? path.filename() : path.parent_path().filename();
    const std::string stem = last.stem().string();
    return stem.empty() || stem == "." || stem == ".." ? "model" : stem;
}

bool lower_all(Project& project, const Options& options) {
    for (const std::string& code : options.allowed) project.diagnostics.allow(code);
    if (!project.model) project.model = frontend::load_project(project.sources, options.inputs, project.diagnostics);
    if (!acceptable(project, options)) return false;
    project.system = ir::lower(*project.model, project.sources, project.diagnostics);
    if (!project.diagnostics.ok()) return false;
    std::string error;
    const ir::InstantiationOptions wanted = instantiation_options(options, error);
    if (!error.empty()) {
        project.diagnostics.report(rules::bad_option, {}, {error});
        return false;
    }
    project.instantiation = ir::instantiate(project.system, wanted, project.diagnostics);
    return project.diagnostics.ok();
}

ir::ComponentRef component(ir::ComponentKind kind, std::size_t index, const std::string& package, const std::string& name) {
    ir::ComponentRef ref;
    ref.kind = kind;
    ref.definition = static_cast<std::uint32_t>(index);
    ref.package = package;
    ref.path = name;
    return ref;
}

std::vector<ir::ComponentRef> all_components(const ir::System& system) {
    std::vector<ir::ComponentRef> all;
    for (std::size_t i = 0; i < system.modules.size(); ++i)
        all.push_back(component(ir::ComponentKind::module, i, system.modules[i].package, system.modules[i].name));
    for (std::size_t i = 0; i < system.controllers.size(); ++i)
        all.push_back(component(ir::ComponentKind::controller, i, system.controllers[i].package, system.controllers[i].name));
    for (std::size_t i = 0; i < system.machines.size(); ++i) {
        const ir::Machine& machine = system.machines[i];
        if (machine.kind == ir::MachineKind::state_machine)
            all.push_back(component(ir::ComponentKind::machine, i, machine.package, machine.name));
    }
    return all;
}

}  // namespace

std::unique_ptr<Project> load(const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    auto project = std::make_unique<Project>();
    project->name = project_name(options.inputs.front());
    lower_all(*project, options);
    project->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return project;
}

namespace {

/// The part that these files are, under a name that no other part has.
std::unique_ptr<Project> part_of(const Project& whole, const frontend::Unit& unit, const Options& options, std::set<std::string>& names) {
    auto part = std::make_unique<Project>();
    std::vector<std::string> paths;
    for (const std::size_t file : unit.files) paths.push_back(whole.sources.path(whole.model->files[file]->source));
    const auto model = std::find_if(paths.begin(), paths.end(), [](const std::string& path) { return path.ends_with(".rct"); });
    const std::string name = project_name(unit.again ? paths.back() : model == paths.end() ? paths.front() : *model);
    part->name = name;
    for (int number = 2; !names.insert(part->name).second; ++number) part->name = fmt::format("{}_{}", name, number);
    for (const std::string& code : options.allowed) part->diagnostics.allow(code);
    part->model = frontend::load_files(part->sources, paths, part->diagnostics);
    lower_all(*part, options);
    return part;
}

}  // namespace

std::vector<Part> load_parts(const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    auto whole = std::make_unique<Project>();
    whole->name = project_name(options.inputs.front());
    for (const std::string& code : options.allowed) whole->diagnostics.allow(code);
    whole->model = frontend::load_project(whole->sources, options.inputs, whole->diagnostics);
    const std::vector<frontend::Unit> units = whole->diagnostics.ok() ? frontend::units(*whole->model) : std::vector<frontend::Unit>{};
    std::vector<Part> result;
    if (units.size() < 2) {
        lower_all(*whole, options);
        result.push_back({std::move(whole), false});
    } else {
        std::set<std::string> names;
        for (const frontend::Unit& unit : units) result.push_back({part_of(*whole, unit, options, names), unit.again});
    }
    result.front().project->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

csp_emit::Emission emit_csp(Project& project, const Options& options, csp_emit::Time time) {
    csp_emit::Options wanted;
    wanted.core_assertions = options.core;
    csp_emit::Emission emission =
        csp_emit::emit(project.system, project.instantiation, time, wanted, project.sources, project.diagnostics);
    if (!project.diagnostics.ok()) return emission;
    if (!emission.captured.empty())
        throw std::logic_error(fmt::format("the script takes {} for something of the model's", fmt::join(emission.captured, ", ")));
    // What is written or checked is held to FDR's rules of types. Where the user wrote none of it, a finding is a fault of ours.
    (void)cspm::check_types(emission.script, project.diagnostics);
    if (!project.diagnostics.ok() && project.system.csp_blocks.empty()) {
        diagnostics::TextStyle style;
        throw std::logic_error(fmt::format("the script does not type check:\n{}", diagnostics::render_text(project.sources, project.diagnostics, style)));
    }
    return emission;
}

std::vector<ir::ComponentRef> code_components(const ir::System& system, const std::string& wanted) {
    std::vector<ir::ComponentRef> chosen;
    for (const ir::ComponentRef& ref : all_components(system)) {
        const bool named = ref.path == wanted || ref.package + "::" + ref.path == wanted;
        if (wanted.empty() ? chosen.empty() || chosen.front().kind == ref.kind : named) chosen.push_back(ref);
    }
    return chosen;
}

std::string write_file(const std::string& path, const std::string& text) {
    std::error_code code;
    fs::create_directories(fs::path(path).parent_path(), code);
    if (code) return fmt::format("cannot create the folder of {}: {}", path, code.message());
    const std::string temporary = path + ".part";
    std::FILE* file = std::fopen(temporary.c_str(), "wb");
    if (file == nullptr) return fmt::format("cannot write {}: {}", path, std::strerror(errno));
    const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
    const bool closed = std::fclose(file) == 0;
    if (!written || !closed) {
        const std::string cause = std::strerror(errno);
        std::remove(temporary.c_str());
        return fmt::format("cannot write {}: {}", path, cause);
    }
    fs::rename(temporary, path, code);
    return code ? fmt::format("cannot write {}: {}", path, code.message()) : "";
}

bool acceptable(const Project& project, const Options& options) {
    return project.diagnostics.ok() && !(options.deny_warnings && project.diagnostics.warnings() > 0);
}

bool show_diagnostics(const Project& project, const Options& options) {
    const bool good = acceptable(project, options);
    if (options.format == Format::json) {
        if (!good) fmt::print("{}\n", diagnostics::render_json(project.sources, project.diagnostics));
    } else if (!options.quiet || !good) {
        diagnostics::TextStyle style;
        style.color = color_wanted(options.color, STDERR_FILENO);
        fmt::print(stderr, "{}", diagnostics::render_text(project.sources, project.diagnostics, style));
        if (!good && project.diagnostics.ok()) fmt::print(stderr, "warnings are denied (--deny-warnings)\n");
    }
    return good;
}

}  // namespace robochart::app
