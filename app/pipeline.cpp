#include "app/pipeline.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <stdexcept>

#include "app/output.hpp"
#include "app/rules.hpp"
#include "app/run.hpp"
#include "checker/cspm/types.hpp"
#include "diagnostics/render.hpp"
#include "frontend/names.hpp"
#include "frontend/project.hpp"
#include "semantics/lower.hpp"
#include "semantics/rules.hpp"

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
    const diagnostics::Budget::Phase phase(options.run->budget(), "reading the model");
    project.diagnostics.within(&options.run->budget());
    project.model = frontend::load_project(project.sources, options.inputs, project.diagnostics);
    if (!acceptable(project, options)) return false;
    project.system = ir::lower(*project.model, project.sources, project.diagnostics);
    if (!project.diagnostics.ok()) return false;
    std::string error;
    const ir::InstantiationOptions wanted = instantiation_options(options, error);
    if (!error.empty()) {
        project.diagnostics.report(rules::bad_option, {}, {error});
        return false;
    }
    const diagnostics::Budget::Phase instantiating(options.run->budget(), "making the model finite");
    project.instantiation = ir::instantiate(project.system, wanted, project.diagnostics);
    check_names(project, options);
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

csp_emit::Emission emit_csp(Project& project, const Options& options, csp_emit::Time time) {
    const diagnostics::Budget::Phase phase(options.run->budget(), "writing the CSP semantics");
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

void check_names(Project& project, const Options& options) {
    const auto unknown = [&](const char* option, const std::string& name, const char* what, std::vector<std::string> known) {
        const std::string meant = frontend::nearest(name, known);
        std::sort(known.begin(), known.end());
        known.erase(std::unique(known.begin(), known.end()), known.end());
        constexpr std::size_t few = 8;
        const std::string help = !meant.empty() ? fmt::format("; did you mean '{}'?", meant)
                                 : known.empty() ? "; it has none"
                                 : known.size() <= few ? fmt::format("; there are {}", fmt::join(known, ", ")) : "";
        project.diagnostics.report(rules::bad_option, {}, {fmt::format("{} {}: the model has no {} of this name{}", option, name, what, help)});
    };
    if (!options.component.empty() && code_components(project.system, options.component).empty()) {
        std::vector<std::string> known;
        for (const ir::ComponentRef& ref : all_components(project.system)) known.push_back(ref.path);
        unknown("--component", options.component, "module, controller or state machine", std::move(known));
    }
    if (options.assertion.empty()) return;
    std::vector<std::string> known;
    for (const ir::Property& property : project.system.properties) known.push_back(property.name);
    if (std::find(known.begin(), known.end(), options.assertion) == known.end())
        unknown("--assertion", options.assertion, "assertion", std::move(known));
}

Exit refusal(const Project& project) {
    const std::array about_options{&rules::bad_option,         &ir::rules::unknown_constant_option, &ir::rules::bad_constant_value,
                                   &ir::rules::unknown_range_option, &ir::rules::bad_range,         &ir::rules::ranges_not_nested,
                                   &ir::rules::range_too_large};
    const std::vector<diagnostics::Diagnostic> all = project.diagnostics.sorted();
    const auto about_the_model = [&](const diagnostics::Diagnostic& each) {
        return each.rule->severity == diagnostics::Severity::error &&
               std::find(about_options.begin(), about_options.end(), each.rule) == about_options.end();
    };
    return project.diagnostics.ok() || std::any_of(all.begin(), all.end(), about_the_model) ? Exit::bad_input : Exit::usage;
}

bool acceptable(const Project& project, const Options& options) {
    return project.diagnostics.ok() && !(options.deny_warnings && project.diagnostics.warnings() > 0);
}

bool show_diagnostics(const Project& project, const Options& options) {
    const bool good = acceptable(project, options);
    if (options.format == Format::json) {
        if (!good) print("{}\n", diagnostics::render_json(project.sources, project.diagnostics));
    } else if (!options.quiet || !good) {
        diagnostics::TextStyle style;
        style.color = color_wanted(options.color, STDERR_FILENO);
        print_error("{}", diagnostics::render_text(project.sources, project.diagnostics, style));
        if (!good && project.diagnostics.ok()) print_error("warnings are denied (--deny-warnings)\n");
    }
    return good;
}

}  // namespace robochart::app
