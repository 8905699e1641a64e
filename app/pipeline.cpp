#include "app/pipeline.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>

#include "app/output.hpp"
#include "app/rules.hpp"
#include "app/run.hpp"
#include "checker/cspm/types.hpp"
#include "diagnostics/files.hpp"
#include "diagnostics/render.hpp"
#include "frontend/names.hpp"
#include "frontend/project.hpp"
#include "frontend/syntax_rules.hpp"
#include "frontend/units.hpp"
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

/// What the phases of a project share: its budget, and the warnings that are not wanted.
void prepare(Project& project, const Options& options) {
    for (const std::string& code : options.allowed) project.diagnostics.allow(code);
    project.diagnostics.within(&options.run->budget());
}

bool lower(Project& project, const Options& options) {
    const diagnostics::Budget::Phase phase(options.run->budget(), "reading the model");
    if (!acceptable(project, options)) return false;
    project.system = ir::lower(*project.model, project.sources, project.diagnostics);
    return project.diagnostics.ok();
}

bool make_finite(Project& project, const Options& options) {
    std::string error;
    const ir::InstantiationOptions wanted = instantiation_options(options, error);
    if (!error.empty()) {
        project.diagnostics.report(rules::bad_option, {}, {error});
        return false;
    }
    const diagnostics::Budget::Phase phase(options.run->budget(), "making the model finite");
    project.instantiation = ir::instantiate(project.system, wanted, project.diagnostics);
    return project.diagnostics.ok();
}

std::unique_ptr<Project> read(const Options& options) {
    auto project = std::make_unique<Project>();
    project->name = project_name(options.inputs.front());
    prepare(*project, options);
    const diagnostics::Budget::Phase phase(options.run->budget(), "reading the model");
    project->model = frontend::load_project(project->sources, options.inputs, project->diagnostics);
    return project;
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

namespace {

using Time = std::chrono::steady_clock::time_point;

double seconds_since(Time start) { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); }

void check_names(const std::vector<Part>& parts, const Options& options);

void find_shared_names(const std::vector<Part>& parts) {
    std::map<std::pair<ir::ComponentKind, std::string>, std::string> packages;
    std::set<std::string> shared;
    for (const Part& part : parts)
        for (const ir::ComponentRef& ref : all_components(part.project->system))
            if (packages.try_emplace({ref.kind, ref.path}, ref.package).first->second != ref.package) shared.insert(ref.path);
    for (const Part& part : parts) part.project->shared_names = shared;
}

/// One project as its only part.
std::vector<Part> single(std::unique_ptr<Project> project, const Options& options) {
    std::vector<Part> parts;
    parts.push_back({std::move(project), false});
    Project& only = *parts.front().project;
    if (lower(only, options) && make_finite(only, options)) check_names(parts, options);
    find_shared_names(parts);
    return parts;
}

/// The part that these files are, under a name that no other part has.
std::unique_ptr<Project> part_of(const Project& whole, const frontend::Unit& unit, const Options& options, std::set<std::string>& names) {
    auto part = std::make_unique<Project>();
    std::vector<std::string> paths;
    for (const std::size_t file : unit.files) paths.push_back(whole.sources.path(whole.model->files[file]->source));
    const auto model = std::find_if(paths.begin(), paths.end(), [](const std::string& path) { return path.ends_with(".rct"); });
    const std::string name = project_name(unit.again ? paths.back() : model == paths.end() ? paths.front() : *model);
    part->name = name;
    for (int number = 2; !names.insert(part->name).second; ++number) part->name = fmt::format("{}_{}", name, number);
    prepare(*part, options);
    part->model = frontend::load_files(part->sources, paths, part->diagnostics);
    return part;
}

/// The options for a part: constants of other parts are not its own. What no part has is left to the first, which says so.
Options options_for(const std::vector<Part>& parts, std::size_t part, const Options& options) {
    Options result = options;
    std::erase_if(result.constants, [&](const std::string& text) {
        const std::string name = text.substr(0, text.find('='));
        const auto has = [&](const Part& each) { return ir::names_constant(each.project->system, name); };
        return !has(parts[part]) && (part > 0 || std::any_of(parts.begin(), parts.end(), has));
    });
    return result;
}

}  // namespace

std::unique_ptr<Project> load(const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<Part> parts = single(read(options), options);
    parts.front().project->seconds = seconds_since(start);
    return std::move(parts.front().project);
}

std::vector<Part> load_parts(const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    std::unique_ptr<Project> whole = read(options);
    const std::vector<frontend::Unit> units = whole->diagnostics.ok() ? frontend::units(*whole->model) : std::vector<frontend::Unit>{};
    std::vector<Part> parts;
    if (units.size() < 2) {
        parts = single(std::move(whole), options);
    } else {
        std::set<std::string> names;
        for (const frontend::Unit& unit : units) parts.push_back({part_of(*whole, unit, options, names), unit.again});
        bool good = true;
        for (const Part& part : parts) good = lower(*part.project, options) && good;
        for (std::size_t i = 0; good && i < parts.size(); ++i) good = make_finite(*parts[i].project, options_for(parts, i, options));
        if (good) check_names(parts, options);
        find_shared_names(parts);
    }
    parts.front().project->seconds = seconds_since(start);
    return parts;
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
    // What is written or checked is held to FDR's rules of types. Where the user wrote none of it, a finding is an internal error.
    (void)cspm::check_types(emission.script, project.diagnostics);
    if (!project.diagnostics.ok() && project.system.csp_blocks.empty()) {
        diagnostics::TextStyle style;
        throw std::logic_error(fmt::format("the script does not type check:\n{}", diagnostics::render_text(project.sources, project.diagnostics, style)));
    }
    return emission;
}

std::string file_name(const Project& project, const ir::ComponentRef& component) {
    const bool shared = project.shared_names.contains(component.path) && !component.package.empty();
    std::string name = shared ? component.package + "_" + component.path : component.path;
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    return name;
}

bool write_output(Project& project, const Options& options, const std::string& path, const std::string& text) {
    const std::string error = options.run->claim(path) ? diagnostics::write_below(options.out, path, text, project.diagnostics.budget())
                                                       : fmt::format("{}/{}: this run has already written a file of this name, "
                                                                     "for something else of the same name", options.out, path);
    if (!error.empty()) project.diagnostics.report(rules::unwritable, {}, {error});
    return error.empty();
}

std::vector<ir::ComponentRef> code_components(const ir::System& system, const std::string& wanted) {
    std::vector<ir::ComponentRef> chosen;
    for (const ir::ComponentRef& ref : all_components(system)) {
        const bool named = ref.path == wanted || ref.package + "::" + ref.path == wanted;
        if (wanted.empty() ? chosen.empty() || chosen.front().kind == ref.kind : named) chosen.push_back(ref);
    }
    return chosen;
}

namespace {

/// What the options name exists in some part; else the first part says so.
void check_names(const std::vector<Part>& parts, const Options& options) {
    const auto unknown = [&](const char* option, const std::string& name, const char* what, std::vector<std::string> known) {
        const std::string meant = frontend::nearest(name, known);
        std::sort(known.begin(), known.end());
        known.erase(std::unique(known.begin(), known.end()), known.end());
        constexpr std::size_t few = 8;
        const std::string help = !meant.empty() ? fmt::format("; did you mean '{}'?", meant)
                                 : known.empty() ? "; it has none"
                                 : known.size() <= few ? fmt::format("; there are {}", fmt::join(known, ", ")) : "";
        parts.front().project->diagnostics.report(rules::bad_option, {},
                                                  {fmt::format("{} {}: the model has no {} of this name{}", option, name, what, help)});
    };
    std::vector<std::string> components, assertions;
    bool found = options.component.empty();
    for (const Part& part : parts) {
        const ir::System& system = part.project->system;
        found = found || !code_components(system, options.component).empty();
        for (const ir::ComponentRef& ref : all_components(system)) components.push_back(ref.path);
        for (const ir::Property& property : system.properties) assertions.push_back(property.name);
        for (const diagnostics::Diagnostic& finding : part.project->diagnostics.sorted())
            if (finding.rule == &frontend::syntax::foreign_assertion) assertions.push_back(finding.arguments.front());
    }
    if (!found) unknown("--component", options.component, "module, controller or state machine", std::move(components));
    if (!options.assertion.empty() && std::find(assertions.begin(), assertions.end(), options.assertion) == assertions.end())
        unknown("--assertion", options.assertion, "assertion", std::move(assertions));
}

}  // namespace

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
        if (!good) print_exact(diagnostics::render_json(project.sources, project.diagnostics) + "\n");
    } else if (!options.quiet || !good) {
        diagnostics::TextStyle style;
        style.color = color_wanted(options.color, STDERR_FILENO);
        print_error_styled(diagnostics::render_text(project.sources, project.diagnostics, style));
        if (!good && project.diagnostics.ok()) print_error("warnings are denied (--deny-warnings)\n");
    }
    return good;
}

}  // namespace robochart::app
