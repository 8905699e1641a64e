// SPDX-License-Identifier: Apache-2.0
// The verbs about models: verify, check, emit and conform. A run reads the models and then checks, writes files and
// tests conformance as the verb requires, with one report.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <map>
#include <optional>

#include "app/claims/event_order.hpp"
#include "app/command/answer.hpp"
#include "app/command/findings.hpp"
#include "app/command/output.hpp"
#include "app/command/recording.hpp"
#include "app/command/rules.hpp"
#include "app/command/run.hpp"
#include "app/pages/html.hpp"
#include "app/verbs/verbs.hpp"
#include "app/verbs/write_files.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/files.hpp"
#include "base/diagnostics/render.hpp"
#include "base/diagnostics/spelling.hpp"
#include "checker/certify/certificate.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "conformance/check/cycle_claims.hpp"
#include "conformance/model/rules.hpp"
#include "cpp_emit/emit.hpp"
#include "cpp_emit/ros2/read_mapping.hpp"
#include "cpp_emit/ros2/rules.hpp"
#include "driver/claims/certificates.hpp"
#include "driver/claims/class_project.hpp"
#include "driver/claims/model_claims.hpp"
#include "driver/model/block_values.hpp"
#include "driver/model/broken_claims.hpp"
#include "driver/model/claim_files.hpp"
#include "driver/model/instantiated_claims.hpp"
#include "driver/model/places.hpp"
#include "driver/model/preferences.hpp"
#include "driver/model/project_claims.hpp"
#include "driver/settings/instantiation_options.hpp"
#include "driver/settings/rules.hpp"
#include "frontend/project/project.hpp"
#include "frontend/syntax/syntax_rules.hpp"
#include "prism/emit/emit.hpp"
#include "prism/emit/preferences.hpp"
#include "prism/emit/rules.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/ir/dump.hpp"
#include "semantics/ir/query.hpp"
#include "semantics/lower/lower.hpp"
#include "semantics/rules.hpp"

namespace robochart::app {
namespace {

std::string plural_text(std::size_t n, std::string_view what) {
    return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

std::string summary_text(const std::vector<driver::Part>& parts) {
    std::size_t modules = 0, controllers = 0, machines = 0, operations = 0, assertions = 0, claims = 0;
    for (const driver::Part& part : parts) {
        const ir::System& system = part.project->system;
        assertions += system.properties.size();
        claims += part.project->claims->checked.claims.size();
        for (const driver::InstantiatedClaims& own : part.project->claims->instantiated)
            assertions += own.project->system.properties.size();
        if (part.again) continue;
        modules += system.modules.size();
        controllers += system.controllers.size();
        for (const ir::Machine& machine : system.machines)
            ++(machine.kind == ir::MachineKind::operation ? operations : machines);
    }
    std::string result = fmt::format("{}, {}, {}, {}, {}", plural_text(modules, "module"),
                                     plural_text(controllers, "controller"), plural_text(machines, "state machine"),
                                     plural_text(operations, "operation"), plural_text(assertions, "assertion"));
    if (claims > 0) result += fmt::format(", {}", plural_text(claims, "claim"));
    return result;
}

std::vector<std::string> instantiation_notes(const ir::Instantiation& i) {
    std::vector<std::string> result;
    std::string reals = fmt::format("{} values", i.real.size());
    if (i.scale != 1) reals += fmt::format(", exact in steps of 1/{} (from the model's decimal literals)", i.scale);
    result.push_back(fmt::format("finite instantiation: nat {}, int {}, real {}, clocks 0..{}",
                                 driver::range_text(i.nat), driver::range_text(i.integer), reals, i.clock_bound));
    const ir::Instantiation usual;
    if (i.sequence_bound != usual.sequence_bound)
        result.back() += fmt::format(", sequences of at most {}", i.sequence_bound);
    if (i.given_size != usual.given_size) result.back() += fmt::format(", given types of {}", i.given_size);
    return result;
}

/// Returns notes about the finite instantiation. A note that all parts share is printed once.
std::vector<std::string> instantiation_notes(const std::vector<driver::Part>& parts) {
    std::vector<const driver::Project*> finite;
    for (const driver::Part& part : parts)
        if (part.project->diagnostics.ok()) finite.push_back(part.project.get());
    std::vector<std::string> result;
    const bool same = std::ranges::all_of(finite, [&](const driver::Project* project) {
        return instantiation_notes(project->instantiation) == instantiation_notes(finite.front()->instantiation);
    });
    for (const driver::Project* project : finite) {
        for (const std::string& note : instantiation_notes(project->instantiation))
            result.push_back(same ? note : fmt::format("{}: {}", project->name, note));
        if (same) break;
    }
    for (const driver::Project* project : finite)
        if (std::ranges::any_of(project->system.csp_blocks, ir::is_instantiations))
            result.push_back(fmt::format(
                "{}the csp block Instantiations replaces that in the scripts, `--range` and `--const` change nothing "
                "there; generated C++ and its comparison do not read it",
                project->label));
    return result;
}

/// Writes the normal form as a script for FDR, which includes the timed semantics of the other files.
bool write_normal_form(driver::Project& project, const Options& options, const ir::ComponentRef& component,
                       const std::string& text, Report& report) {
    struct Script {
        std::string path, text;
    };
    const Script script{fmt::format("csp-gen/timed/{}{}_normal_form.csp",
                                    project.label.empty() ? "" : project.name + "_", file_name(project, component)),
                        fmt::format("include \"{}.csp\"\n\n{}", project.name, text)};
    return write_all("", std::vector<Script>{script}, report.csp_files, options, project);
}

/// Returns the format for the extension .aut, .dot or .csp.
conformance::Export export_format(const std::string& path) {
    using conformance::Export;
    const auto dot = path.rfind('.');
    const std::string ending = dot == std::string::npos ? "" : path.substr(dot);
    if (ending == ".aut") return Export::aut;
    if (ending == ".dot") return Export::dot;
    return ending == ".csp" ? Export::csp : Export::none;
}

/// Writes all states of the code, if all were explored.
bool write_code_graph(driver::Project& project, const Options& options, conformance::Result& result, Report& report) {
    std::string error;
    if (result.exported.empty())
        error = fmt::format("--export {}: nothing is written, {}", options.conform.exported_code,
                            result.export_failure.empty() ? "there is no code" : result.export_failure);
    else
        error = diagnostics::replace_file(options.conform.exported_code, result.exported, project.diagnostics.budget());
    if (error.empty()) {
        const auto edit = options.run->edit();
        report.csp_files.push_back({options.conform.exported_code, result.exported.size()});
        return true;
    }
    project.diagnostics.report(rules::unwritable, {}, {std::move(error)});
    return false;
}

/// True if --export is not given, or if the extension of its file is known and there is exactly one component.
bool export_fits(driver::Project& project, const Options& options, std::size_t components) {
    if (options.conform.exported_code.empty()) return true;
    const bool named = export_format(options.conform.exported_code) != conformance::Export::none;
    if (named && components == 1) return true;
    project.diagnostics.report(driver::rules::bad_option, {},
                               {fmt::format("--export {}: {}", options.conform.exported_code,
                                            named ? "there are several components, name one with --component"
                                                  : "the file's name ends in .aut, .dot or .csp")});
    return false;
}

/// Returns the folder for the files of a component: "cpp/C/", or "ros2/C/" for a project.
std::string cpp_folder(const driver::Project& project, const Options& options, const ir::ComponentRef& component) {
    constexpr std::array<const char*, 7> folders{"cpp", "library", "main", "ros2", "enki", "argos", "python"};
    return fmt::format("{}/{}{}/", folders[static_cast<std::size_t>(options.code.target)], project.folder,
                       file_name(project, component));
}

/// Returns the path of the first text that is not a library; "" if there is none.
std::string first_file(const driver::Part& part) {
    if (!part.project->model) return "";
    const auto& files = part.project->model->files;
    const auto file = std::ranges::find_if(files, [](const auto& model_file) { return !model_file->is_library; });
    return file == files.end() ? "" : part.project->sources.path((*file)->source);
}

/// Fills in the head of the report. If all parts are rejected, it contains only the model's name, because the parts may
/// not have been lowered.
void begin(const std::vector<driver::Part>& parts, const Options& options, Report& report) {
    const auto edit = options.run->edit();
    const auto accepted = [](const driver::Part& part) { return part.project->diagnostics.ok(); };
    if (std::ranges::any_of(parts, accepted)) report.summary = summary_text(parts);
    report.file = first_file(parts.front());
    report.load_seconds = parts.front().project->seconds;
    if (options.probability.preferences.empty())
        report.notes = instantiation_notes(parts);  // ranges in the preferences file replace the instantiation
}

/// Prints the report so far.
Exit print_report(const Report& report, const Options& options) {
    output_document(options, [&](Format format) {
        if (format == Format::json) return render_json(report);
        if (format != Format::sarif) return render_junit(report);
        return render_sarif(report, options.verb == Verb::verify ? "verify" : "check");
    });
    if (options.output.format == Format::text)
        print_styled(wrap_lines(render_text(report, options), line_width(STDOUT_FILENO)));
    return report.exit_code();
}

/// Runs the phases of the verb for one part. `code` is true if code must be generated for the part's components. It is
/// false if an earlier part has the same components.
bool run_phases(driver::Project& project, const Options& options, bool code, Report& report) {
    const bool all = options.verb == Verb::verify;
    if (all || options.verb == Verb::check) check_assertions(project, search_context(options), report);
    if ((all || options.verb == Verb::emit_csp) && !write_csp(project, options, report)) return false;
    record_block_values(project, options);
    if (!code) return project.diagnostics.ok();
    if ((all || options.verb == Verb::emit_cpp) && !write_cpp(project, options, report)) return false;
    if (all || options.verb == Verb::conform) check_conformance(project, options, report);
    if (options.verb == Verb::emit_prism && !write_prism(project, options, report)) return false;
    if (options.verb == Verb::emit_monitor && !write_monitors(project, options, report)) return false;
    if (options.verb == Verb::emit_tests && !write_tests(project, options, report)) return false;
    if (options.verb == Verb::emit_rst && !write_robosim(project, options, report)) return false;
    return project.diagnostics.ok();
}

}  // namespace

namespace {

/// Whether the model has components, and all of them are of RoboSim.
bool is_robosim_only(const ir::System& system) {
    const std::size_t all = system.machines.size() + system.controllers.size() + system.modules.size();
    return all > 0 && ir::robosim_components(system).size() == all;
}

/// RoboSim has only a timed semantics. Reports a request for the untimed script of a model without RoboChart
/// components.
bool allows_untimed(driver::Project& project, const std::string& option, const std::string& remedy) {
    if (!is_robosim_only(project.system)) return true;
    project.diagnostics.report(ir::rules::robosim_unsupported, model_place(project),
                               {option, "its semantics is timed; " + remedy});
    return false;
}

/// Writes the scripts of a project under this name. `notes` describe the classes of values in the project, if it has
/// any; the scripts contain them as comments.
bool write_scripts(driver::Project& project, const std::string& name, const std::vector<std::string>& notes,
                   const Options& options, Report& report) {
    for (const auto time : {csp_emit::Time::untimed, csp_emit::Time::timed}) {
        if (!includes_time(options.claims.times, time)) continue;
        const bool empty = time == csp_emit::Time::untimed && is_robosim_only(project.system);
        if (empty && options.claims.times == driver::Times::both) continue;
        const csp_emit::Emission& emission = emit_csp(project, options.claims, options.swarm, time);
        if (!project.diagnostics.ok() ||
            !write_all("", csp_emit::files(emission, time, name, notes), report.csp_files, options, project))
            return false;
    }
    return true;
}

}  // namespace

bool write_csp(driver::Project& project, const Options& options, Report& report) {
    const bool only_untimed = options.verb == Verb::emit_csp && options.claims.times == driver::Times::untimed;
    if (only_untimed && !allows_untimed(project, "`--untimed`", "leave out `--untimed`")) return false;
    const auto other = driver::with_carriers_of_robotool(project);
    driver::Project& exported = other ? *other : project;
    bool written = write_scripts(exported, options.swarm.file.empty() ? project.name : project.name + "_swarm", {},
                                 options, report);
    const driver::ClassProject classes = driver::class_project(project, options);
    if (written && classes.project) {
        written = write_scripts(*classes.project, project.name + "_classes",
                                ir::describe_classes(classes.project->system), options, report);
        if (!classes.project->diagnostics.ok()) project.diagnostics.add(classes.project->diagnostics);
    }
    // A check has already reported the findings of the script.
    if (other && options.verb == Verb::emit_csp) project.diagnostics.add(exported.diagnostics);
    return written;
}

namespace {

/// Reads the mapping of --mapping. If it cannot be read, reports findings and returns no value.
std::optional<cpp_emit::ros2::Mapping> read_mapping(driver::Project& project, const Options& options) {
    std::string error;
    const auto source = project.sources.load_file(options.code.mapping, error);
    if (source) {
        auto mapping = cpp_emit::ros2::read_mapping(project.sources, *source, project.diagnostics);
        if (!project.diagnostics.has_errors_in(*source)) return mapping;
    } else {
        project.diagnostics.report(frontend::syntax::unreadable, {}, {options.code.mapping, error});
    }
    return std::nullopt;
}

/// Returns the component of the mapping, which is the only component to write. If it does not exist, reports a finding
/// and returns an empty list.
std::vector<ir::ComponentRef> mapped_component(driver::Project& project,
                                               const std::vector<ir::ComponentRef>& components,
                                               const cpp_emit::ros2::Mapping& mapping) {
    const auto& [name, span] = mapping.component;
    std::vector<std::string> known;
    for (const ir::ComponentRef& component : components) {
        if (component.path == name || ir::qualified_name(component) == name) return {component};
        known.push_back(component.path);
    }
    const std::string meant = diagnostics::nearest_spelling(name, known);
    const std::string help = meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant);
    project.diagnostics.report(cpp_emit::ros2::rules::unknown_name, span,
                               {"the model", "component that code is made of", name, help});
    return {};
}

/// Throws UsageError if a capacity is given for a name that no component has.
void check_capacities(const Options& options, const std::vector<cpp_emit::Emission>& emissions) {
    for (const auto& given : options.code.capacities) {
        const auto is_sized = [&](const cpp_emit::Emission& emission) {
            return std::ranges::find(emission.sized_names, given.first) != emission.sized_names.end();
        };
        if (std::ranges::none_of(emissions, is_sized))
            throw UsageError(fmt::format("--capacity {0}={1}: no event or variable '{0}' has lists",
                                         diagnostics::escape_for_display(given.first), given.second));
    }
}

/// Throws UsageError if --strategy is given for a RoboSim component. It chooses the code that finds the reaction to one
/// event (`dispatch`), and the code of such a component reads all its inputs at once.
void check_strategy(const driver::Project& project, const std::vector<ir::ComponentRef>& components,
                    const Options& options) {
    if (options.code.strategy == cpp_emit::Strategy::automatic) return;
    for (const ir::ComponentRef& component : components)
        if (ir::is_robosim(project.system, component))
            throw UsageError(
                fmt::format("--strategy is about code that reacts to one event, and {} is written in RoboSim: its code "
                            "reads all inputs of a cycle at once; leave out --strategy, or select a component of "
                            "RoboChart with --component",
                            ir::qualified_name(component)));
}

/// Replaces the `cycleDef` of RoboSim components by the value of --cycle.
void set_cycles(driver::Project& project, const std::vector<ir::ComponentRef>& components, const Options& options) {
    if (!options.code.cycle_given) return;
    for (const ir::ComponentRef& component : components)
        if (ir::is_robosim(project.system, component))
            project.instantiation.constants[ir::constant_name(component.package, component.path, ir::cycle_length)] = {
                static_cast<std::int64_t>(options.code.cycle), {}};
}

}  // namespace

std::uint32_t control_cycle(const driver::Project& project, const ir::ComponentRef& component, const Options& options) {
    if (options.code.cycle_given || !ir::is_robosim(project.system, component)) return options.code.cycle;
    return static_cast<std::uint32_t>(ir::cycle_of(project.system, project.instantiation, component));
}

bool write_cpp(driver::Project& project, const Options& options, Report& report) {
    auto components = driver::code_components(project.system, options.load.component, options.load.robosim);
    if (components.empty()) {
        project.diagnostics.report(rules::no_component, model_place(project),
                                   {options.load.component.empty() ? "the model" : options.load.component});
        return false;
    }
    check_strategy(project, components, options);
    set_cycles(project, components, options);
    cpp_emit::Options generator;
    generator.cycle_length = options.code.cycle;
    generator.unit = project.unit;
    generator.sources = &project.sources;
    generator.target = options.code.target;
    generator.strategy = options.code.strategy;
    generator.choices = options.code.choices;
    generator.explored = false;
    generator.capacities = options.code.capacities;
    generator.package = options.code.package;
    generator.model_names = options.code.model_names;
    generator.dispatch = options.code.dispatch;
    generator.mapping_draft = options.code.mapping_draft;
    std::optional<cpp_emit::ros2::Mapping> mapping;
    if (!options.code.mapping.empty()) {
        mapping = read_mapping(project, options);
        if (!mapping) return false;
        components = mapped_component(project, components, *mapping);
        if (components.empty()) return false;
        generator.mapping = &*mapping;
    }
    std::vector<cpp_emit::Emission> emissions;
    for (const ir::ComponentRef& component : components) {
        generator.order = event_order(project, component);
        emissions.push_back(
            cpp_emit::emit(project.system, project.instantiation, component, generator, project.diagnostics));
        if (!project.diagnostics.ok()) return false;
    }
    check_capacities(options, emissions);
    for (std::size_t i = 0; i < components.size(); ++i)
        if (!write_all(cpp_folder(project, options, components[i]), emissions[i].files, report.cpp_files, options,
                       project))
            return false;
    return true;
}

namespace {

/// Returns the component as a module; null if it is not a module.
const ir::Module* module_of(const ir::System& system, const ir::ComponentRef& component) {
    return component.kind == ir::ComponentKind::module ? &system.modules[component.definition] : nullptr;
}

}  // namespace

bool write_prism(driver::Project& project, const Options& options, Report& report) {
    const auto preferences = read_preferences(project, options.probability);
    if (!preferences) return false;
    const auto components = driver::code_components(project.system, options.load.component, options.load.robosim);
    if (components.empty())
        project.diagnostics.report(prism_emit::rules::no_module, model_place(project), {project.name});
    for (const ir::ComponentRef& component : components) {
        const ir::Module* const module = module_of(project.system, component);
        if (module == nullptr) {
            project.diagnostics.report(prism_emit::rules::no_module, driver::declared_at(project.system, component),
                                       {component.path});
            return false;
        }
        const auto emission = prism_emit::emit(project.system, *module, *preferences, project.diagnostics);
        if (!emission) return false;
        struct File {
            std::string path, text;
        };
        const std::vector<File> files{{file_name(project, component) + ".prism", prism_emit::file_text(*emission)}};
        if (!write_all("prism/" + project.folder, files, report.prism_files, options, project)) return false;
    }
    return project.diagnostics.ok();
}

namespace {

/// Returns the place where a component is declared.
std::optional<runs::Place> declaration_place(const driver::Project& project, const ir::ComponentRef& component) {
    const ir::System& system = project.system;
    const auto place_of = [&](const ir::Origin& origin) { return driver::region_of(project.sources, origin.span); };
    if (component.kind == ir::ComponentKind::module) return place_of(system.modules[component.definition].origin);
    if (component.kind == ir::ComponentKind::controller)
        return place_of(system.controllers[component.definition].origin);
    return place_of(system.machines[component.definition].origin);
}

bool has_sequences(const ir::System& system) {
    return std::ranges::any_of(system.types, [](const ir::Type& type) { return type.kind == ir::TypeKind::sequence; });
}

}  // namespace

namespace {

/// Returns the values with which the code is compared: the carriers if `--concrete` or ranges are given, otherwise all
/// values.
conformance::Numbers numbers_to_compare(const driver::Project& project, const Options& options) {
    const bool carriers = options.claims.concrete || driver::chooses_ranges(project);
    return carriers ? conformance::Numbers::carriers : conformance::Numbers::all;
}

/// Returns the claims about the cycles of a component; null if there are none.
std::shared_ptr<const conformance::CycleClaims> cycle_claims(const driver::Project& project,
                                                             const ir::ComponentRef& component) {
    conformance::CycleClaims claims;
    claims.unit = project.claims->checked.unit;
    for (const claims::CheckedClaim& claim : project.claims->checked.claims)
        if (claim.raised && claim.component.path == ir::qualified_name(component) &&
            claim.component.robosim == ir::is_robosim(project.system, component)) {
            claims.claims.push_back(claim);
            const std::string other = driver::why_other_constants(project, claim);
            if (!other.empty()) claims.refused.emplace(claim.name, other);
        }
    if (claims.claims.empty()) return nullptr;
    return std::make_shared<const conformance::CycleClaims>(std::move(claims));
}

/// Removes claims about cycles from the list of undecided assertions if the comparison with the code has answered them.
void drop_answered(Report& report) {
    const auto answered = [&](const driver::AssertionReport& assertion) {
        return std::ranges::any_of(report.conformance, [&](const ConformanceReport& one) {
            for (std::size_t i = 0; i < one.result.claims.size() && i < one.claim_regions.size(); ++i)
                if (one.result.claims[i].claim == assertion.name && one.claim_regions[i] == assertion.region)
                    return true;
            return false;
        });
    };
    std::erase_if(report.assertions, answered);
}

/// Returns the claim of the certificate of a component's code, with the place of the component.
std::string certified_claim(const ConformanceReport& component) {
    std::string place;
    if (component.region) place = fmt::format(" ({}:{})", component.region->file, component.region->line);
    return fmt::format("the code of {} conforms{}", component.component, place);
}

/// Writes the certificate of code that conforms. `number` is the number of the component.
driver::CertificateReport certificate_of(const ConformanceReport& component, std::size_t number,
                                         const Options& options) {
    const conformance::Result& result = component.result;
    driver::CertificateReport report;
    report.reason = result.certificate_failure;
    if (result.certificate == nullptr) return report;
    const std::string folder = certify::folder_name(std::to_string(number), "code of " + component.component);
    return driver::write_certificate(options.claims.certificates, folder, *result.certificate, options.run->budget());
}

bool allows_rounding(const Options& options) {
    const auto& allowed = options.load.allowed;
    return std::ranges::find(allowed, conformance::rules::rounded.code) != allowed.end();
}

}  // namespace

void check_conformance(driver::Project& project, const Options& options, Report& report) {
    const auto components = driver::code_components(project.system, options.load.component, options.load.robosim);
    if (components.empty())
        project.diagnostics.report(rules::no_component, model_place(project),
                                   {options.load.component.empty() ? "the model" : options.load.component});
    if (!export_fits(project, options, components.size())) return;
    const std::size_t first = report.conformance.size();
    {
        const auto edit = options.run->edit();
        for (const ir::ComponentRef& component : components) {
            report.conformance.push_back({project.label + driver::component_name(project.system, component),
                                          declaration_place(project, component),
                                          {},
                                          0});
            report.conformance.back().result.reason = driver::undecided_at_limit;
        }
    }
    set_cycles(project, components, options);
    std::optional<conformance::TimedModel> model;  // built for the first component and used for all
    std::string unlike_blocks;
    for (std::size_t i = 0; i < components.size(); ++i) {
        const ir::ComponentRef& component = components[i];
        const diagnostics::Budget::Phase phase(options.run->budget(),
                                               "checking the code of " + ir::qualified_name(component));
        const auto start = std::chrono::steady_clock::now();
        conformance::Options conformance_options;
        conformance_options.cycle_length = options.code.cycle;
        conformance_options.limits = limits(options, "code of " + ir::qualified_name(component));
        conformance_options.generator.choices = options.code.choices;
        conformance_options.generator.order = event_order(project, component);
        conformance_options.relation = options.conform.relation;
        conformance_options.numbers = numbers_to_compare(project, options);
        conformance_options.rounding_allowed = allows_rounding(options);
        conformance_options.walks.cycles = options.conform.walks;
        conformance_options.cache = options.run->cache();
        conformance_options.claims = cycle_claims(project, component);
        conformance_options.exported = export_format(options.conform.exported_code);
        ConformanceReport one;
        one.component = project.label + driver::component_name(project.system, component);
        one.region = declaration_place(project, component);
        if (!model) {
            model =
                conformance::timed_model(project.system, project.instantiation, project.sources, project.diagnostics);
            unlike_blocks = values_unlike_blocks(project, model->script.definitions);
        }
        if (!options.claims.certificates.empty()) conformance_options.certified = certified_claim(one);
        one.result = conformance::conform(*model, component, conformance_options, project.diagnostics);
        for (const conformance::CycleAnswers& claim : one.result.claims)
            one.claim_regions.push_back(driver::region_of(project.sources, claim.span));
        one.order = order_text(project.system, conformance_options.generator.order);
        if (!unlike_blocks.empty())
            one.result.warnings.push_back(fmt::format(
                "the csp block Instantiations is not read here: {}; --const sets constants", unlike_blocks));
        if (has_sequences(project.system) && !one.result.lists_of_any_length)
            one.result.warnings.push_back(
                fmt::format("sequences have at most {} items in this check; --range Seq=0..N sets another bound",
                            project.instantiation.sequence_bound));
        if (!options.claims.certificates.empty() && one.result.outcome == conformance::Outcome::conforms)
            one.certificate = certificate_of(one, first + i + 1, options);
        one.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const bool exported = options.verb == Verb::verify && !one.result.normal_form.empty() &&
                              options.claims.times != driver::Times::untimed;
        if (exported && !write_normal_form(project, options, component, one.result.normal_form, report)) return;
        if (!options.conform.exported_code.empty() && !write_code_graph(project, options, one.result, report)) return;
        const auto edit = options.run->edit();
        report.conformance[first + i] = std::move(one);
    }
    const auto edit = options.run->edit();
    drop_answered(report);
}

namespace {

/// Why a report without assertions has none.
std::string why_nothing_claimed(const std::vector<driver::Part>& parts, const Options& options) {
    const bool robosim = std::ranges::any_of(
        parts, [](const driver::Part& part) { return !ir::robosim_components(part.project->system).empty(); });
    if (robosim && options.claims.times == driver::Times::untimed)
        return "nothing was checked: RoboSim has no untimed semantics, and all claims about its components are timed; "
               "leave out --untimed";
    return "nothing is claimed of the model: there are no assertions to check";
}

/// A run that found nothing to check must not look like a successful check.
void note_nothing_checked(const std::vector<driver::Part>& parts, const Options& options, Report& report) {
    if (!decides_assertions(options.verb)) return;
    const auto decided = [](const driver::AssertionReport& assertion) {
        return assertion.answer != driver::Answer::no_check;
    };
    if (std::ranges::any_of(report.assertions, decided)) return;
    const auto claims = [](const ConformanceReport& one) { return !one.result.claims.empty(); };
    if (std::ranges::any_of(report.conformance, claims)) return;
    report.unclaimed = report.assertions.empty() ? why_nothing_claimed(parts, options)
                                                 : "nothing was checked: no assertion has a check in this semantics";
    report.nothing_checked = options.verb == Verb::check && report.sizes.empty();
}

/// True if a part has components for the verb. One of several parts may contain only types; no code is generated for
/// it.
bool has_components(const driver::Part& part, const std::vector<driver::Part>& parts, const Options& options) {
    const bool code = options.verb == Verb::emit_cpp || options.verb == Verb::emit_monitor ||
                      options.verb == Verb::emit_prism || options.verb == Verb::emit_tests ||
                      options.verb == Verb::emit_rst || options.verb == Verb::conform;
    const bool some =
        !driver::code_components(part.project->system, options.load.component, options.load.robosim).empty();
    return some || (options.load.component.empty() && (!code || parts.size() == 1));
}

/// True if some component was compared with its code. Then components without code do not reject the whole part.
bool compares_some(const Report& report) {
    return std::ranges::any_of(report.conformance, [](const ConformanceReport& one) {
        return one.result.outcome != conformance::Outcome::not_generated;
    });
}

/// True if only the claims of a rejected part have errors. The report then lists all its claims as undecided.
bool reports_refused(const driver::Part& part, const Options& options) {
    return part.again || (decides_assertions(options.verb) && only_claims_broken(*part.project));
}

/// Shows the diagnostics of all parts. In formats for programs, the diagnostics of a single part are the result of the
/// run. Those of several parts, and those of claims, are part of the report.
bool show_all(const std::vector<driver::Part>& parts, const Options& options, const Report& report) {
    const bool alone = parts.size() == 1 && !reports_refused(parts.front(), options) &&
                       (parts.front().project->diagnostics.ok() || !compares_some(report));
    if (alone) return show_diagnostics(*parts.front().project, options);
    bool good = true;
    for (const driver::Part& part : parts) {
        if (options.output.format != Format::json) show_findings(*part.project, options);
        good = is_acceptable(*part.project, options.load) && good;
    }
    return good;
}

/// Returns the first part that is rejected because the command line is wrong. A single part is also returned if its
/// model is wrong.
const driver::Project* first_refused(const std::vector<driver::Part>& parts, const Options& options,
                                     const Report& report) {
    for (const driver::Part& part : parts) {
        if (is_acceptable(*part.project, options.load)) continue;
        const bool alone = parts.size() == 1 && !reports_refused(part, options) && !compares_some(report);
        if (alone || refusal_code(*part.project) == Exit::usage) return part.project.get();
    }
    return nullptr;
}

void note_refused(const std::vector<driver::Part>& parts, const Options& options, Report& report) {
    const auto edit = options.run->edit();
    report.refused.clear();
    for (const driver::Part& part : parts)
        if (!is_acceptable(*part.project, options.load))
            report.refused.push_back({part.project->name,
                                      diagnostics::render_json(part.project->sources, part.project->diagnostics),
                                      diagnostics::render_text(part.project->sources, part.project->diagnostics)});
}

/// Adds the claims of assertion files that have errors, or that may depend on errors, to the report as undecided.
void report_broken_claims(const driver::Project& project, const Options& options, Report& report) {
    if (!decides_assertions(options.verb)) return;
    for (const auto& file : project.model->files) {
        if (!file->is_assertions) continue;
        for (const frontend::Assertion& claim : file->assertions) {
            if (!is_selected(options.claims, claim.name)) continue;
            driver::AssertionReport one;
            one.title = one.name = claim.name;
            one.place = project.sources.path_and_line(claim.span);
            one.answer = driver::Answer::error;
            one.reason = fmt::format("{}: not decided: {} has errors", diagnostics::escape_for_display(one.place),
                                     diagnostics::escape_for_display(project.name));
            const auto edit = options.run->edit();
            report.assertions.push_back(std::move(one));
        }
    }
}

/// Stores the page of `--html`.
void keep_page(const std::vector<driver::Part>& parts, const Options& options, const Report& report) {
    if (!options.output.html.empty())
        options.run->keep_for(options.output.html,
                              render_html(report, parts, record_of(options), options.run->budget()));
}

/// Stores the page of `--html` for a run that ended early.
void keep_last_page(const std::vector<driver::Part>& parts, const Options& options, const Report& report) {
    if (options.output.html.empty()) return;
    options.run->keep_for(options.output.html,
                          last_page(parts, !options.run->is_watching(),
                                    [&](const std::vector<driver::Part>& drawn, diagnostics::Budget& budget) {
                                        return render_html(report, drawn, record_of(options), budget);
                                    }));
}

/// Outputs the result if no part is processed: the diagnostics of this part and, with --html, a page with the errors.
Exit refuse_parts(const driver::Project& stopped, const std::vector<driver::Part>& parts, const Options& options,
                  Report& report) {
    if (refusal_code(stopped) != Exit::usage) {
        begin(parts, options, report);
        note_refused(parts, options, report);
        keep_page(parts, options, report);
    }
    (void)show_diagnostics(stopped, options);
    return refusal_code(stopped);
}

/// Runs a verb whose answer is a report over all parts. A part with errors is rejected, and the others are still
/// processed.
Exit run_parts(const std::vector<driver::Part>& parts, const Options& options, Report& report) {
    begin(parts, options, report);
    note_refused(parts, options, report);
    bool some = false;
    for (const driver::Part& part : parts) {
        const bool refused = !is_acceptable(*part.project, options.load);
        some = some || refused;
        if (refused && reports_refused(part, options)) report_broken_claims(*part.project, options, report);
        if (refused || !has_components(part, parts, options)) continue;
        some = true;
        Options part_options = options;
        part_options.claims.core = core_wanted(part, options);
        const bool code =
            !part.again &&
            (parts.size() == 1 ||
             !driver::code_components(part.project->system, options.load.component, options.load.robosim).empty());
        (void)run_phases(*part.project, part_options, code, report);
    }
    if (!some)
        parts.front().project->diagnostics.report(rules::no_component, model_place(*parts.front().project),
                                                  {"the models"});
    options.run->finish();
    if (const driver::Project* const stopped = first_refused(parts, options, report))
        return refuse_parts(*stopped, parts, options, report);
    note_refused(parts, options, report);
    note_nothing_checked(parts, options, report);
    keep_page(parts, options, report);
    const bool accepted = show_all(parts, options, report);
    if (accepted && report.all_decided()) options.run->end_questions();
    const Exit exit = print_report(report, options);
    return accepted ? exit : Exit::bad_input;
}

/// Appends the phase that --print selects to the text.
Exit take_phase(driver::Project& project, const Options& options, std::string& text) {
    show_diagnostics(project, options);
    const Phase phase = options.output.phase;
    if (phase == Phase::ast || phase == Phase::model) {
        text += frontend::dump_model(*project.model, project.sources, phase == Phase::model);
        return is_acceptable(project, options.load) ? Exit::success : refusal_code(project);
    }
    if (!is_acceptable(project, options.load)) return refusal_code(project);
    if (phase == Phase::ir) {
        text += ir::dump_text(project.system);
        return Exit::success;
    }
    const auto time = phase == Phase::script ? csp_emit::Time::untimed : csp_emit::Time::timed;
    if (phase == Phase::script && !allows_untimed(project, "`--print script`", "`--print timed-script` prints it")) {
        show_diagnostics(project, options);
        return Exit::bad_input;
    }
    const csp_emit::Emission& emission = emit_csp(project, options.claims, options.swarm, time);
    if (!show_diagnostics(project, options)) return Exit::bad_input;
    text += cspm::print(emission.script);
    return Exit::success;
}

/// Prints the phases to stdout, part by part. If there are several parts, the name of each part is printed above its
/// phase.
Exit print_phases(const std::vector<driver::Part>& parts, const Options& options) {
    Exit exit = Exit::success;
    std::string text;
    for (const driver::Part& part : parts) {
        if (parts.size() > 1) text += fmt::format("-- {}\n", diagnostics::escape_for_display(part.project->name));
        const Exit one = take_phase(*part.project, options, text);
        if (exit == Exit::success) exit = one;
    }
    options.run->finish();
    print_exact(text);
    return exit;
}

/// Compares logs with the parts. A log may belong to any part, so all parts must be correct.
Exit compare_traces(const std::vector<driver::Part>& parts, const Options& options, Report& report) {
    const auto refused = std::ranges::find_if(
        parts, [&](const driver::Part& part) { return !is_acceptable(*part.project, options.load); });
    if (refused != parts.end()) {
        (void)show_diagnostics(*refused->project, options);
        return refusal_code(*refused->project);
    }
    begin(parts, options, report);
    return conform_traces(parts, options);
}

/// Sets the options for PRISM models. These contain buffers between machines, so the warning about ignored buffers is
/// suppressed.
Options with_buffers(Options options) {
    options.load.allowed.emplace_back("Cn11");
    return options;
}

Exit run_verb(const Options& given, Report& report, std::vector<driver::Part>& parts) {
    Options options = given.verb == Verb::emit_prism ? with_buffers(given) : given;
    parts = driver::load_parts(options, options.run->budget());
    if (options.verb == Verb::conform || options.verb == Verb::emit_cpp || options.verb == Verb::emit_monitor ||
        options.verb == Verb::emit_tests || options.verb == Verb::emit_rst)
        for (const driver::Part& part : parts) driver::read_ignored_claims(*part.project, options.load);
    record_projects(parts, options, options);
    if (options.output.phase != Phase::none) return print_phases(parts, options);
    if (!options.code.mapping.empty() && options.code.target != cpp_emit::Target::ros2)
        throw UsageError("--mapping needs --target ros2");
    if (options.code.mapping_draft && (options.code.target != cpp_emit::Target::ros2 || !options.code.mapping.empty()))
        throw UsageError("--mapping-draft needs --target ros2 and no --mapping");
    if ((options.code.package_given || options.code.model_names) && options.code.target != cpp_emit::Target::ros2)
        throw UsageError("--license, --maintainer, --package-version and --model-names need --target ros2");
    if (options.code.dispatch != cpp_emit::Dispatch::timer && options.code.target != cpp_emit::Target::ros2)
        throw UsageError("--dispatch immediate needs --target ros2");
    if (!options.conform.traces.empty() && is_requested(options, Format::junit))
        throw UsageError("--format junit does not support --traces; use text or json");
    if (!options.conform.traces.empty() && !options.claims.certificates.empty())
        throw UsageError("--certify is about code, and --traces compares logs");
    if (!options.conform.traces.empty()) return compare_traces(parts, options, report);
    if (const driver::Project* const stopped = first_refused(parts, options, report))
        return refuse_parts(*stopped, parts, options, report);
    require_empty_certificates(options);
    return run_parts(parts, options, report);
}

}  // namespace

Exit run_model(const Options& given) {
    Options options = given;
    add_swarm(options);
    const bool rules =
        std::ranges::all_of(options.load.inputs, [](const std::string& input) { return input.ends_with(".sleec"); });
    const bool claims =
        std::ranges::all_of(options.load.inputs, [](const std::string& input) { return input.ends_with(".claims"); });
    if (options.verb == Verb::conform && !options.conform.traces.empty() && rules) return conform_rules(options);
    if (options.verb == Verb::conform && !options.conform.traces.empty() && claims) return conform_claims(options);
    const auto report = std::make_shared<Report>();
    const auto parts = std::make_shared<std::vector<driver::Part>>();
    report->model = fmt::format("{}", fmt::join(options.load.inputs, " "));
    // The run may call the function after this function has returned, so the function owns its data.
    options.run->last_word([report, parts, options](const std::string& why) {
        report->limit = why;
        for (driver::AssertionReport& assertion : report->assertions)
            if (assertion.answer == driver::Answer::inconclusive && assertion.reason == driver::undecided_at_limit)
                assertion.reason = "not decided: " + why;
        keep_last_page(*parts, options, *report);
        return print_report(*report, options);
    });
    if (options.verb == Verb::emit_monitor && (rules || claims)) {
        const bool written = claims ? write_claim_monitors(options, *report) : write_rule_monitors(options, *report);
        options.run->finish();
        const Exit exit = print_report(*report, options);
        return written ? exit : Exit::bad_input;
    }
    try {
        return run_verb(options, *report, *parts);
    } catch (const diagnostics::LimitReached&) {
        options.run->finish();
        if (options.output.format == Format::text)
            for (const driver::Part& part : *parts) show_findings(*part.project, options);
        throw;
    }
}

}  // namespace robochart::app
