// The verbs over models: read, then check, write and conform as asked, one report.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>

#include "app/interrupt.hpp"
#include "app/rules.hpp"
#include "app/verbs.hpp"
#include "checker/cspm/reader.hpp"
#include "cpp_emit/emit.hpp"
#include "frontend/project.hpp"
#include "semantics/lower.hpp"

namespace robochart::app {
namespace {

std::string count(std::size_t n, std::string_view what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); }

std::string summary(const std::vector<Part>& parts) {
    std::size_t modules = 0, controllers = 0, machines = 0, operations = 0, assertions = 0;
    for (const Part& part : parts) {
        const ir::System& system = part.project->system;
        assertions += system.properties.size();
        if (part.again) continue;
        modules += system.modules.size();
        controllers += system.controllers.size();
        for (const ir::Machine& machine : system.machines)
            ++(machine.kind == ir::MachineKind::operation ? operations : machines);
    }
    return fmt::format("{}, {}, {}, {}, {}", count(modules, "module"), count(controllers, "controller"), count(machines, "state machine"),
                       count(operations, "operation"), count(assertions, "assertion"));
}

std::string range(const std::vector<std::int64_t>& carrier) {
    return carrier.empty() ? "empty" : fmt::format("{}..{}", carrier.front(), carrier.back());
}

std::vector<std::string> notes(const ir::Instantiation& i) {
    std::vector<std::string> result;
    std::string reals = fmt::format("{} values", i.real.size());
    if (i.scale != 1) reals += fmt::format(", exact in steps of 1/{} (from the model's decimal literals)", i.scale);
    result.push_back(fmt::format("finite reading: nat {}, int {}, real {}, clocks 0..{}", range(i.nat), range(i.integer), reals, i.clock_bound));
    const ir::Instantiation usual;
    if (i.sequence_bound != usual.sequence_bound) result.back() += fmt::format(", sequences of at most {}", i.sequence_bound);
    if (i.given_size != usual.given_size) result.back() += fmt::format(", given types of {}", i.given_size);
    return result;
}

/// The finite reading, once where all parts have the same.
std::vector<std::string> notes(const std::vector<Part>& parts) {
    std::vector<std::string> result;
    const bool same = std::all_of(parts.begin(), parts.end(), [&](const Part& part) {
        return notes(part.project->instantiation) == notes(parts.front().project->instantiation);
    });
    for (const Part& part : parts) {
        for (const std::string& note : notes(part.project->instantiation)) result.push_back(same ? note : fmt::format("{}: {}", part.project->name, note));
        if (same) break;
    }
    return result;
}

bool write_all(const std::string& folder, const auto& files, std::vector<FileReport>& report, diagnostics::Diagnostics& diagnostics) {
    for (const auto& file : files) {
        const std::string path = folder + "/" + file.path;
        if constexpr (requires { file.keep; })
            if (file.keep && std::filesystem::exists(path)) continue;
        const std::string error = write_file(path, file.text);
        if (!error.empty()) {
            diagnostics.report(rules::unwritable, {}, {error});
            return false;
        }
        report.push_back({path, file.text.size()});
    }
    return true;
}

/// The normal form as a script for FDR: it includes the timed semantics that the other files hold.
bool write_normal_form(Project& project, const Options& options, const ir::ComponentRef& component, const std::string& text, Report& report) {
    struct Script {
        std::string path, text;
    };
    const Script script{fmt::format("csp-gen/timed/{}_normal_form.csp", component.path),
                        fmt::format("include \"{}.csp\"\n\n{}", project.name, text)};
    return write_all(options.out, std::vector<Script>{script}, report.csp_files, project.diagnostics);
}

/// .aut, .dot or .csp.
conformance::Export export_format(const std::string& path) {
    using conformance::Export;
    const auto dot = path.rfind('.');
    const std::string ending = dot == std::string::npos ? "" : path.substr(dot);
    if (ending == ".aut") return Export::aut;
    if (ending == ".dot") return Export::dot;
    return ending == ".csp" ? Export::csp : Export::none;
}

/// All states of the code, where they are known.
bool write_code_graph(Project& project, const Options& options, conformance::Result& result, Report& report) {
    std::string error = result.exported.empty() ? fmt::format("--export {}: nothing is written, {}", options.exported_code,
                                                              result.export_failure.empty() ? "there is no code" : result.export_failure)
                                                : write_file(options.exported_code, result.exported);
    if (error.empty()) {
        report.csp_files.push_back({options.exported_code, result.exported.size()});
        return true;
    }
    project.diagnostics.report(rules::unwritable, {}, {std::move(error)});
    return false;
}

/// What --export asks for can be had, of one component.
bool export_fits(Project& project, const Options& options, std::size_t components) {
    if (options.exported_code.empty()) return true;
    const bool named = export_format(options.exported_code) != conformance::Export::none;
    if (named && components == 1) return true;
    project.diagnostics.report(rules::bad_option, {},
                               {fmt::format("--export {}: {}", options.exported_code,
                                            named ? "there are several components, name one with --component" : "the file's name ends in .aut, .dot or .csp")});
    return false;
}

std::string qualified(const ir::ComponentRef& ref) { return ref.package.empty() ? ref.path : ref.package + "::" + ref.path; }

/// Where the files of a component go: "cpp/C", of a project "ros2/C".
std::string cpp_folder(const Options& options, const ir::ComponentRef& component) {
    return fmt::format("{}/{}/{}", options.out, options.target.empty() ? "cpp" : options.target, component.path);
}

cpp_emit::Target target_of(const std::string& name) {
    using cpp_emit::Target;
    static const std::map<std::string, Target> targets{
        {"", Target::sources}, {"library", Target::library}, {"main", Target::main}, {"ros2", Target::ros2}, {"enki", Target::enki}, {"argos", Target::argos}};
    return targets.at(name);
}

cpp_emit::Strategy strategy_of(const std::string& name) {
    return name == "switch" ? cpp_emit::Strategy::nested_switch : name == "table" ? cpp_emit::Strategy::table : cpp_emit::Strategy::automatic;
}

Report begin(const Project& project, const Options& options) {
    Report report;
    report.model = fmt::format("{}", fmt::join(options.inputs, " "));
    report.load_seconds = project.seconds;
    return report;
}

/// `again`: code and conformance of its components are those of a part before it.
bool run_phases(Project& project, const Options& options, bool again, Report& report) {
    const bool all = options.verb == Verb::verify;
    if (all || options.verb == Verb::check) check_assertions(project, options, report);
    if ((all || options.verb == Verb::emit_csp) && !write_csp(project, options, report)) return false;
    if (again) return project.diagnostics.ok();
    if ((all || options.verb == Verb::emit_cpp) && !write_cpp(project, options, report)) return false;
    if (all || options.verb == Verb::conform) check_conformance(project, options, report);
    return project.diagnostics.ok();
}

}  // namespace

bool write_csp(Project& project, const Options& options, Report& report) {
    for (const auto time : {csp_emit::Time::untimed, csp_emit::Time::timed}) {
        const bool skipped = (options.times == Times::timed && time == csp_emit::Time::untimed) ||
                             (options.times == Times::untimed && time == csp_emit::Time::timed);
        if (skipped) continue;
        const csp_emit::Emission emission = emit_csp(project, options, time);
        if (!project.diagnostics.ok()) return false;
        if (!write_all(options.out, csp_emit::files(emission, time, project.name), report.csp_files, project.diagnostics)) return false;
    }
    return true;
}

bool write_cpp(Project& project, const Options& options, Report& report) {
    const auto components = code_components(project.system, options.component);
    if (components.empty()) {
        project.diagnostics.report(rules::no_component, {}, {options.component.empty() ? "the model" : options.component});
        return false;
    }
    cpp_emit::Options generator;
    generator.cycle_length = options.cycle;
    generator.sources = &project.sources;
    generator.target = target_of(options.target);
    generator.strategy = strategy_of(options.strategy);
    generator.choices = options.choices;
    generator.explored = false;
    for (const ir::ComponentRef& component : components) {
        const cpp_emit::Emission emission = cpp_emit::emit(project.system, project.instantiation, component, generator, project.diagnostics);
        if (!project.diagnostics.ok()) return false;
        if (!write_all(cpp_folder(options, component), emission.files, report.cpp_files, project.diagnostics)) return false;
    }
    return true;
}

void check_conformance(Project& project, const Options& options, Report& report) {
    const auto components = code_components(project.system, options.component);
    if (components.empty()) project.diagnostics.report(rules::no_component, {}, {options.component.empty() ? "the model" : options.component});
    if (!export_fits(project, options, components.size())) return;
    for (const ir::ComponentRef& component : components) {
        const auto start = std::chrono::steady_clock::now();
        conformance::Options wanted;
        wanted.cycle_length = options.cycle;
        wanted.limits = limits(options);
        wanted.generator.choices = options.choices;
        if (options.relation == "tick-tock") wanted.relation = conformance::Relation::tick_tock;
        wanted.walks.cycles = options.walks;
        wanted.exported = export_format(options.exported_code);
        ConformanceReport one;
        one.component = qualified(component);
        const InterruptScope scope;
        one.result = conformance::conform(project.system, project.instantiation, component, wanted, project.sources, project.diagnostics);
        one.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const bool exported = options.verb == Verb::verify && !one.result.normal_form.empty() && options.times != Times::untimed;
        if (exported && !write_normal_form(project, options, component, one.result.normal_form, report)) return;
        if (!options.exported_code.empty() && !write_code_graph(project, options, one.result, report)) return;
        report.conformance.push_back(std::move(one));
    }
}

Exit print_phase(Project& project, const Options& options) {
    if (options.print == "ast" || options.print == "model") {
        fmt::print("{}", frontend::dump(*project.model, project.sources, options.print == "model"));
        return acceptable(project, options) ? Exit::success : Exit::bad_input;
    }
    if (!acceptable(project, options)) return Exit::bad_input;
    if (options.print == "ir") {
        fmt::print("{}", ir::dump(project.system));
        return Exit::success;
    }
    const auto time = options.print == "script" ? csp_emit::Time::untimed : csp_emit::Time::timed;
    const csp_emit::Emission emission = emit_csp(project, options, time);
    if (!show_diagnostics(project, options)) return Exit::bad_input;
    fmt::print("{}", cspm::print(emission.script));
    return Exit::success;
}

namespace {

/// The components of a part; the component asked for, if one is, must be in one of the parts.
bool has_wanted(const Project& project, const Options& options) {
    return options.component.empty() || !code_components(project.system, options.component).empty();
}

/// A verb whose answer is a report, over all parts of the project.
Exit run_parts(std::vector<Part>& parts, const Options& options) {
    const bool some = std::any_of(parts.begin(), parts.end(), [&](const Part& part) { return has_wanted(*part.project, options); });
    Report report = begin(*parts.front().project, options);
    report.summary = summary(parts);
    report.notes = notes(parts);
    bool good = true, accepted = true;
    for (Part& part : parts) {
        if (some && !has_wanted(*part.project, options)) continue;
        Options wanted = options;
        if (part.again) wanted.core = false;
        good = good && run_phases(*part.project, wanted, part.again, report);
        accepted = show_diagnostics(*part.project, options) && accepted;
        if (!good) break;
    }
    const bool json = options.format == Format::json;
    if (!good || (json && !accepted)) return Exit::bad_input;
    fmt::print("{}", json ? render_json(report) : render_text(report, options));
    return accepted ? report.exit() : Exit::bad_input;
}

}  // namespace

Exit run_model(const Options& options) {
    const bool whole = !options.print.empty() || options.verb == Verb::emit_monitor || options.verb == Verb::emit_tests || !options.traces.empty();
    if (!whole) {
        std::vector<Part> parts = load_parts(options);
        for (const Part& part : parts)
            if (!acceptable(*part.project, options)) {
                show_diagnostics(*part.project, options);
                return Exit::bad_input;
            }
        return run_parts(parts, options);
    }
    const auto project = load(options);
    if (!options.print.empty()) {
        show_diagnostics(*project, options);
        return print_phase(*project, options);
    }
    if (!acceptable(*project, options)) {
        show_diagnostics(*project, options);
        return Exit::bad_input;
    }
    if (options.verb == Verb::emit_monitor) return emit_monitors(*project, options);
    if (options.verb == Verb::emit_tests) return emit_tests(*project, options);
    return conform_traces(*project, options);
}

}  // namespace robochart::app
