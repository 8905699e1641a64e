// SPDX-License-Identifier: Apache-2.0
#include "driver/model/pipeline.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>

#include "base/diagnostics/containers.hpp"
#include "base/diagnostics/files.hpp"
#include "base/diagnostics/render.hpp"
#include "base/diagnostics/spelling.hpp"
#include "csp_emit/blocks/check_script.hpp"
#include "csp_emit/swarm/compose.hpp"
#include "csp_emit/swarm/read_swarm.hpp"
#include "driver/model/broken_claims.hpp"
#include "driver/model/claim_files.hpp"
#include "driver/model/claim_scripts.hpp"
#include "driver/model/project_claims.hpp"
#include "driver/settings/claim_selection.hpp"
#include "driver/settings/instantiation_options.hpp"
#include "driver/settings/rules.hpp"
#include "driver/settings/usage_error.hpp"
#include "frontend/names/names.hpp"
#include "frontend/project/project.hpp"
#include "frontend/project/units.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/syntax_rules.hpp"
#include "semantics/instantiate/given_constants.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/ir/query.hpp"
#include "semantics/lower/lower.hpp"

namespace robochart::driver {
namespace fs = std::filesystem;
namespace {

/// Returns the name of the file or folder. `.` and `..` are resolved first.
std::string project_name(const std::string& input) {
    std::error_code lost;
    const fs::path whole = fs::absolute(input, lost);
    const fs::path path = (lost ? fs::path(input) : whole).lexically_normal();
    const fs::path last = path.has_filename() ? path.filename() : path.parent_path().filename();
    const std::string stem = last.stem().string();
    return stem.empty() || stem == "." || stem == ".." ? "model" : stem;
}

/// Sets the budget and the suppressed warnings for all phases of a project.
void prepare_project(Project& project, const LoadSettings& settings, diagnostics::Budget* budget) {
    for (const std::string& code : settings.allowed) project.diagnostics.allow_code(code);
    project.diagnostics.set_budget(budget);
}

ir::ComponentRef make_component_ref(ir::ComponentKind kind, std::size_t index, const std::string& package,
                                    const std::string& name) {
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
        all.push_back(
            make_component_ref(ir::ComponentKind::module, i, system.modules[i].package, system.modules[i].name));
    for (std::size_t i = 0; i < system.controllers.size(); ++i)
        all.push_back(make_component_ref(ir::ComponentKind::controller, i, system.controllers[i].package,
                                         system.controllers[i].name));
    for (std::size_t i = 0; i < system.machines.size(); ++i) {
        const ir::Machine& machine = system.machines[i];
        if (machine.kind == ir::MachineKind::state_machine)
            all.push_back(make_component_ref(ir::ComponentKind::machine, i, machine.package, machine.name));
    }
    return all;
}

/// True if the command needs the RoboSim components. It does if it writes or checks scripts, or if it handles RoboSim
/// components and one is selected.
bool uses_robosim(const ir::System& system, const LoadSettings& settings) {
    if (settings.claims == ClaimUse::decide || settings.claims == ClaimUse::write) return true;
    if (!settings.robosim) return false;
    const auto chosen = code_components(system, settings.component, true);
    return chosen.empty() ||
           std::ranges::any_of(chosen, [&](const ir::ComponentRef& ref) { return ir::is_robosim(system, ref); });
}

bool lower(Project& project, const LoadSettings& settings) {
    const diagnostics::Budget::Phase phase(*project.diagnostics.budget(), "reading the model");
    if (!is_acceptable(project, settings)) return false;
    project.system = ir::lower(*project.model, project.sources, project.diagnostics);
    return project.diagnostics.ok();
}

bool has_robochart(const ir::System& system) {
    const auto components = all_components(system);
    return std::ranges::any_of(components, [&](const ir::ComponentRef& ref) { return !ir::is_robosim(system, ref); });
}

/// Removes the RoboSim components of the parts if the command does not need them. There is no message if the command
/// handles RoboSim, but another component is selected.
bool leave_out_robosim(const std::vector<Part>& parts, const LoadSettings& settings) {
    const bool charts =
        std::ranges::any_of(parts, [](const Part& part) { return has_robochart(part.project->system); });
    bool good = true;
    for (const Part& part : parts) {
        Project& project = *part.project;
        if (!project.diagnostics.ok() || uses_robosim(project.system, settings)) continue;
        diagnostics::Diagnostics apart;
        ir::leave_out_robosim(project.system, settings.robosim ? apart : project.diagnostics, charts);
        good = project.diagnostics.ok() && good;
    }
    return good;
}

/// Makes the project finite. `options` are the settings without constants that exist only in other parts.
bool make_finite(Project& project, const ir::InstantiationOptions& options, ir::Carriers carriers) {
    const diagnostics::Budget::Phase phase(*project.diagnostics.budget(), "making the model finite");
    project.asked = options;
    project.instantiation = ir::instantiate_system(project.system, options, project.diagnostics, carriers);
    return project.diagnostics.ok();
}

}  // namespace

namespace {

using Time = std::chrono::steady_clock::time_point;

double seconds_since(Time start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void check_component(const std::vector<Part>& parts, const LoadSettings& settings);

/// Finds the names that components of one kind in several packages of the project share.
void find_shared_names(Project& project) {
    std::map<std::pair<ir::ComponentKind, std::string>, std::string> packages;
    for (const ir::ComponentRef& ref : all_components(project.system))
        if (packages.try_emplace({ref.kind, ref.path}, ref.package).first->second != ref.package)
            project.shared_names.insert(ref.path);
}

ir::Carriers carriers_of(const Settings& settings) {
    return settings.claims.concrete ? ir::Carriers::robotool : ir::Carriers::beyond;
}

/// Lowers the parts and makes them finite. A constant from the settings applies to the parts that have it. The first
/// part reports constants that no part has.
void instantiate_parts(const std::vector<Part>& parts, const Settings& settings) {
    std::string error;
    const ir::InstantiationOptions given = instantiation_options(settings.instantiation, error);
    const ir::GivenConstants weaker = given_constants(settings.instantiation.weaker_constants, error);
    if (!error.empty()) {
        parts.front().project->diagnostics.report(rules::bad_option, {}, {error});
        return;
    }
    bool lowered = true;
    for (const Part& part : parts) lowered = lower(*part.project, settings.load) && lowered;
    lowered = leave_out_robosim(parts, settings.load) && lowered;
    for (const Part& part : parts) find_shared_names(*part.project);
    bool all = lowered;
    for (const Part& part : parts) {
        if (!is_acceptable(*part.project, settings.load)) continue;
        ir::InstantiationOptions options = given;
        options.constants.merge(ir::not_overridden(part.project->system, weaker, given.constants));
        const auto has = [&](const Part& other, const std::string& name) {
            return ir::names_constant(other.project->system, name);
        };
        std::erase_if(options.constants, [&](const auto& constant) {
            const auto known =
                std::ranges::any_of(parts, [&](const Part& other) { return has(other, constant.first); });
            return !has(part, constant.first) && (known || !lowered || &part != &parts.front());
        });
        all = make_finite(*part.project, options, carriers_of(settings)) && all;
    }
    if (all) check_component(parts, settings.load);
}

/// Returns the file that names a unit: its first model, or the assertion file that distinguishes it.
fs::path naming_file(const Project& whole, const frontend::Unit& unit) {
    const auto path = [&](std::size_t file) { return whole.sources.path(whole.model->files[file]->source); };
    if (unit.again) return path(unit.files.back());
    const auto model =
        std::ranges::find_if(unit.files, [&](std::size_t file) { return frontend::is_model_path(path(file)); });
    return path(model == unit.files.end() ? unit.files.front() : *model);
}

/// Returns a unique name for each unit: the name of its file. If several names are equal, the name of the folder is
/// prepended. If names are still equal, a number is added.
std::vector<std::string> names_of(const Project& whole, const std::vector<frontend::Unit>& units) {
    std::map<std::string, std::size_t> called;
    for (const frontend::Unit& unit : units) ++called[project_name(naming_file(whole, unit).string())];
    std::vector<std::string> names;
    std::set<std::string> taken;
    for (const frontend::Unit& unit : units) {
        const fs::path file = naming_file(whole, unit).lexically_normal();
        std::string name = project_name(file.string());
        if (called[name] > 1 && !unit.again && file.has_parent_path())
            name = fmt::format("{}_{}", file.parent_path().filename().string(), name);
        std::string unique = name;
        for (int number = 2; !taken.insert(unique).second; ++number) unique = fmt::format("{}_{}", name, number);
        names.push_back(unique);
    }
    return names;
}

/// Makes the part that consists of these files. `other_texts` replaces the texts of some files.
std::unique_ptr<Project> part_of(const Project& whole, const frontend::Unit& unit, const std::string& name,
                                 const LoadSettings& settings,
                                 const std::map<std::size_t, std::string>& other_texts = {}) {
    auto part = std::make_unique<Project>(whole.texts);
    std::vector<diagnostics::SourceId> texts;
    for (const std::size_t file : unit.files) {
        const diagnostics::SourceId source = whole.model->files[file]->source;
        const auto other = other_texts.find(file);
        texts.push_back(other == other_texts.end() ? source
                                                   : part->sources.add(whole.sources.path(source), other->second));
    }
    part->name = name;
    part->unit = whole.unit;
    part->unit_place = whole.unit_place;
    part->claims->ignored = whole.claims->ignored;
    prepare_project(*part, settings, whole.diagnostics.budget());
    part->model = frontend::load_texts(part->sources, texts, part->diagnostics);
    // If the whole project has errors in these texts, the part gets the findings of the whole project. A name that is
    // unknown in this part may be declared in another part, so the part's own findings could be wrong.
    const std::set<diagnostics::SourceId> own(texts.begin(), texts.end());
    const auto wrong = [&](diagnostics::SourceId text) { return whole.diagnostics.has_errors_in(text); };
    if (!part->diagnostics.ok() && std::ranges::any_of(own, wrong))
        part->diagnostics = whole.diagnostics.findings_in_texts(own);
    return part;
}

/// Returns the first error of each text; empty if an error is outside of assertion files.
std::map<diagnostics::SourceId, diagnostics::Diagnostic> errors_of_assertions(const Project& project) {
    std::set<diagnostics::SourceId> assertions;
    for (const auto& file : project.model->files)
        if (file->is_assertions) assertions.insert(file->source);
    std::map<diagnostics::SourceId, diagnostics::Diagnostic> first;
    for (const diagnostics::Diagnostic& finding : project.diagnostics.sorted_findings()) {
        if (finding.rule->severity != diagnostics::Severity::error) continue;
        if (!finding.span.is_known() || !assertions.contains(finding.span.source)) return {};
        first.try_emplace(finding.span.source, finding);
    }
    return first;
}

/// Removes the assertion files that have errors from the project, and reports each removed file. Returns the unchanged
/// project if other files also have errors, or if no file would remain.
std::unique_ptr<Project> without_broken_assertions(std::unique_ptr<Project> project, const LoadSettings& settings) {
    const auto broken = errors_of_assertions(*project);
    frontend::Unit rest;
    for (std::size_t i = 0; i < project->model->files.size(); ++i) {
        const frontend::File& file = *project->model->files[i];
        if (!file.is_library && !broken.contains(file.source)) rest.files.push_back(i);
    }
    if (broken.empty() || rest.files.empty()) return project;
    std::unique_ptr<Project> left = part_of(*project, rest, project->name, settings);
    for (const auto& [source, first] : broken)
        left->diagnostics.report(rules::left_out, first.span, {})
            .notes.push_back({{}, fmt::format("{}: {}", first.rule->code, first.message())});
    return left;
}

/// Returns the model that consists of these texts.
std::unique_ptr<frontend::Model> load_given(Project& project, const std::vector<TextInput>& inputs) {
    std::vector<diagnostics::SourceId> texts;
    for (const TextInput& input : inputs)
        if (!input.path.ends_with(".claims")) texts.push_back(project.sources.add(input.path, input.text));
    return frontend::load_texts(project.sources, texts, project.diagnostics);
}

std::unique_ptr<Project> read(const LoadSettings& settings, diagnostics::Budget& budget) {
    auto project = std::make_unique<Project>();
    project->name = project_name(settings.inputs.front());
    prepare_project(*project, settings, &budget);
    const diagnostics::Budget::Phase phase(budget, "reading the model");
    project->model = settings.texts.empty()
                         ? frontend::load_project(project->sources, model_inputs(settings.inputs), project->diagnostics)
                         : load_given(*project, settings.texts);
    read_claim_files(*project, settings);
    return settings.claims == ClaimUse::ignore ? without_broken_assertions(std::move(project), settings)
                                               : std::move(project);
}

/// Sets the labels of the parts. If two parts have components with the same name, all output about a part contains its
/// name.
void label_parts(const std::vector<Part>& parts) {
    std::map<std::string, std::set<const Project*>> owners;
    for (const Part& part : parts)
        if (!part.again)
            for (const ir::ComponentRef& ref : all_components(part.project->system))
                owners[ref.path].insert(part.project.get());
    const auto clash = [](const auto& entry) { return entry.second.size() > 1; };
    if (std::ranges::none_of(owners, clash)) return;
    for (const Part& part : parts) {
        part.project->label = part.project->name + ": ";
        part.project->folder = part.project->name + "/";
    }
}

/// True if there are errors without a place in a text, so that no part can be processed.
bool cannot_be_read(const diagnostics::Diagnostics& diagnostics) {
    const std::vector<diagnostics::Diagnostic> all = diagnostics.sorted_findings();
    return std::ranges::any_of(all, [](const diagnostics::Diagnostic& finding) {
        return finding.rule->severity == diagnostics::Severity::error && !finding.span.is_known();
    });
}

/// True if some assertion or CSP block is decided in the untimed semantics.
bool is_decided_untimed(const frontend::Model& model) {
    const auto untimed = [](const auto& item) { return item.time != frontend::AssertionTime::timed; };
    return std::ranges::any_of(model.files, [&](const auto& file) {
        return std::ranges::any_of(file->assertions, untimed) || std::ranges::any_of(file->csp_blocks, untimed);
    });
}

/// Claims of claims files are timed. If there are no others to decide, RC-U01 would warn of checks that nobody makes.
void drop_untimed_findings(Project& project, const LoadSettings& settings) {
    const bool claims =
        std::ranges::any_of(project.claims->files, [](const auto& file) { return !file->claims.empty(); });
    if (!claims || is_decided_untimed(*project.model)) return;
    const diagnostics::Diagnostics all = std::move(project.diagnostics);
    project.diagnostics = {};
    prepare_project(project, settings, all.budget());
    project.diagnostics.allow_code(std::string(frontend::rules::untimed.code));
    project.diagnostics.add(all);
}

/// Divides the project into its parts.
std::vector<Part> split_project(std::unique_ptr<Project> whole, const LoadSettings& settings,
                                const std::function<std::vector<frontend::Unit>(const frontend::Model&)>& units_of) {
    std::vector<Part> parts;
    std::vector<frontend::Unit> units;
    const auto claim_files = whole->claims->files;
    const diagnostics::Diagnostics& findings = whole->diagnostics;
    if (!cannot_be_read(whole->diagnostics)) units = units_of(*whole->model);
    if (units.size() > 1) {
        const std::vector<std::string> names = names_of(*whole, units);
        for (std::size_t i = 0; i < units.size(); ++i)
            parts.push_back({part_of(*whole, units[i], names[i], settings), units[i].again});
        divide_claim_files(claim_files, parts);
        std::set<diagnostics::SourceId> claims;
        for (const auto& file : claim_files) claims.insert(file->source);
        parts.front().project->diagnostics.add(findings.findings_in_texts(claims));
    }
    if (parts.empty()) parts.push_back({std::move(whole), false});
    for (const Part& part : parts) {
        find_unit(*part.project);
        drop_untimed_findings(*part.project, settings);
    }
    return parts;
}

}  // namespace

bool includes_time(Times times, csp_emit::Time time) {
    return times != (time == csp_emit::Time::timed ? Times::untimed : Times::timed);
}

std::unique_ptr<Project> with_carriers_of_robotool(const Project& project) {
    diagnostics::Diagnostics known;  // the whole project has already reported these
    known.set_budget(project.diagnostics.budget());
    ir::Instantiation other = ir::instantiate_system(project.system, project.asked, known, ir::Carriers::robotool);
    const ir::Instantiation& own = project.instantiation;
    if (other.nat == own.nat && other.integer == own.integer && other.real == own.real && other.scale == own.scale)
        return nullptr;
    return with_data(project, project.system, std::move(other));
}

namespace {

/// Resolves the claims of all parts without errors.
void check_claims(const std::vector<Part>& parts, const Settings& settings) {
    for (const Part& part : parts)
        if (part.project->diagnostics.ok()) check_claim_files(*part.project, carriers_of(settings));
}

}  // namespace

std::unique_ptr<Project> load_project(const Settings& settings, diagnostics::Budget& budget) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<Part> parts;
    parts.push_back({read(settings.load, budget), false});
    find_unit(*parts.front().project);
    drop_untimed_findings(*parts.front().project, settings.load);
    instantiate_parts(parts, settings);
    check_claims(parts, settings);
    parts.front().project->seconds = seconds_since(start);
    return std::move(parts.front().project);
}

namespace {

/// Parses a grid such as "5x8".
csp_emit::SwarmGrid grid_of(const std::string& text) {
    constexpr std::uint32_t most = 64;
    csp_emit::SwarmGrid grid;
    const char* const end = text.data() + text.size();
    const auto [middle, first] = std::from_chars(text.data(), end, grid.width);
    const bool whole = first == std::errc() && middle != end && *middle == 'x' &&
                       std::from_chars(middle + 1, end, grid.height).ptr == end;
    const auto fits = [](std::uint32_t side) { return side >= 2 && side <= most; };
    if (!whole || !fits(grid.width) || !fits(grid.height))
        throw UsageError(fmt::format("--grid {}: expected two numbers from 2 to {}, such as 5x8", text, most));
    return grid;
}

/// Returns the swarm that --swarm names, changed by the other options about swarms.
csp_emit::Swarm swarm_of(const SwarmSettings& settings, diagnostics::SourceManager& sources,
                         diagnostics::Diagnostics& diagnostics) {
    std::string error;
    const auto source = load_input(sources, settings.file, error);
    if (!source) {
        diagnostics.report(frontend::syntax::unreadable, {}, {settings.file, error});
        return {};
    }
    const auto grid = settings.grid.empty() ? std::nullopt : std::optional(grid_of(settings.grid));
    return csp_emit::read_swarm(sources, *source, diagnostics, {settings.robots, grid});
}

/// Returns the names of a project's claims, or the texts of a swarm's claims, in order, without duplicates. The numbers
/// and patterns of --assertion refer to this list.
std::vector<std::string> claim_names(const Project& whole, const SwarmSettings& swarm) {
    std::vector<std::string> names;
    const auto add = [&](const std::string& name) {
        if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    };
    if (!swarm.file.empty()) {
        diagnostics::SourceManager sources;
        diagnostics::Diagnostics errors;  // reported when the swarm is composed
        for (const csp_emit::SwarmClaim& claim : swarm_of(swarm, sources, errors).claims) add(claim.text);
        return names;
    }
    for (const ClaimName& claim : all_claims_of(whole)) add(claim.name);
    return names;
}

void report_lost(Project& project, const std::string& word, const std::vector<std::string>& names) {
    project.diagnostics.report(rules::bad_option, {},
                               {fmt::format("--assertion {}: {}", word, why_lost(word, names, "the model"))});
}

/// Words of --assertion that select no claim of the model, but may select a core property.
struct OtherWords {
    std::vector<std::string> words;
    std::vector<std::string> claims;  ///< the names of the model's claims
};

/// Replaces the words of --assertion by the names of the claims that they select. Words that select no claim and no
/// core property are reported in the project.
OtherWords name_claims(Project& whole, Settings& settings) {
    OtherWords other;
    std::vector<std::string>& claims = settings.claims.names;
    if (claims.empty()) return other;
    other.claims = claim_names(whole, settings.swarm);
    const ClaimSelection selection = select_claims(claims, other.claims);
    claims.clear();
    for (const std::size_t place : selection.chosen) claims.push_back(other.claims[place]);
    const bool errors = !whole.diagnostics.ok();  // with errors, the list of claims may be incomplete
    const bool core = settings.load.claims == ClaimUse::decide && settings.swarm.file.empty();
    for (const std::string& word : selection.lost)
        if (errors)
            claims.push_back(word);
        else if (core && !word.empty() && !selects_by_number(word))
            other.words.push_back(word);
        else
            report_lost(whole, word, other.claims);
    if (!other.words.empty()) settings.claims.core = true;
    return other;
}

/// Returns the names of all core properties, in order, without duplicates.
std::vector<std::string> core_names(const std::vector<Part>& parts, const Settings& settings) {
    std::vector<std::string> names;
    for (const Part& part : parts) {
        if (!core_wanted(part, settings)) continue;
        for (const auto time : {csp_emit::Time::untimed, csp_emit::Time::timed}) {
            if (!includes_time(settings.claims.times, time) || !part.project->diagnostics.ok()) continue;
            for (const csp_emit::Obligation& claim :
                 emit_csp(*part.project, settings.claims, settings.swarm, time).obligations)
                if (!claim.component.empty() && std::ranges::find(names, core_name(claim)) == names.end())
                    names.push_back(core_name(claim));
        }
    }
    return names;
}

/// Finds the core properties that the other words select. Words that select none are reported in the first part.
void name_core_claims(std::vector<Part>& parts, const OtherWords& other, Settings& settings) {
    const auto is_sound = [](const Part& part) { return part.project->diagnostics.ok(); };
    if (other.words.empty() || !std::ranges::any_of(parts, is_sound)) return;
    const std::vector<std::string> names = core_names(parts, settings);
    const ClaimSelection selection = select_claims(other.words, names);
    for (const std::size_t place : selection.chosen) settings.claims.core_names.push_back(names[place]);
    std::vector<std::string> all = other.claims;
    all.insert(all.end(), names.begin(), names.end());
    for (const std::string& word : selection.lost) {
        const bool near = !diagnostics::nearest_spelling(word, names).empty();
        report_lost(*parts.front().project, word, near ? all : other.claims);
    }
}

/// Errors in CSP blocks are found when the script is made. The script is stored and reused by the check, so it is made
/// with the options of the check.
void read_blocks(const Part& part, const Settings& settings) {
    Project& project = *part.project;
    if (!project.diagnostics.ok() || project.system.csp_blocks.empty()) return;
    ClaimSettings claims = settings.claims;
    claims.core = core_wanted(part, settings);
    for (const auto time : {csp_emit::Time::untimed, csp_emit::Time::timed})
        if (includes_time(claims.times, time) && project.diagnostics.ok())
            (void)emit_csp(project, claims, settings.swarm, time);
}

/// True if every name is that of a claim in some assertion file.
bool are_claimed(const std::vector<Part>& parts, const std::vector<std::string>& names) {
    return std::ranges::all_of(names, [&](const std::string& name) {
        return std::ranges::any_of(parts, [&](const Part& part) {
            const auto& files = part.project->model->files;
            return std::ranges::any_of(files, [&](const auto& file) {
                return std::ranges::any_of(file->assertions,
                                           [&](const frontend::Assertion& claim) { return claim.name == name; });
            });
        });
    });
}

/// Removes the warnings about texts from which definitions were removed: the part with the errors has them, too.
void drop_repeated_findings(Project& sound, const BrokenClaims& found) {
    if (found.set_aside.empty() || !sound.diagnostics.ok()) return;
    std::set<diagnostics::SourceId> texts;
    for (const auto& file : sound.model->files) texts.insert(file->source);
    for (const BrokenClaims::SetAside& definition : found.set_aside)
        std::erase_if(texts, [&](diagnostics::SourceId text) {
            return sound.sources.path(text) == sound.sources.path(definition.place.source);
        });
    sound.diagnostics = sound.diagnostics.findings_in_texts(texts);
}

/// Separates claims and CSP blocks with errors from the others, which can still be decided. If some claims can be
/// decided, a part with errors is divided into two (broken_claims.hpp). Scripts are written for the part without
/// errors.
void separate_broken_claims(std::vector<Part>& parts, const Settings& settings) {
    const bool writes = settings.load.claims == ClaimUse::write;
    const bool decides = settings.load.claims == ClaimUse::decide;
    if ((!decides && !writes) || !settings.load.split_broken_claims || !are_claimed(parts, settings.claims.names))
        return;
    std::vector<Part> result;
    for (Part& part : parts) {
        read_blocks(part, settings);
        const auto found = part.project->diagnostics.ok() ? std::nullopt : broken_claims(*part.project);
        if (!found || !(found->some || writes) || !(decides || found->set_aside.empty())) {
            result.push_back(std::move(part));
            continue;
        }
        const Project& whole = *part.project;
        std::vector<Part> sound;
        sound.push_back({part_of(whole, found->sound.unit, whole.name, settings.load, found->sound.texts), part.again});
        sound.front().project->claims->files = whole.claims->files;
        drop_repeated_findings(*sound.front().project, *found);
        instantiate_parts(sound, settings);
        check_claims(sound, settings);
        separate_broken_claims(sound, settings);  // errors in blocks are only found if there are no others
        for (const BrokenClaims::SetAside& definition : found->set_aside)
            sound.front().project->diagnostics.report(rules::set_aside, definition.place,
                                                      {definition.name, definition.cause});
        std::set<diagnostics::SourceId> wrong;
        std::string named;  // name of the first file with an error
        for (const diagnostics::Diagnostic& finding : whole.diagnostics.sorted_findings())
            if (finding.rule->severity == diagnostics::Severity::error) {
                if (wrong.empty()) named = whole.sources.path(finding.span.source);
                wrong.insert(finding.span.source);
            }
        auto broken = part_of(whole, found->broken.unit, project_name(named), settings.load, found->broken.texts);
        broken->diagnostics = whole.diagnostics.findings_in_texts(wrong);
        for (Part& sound_part : sound) result.push_back(std::move(sound_part));
        result.push_back({std::move(broken), true});
    }
    parts = std::move(result);
}

}  // namespace

std::vector<Part> load_parts(Settings& settings, diagnostics::Budget& budget) {
    const auto start = std::chrono::steady_clock::now();
    std::unique_ptr<Project> whole = read(settings.load, budget);
    const OtherWords other = name_claims(*whole, settings);
    std::vector<Part> parts = split_project(std::move(whole), settings.load, frontend::split_into_units);
    instantiate_parts(parts, settings);
    check_claims(parts, settings);
    separate_broken_claims(parts, settings);
    name_core_claims(parts, other, settings);
    label_parts(parts);
    parts.front().project->seconds = seconds_since(start);
    return parts;
}

std::vector<Part> read_parts(const LoadSettings& settings, diagnostics::Budget& budget) {
    return split_project(read(settings, budget), settings, [](const frontend::Model& model) {
        std::vector<frontend::Unit> units;
        for (std::vector<std::size_t> group : frontend::group_files(model)) units.push_back({std::move(group), false});
        return units;
    });
}

bool is_selected(const ClaimSettings& settings, const std::string& claim) {
    const bool all = settings.names.empty() && settings.core_names.empty();
    return all || std::ranges::find(settings.names, claim) != settings.names.end();
}

std::string core_name(const csp_emit::Obligation& obligation) {
    const std::string& component = obligation.component;  // "state machine P::S"
    return fmt::format("{}: {}", component.substr(component.rfind(' ') + 1), obligation.property_text);
}

bool core_wanted(const Part& part, const Settings& settings) {
    const Project& project = *part.project;
    const bool checks = settings.load.claims == ClaimUse::decide;
    const auto& files = project.model->files;
    const bool claims = !project.system.properties.empty() || std::ranges::any_of(files, [](const auto& file) {
        const bool robosim = file->dialect == frontend::Dialect::robosim && !file->assertions.empty();
        return robosim || !file->probabilistic_assertions.empty() ||
               std::ranges::any_of(file->kept, [](const auto& foreign_part) { return foreign_part.claims; });
    });
    const bool of_files = !project.claims->checked.claims.empty() || !project.claims->instantiated.empty();
    const bool instead = checks && !claims && !of_files && settings.claims.names.empty() && !settings.claims.sizes;
    return !part.again && (settings.claims.core || instead) && settings.swarm.file.empty();
}

namespace {

/// True if a NAME=VALUE option sets this name.
bool is_set(const std::vector<std::string>& options, const std::string& name) {
    return std::ranges::any_of(options, [&](const std::string& option) { return option.starts_with(name + "="); });
}

}  // namespace

void add_swarm(Settings& settings) {
    const SwarmSettings& swarm_settings = settings.swarm;
    if (swarm_settings.file.empty()) {
        if (swarm_settings.robots > 0 || !swarm_settings.grid.empty())
            throw UsageError("--robots and --grid need --swarm");
        return;
    }
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics found;  // reported when the swarm is composed
    const csp_emit::Swarm swarm = swarm_of(swarm_settings, sources, found);
    if (!found.ok()) return;
    InstantiationSettings& instantiation = settings.instantiation;
    for (const csp_emit::SwarmConstant& constant : swarm.constants)
        if (!constant.value.empty())
            instantiation.weaker_constants.push_back(constant.name.text + "=" + constant.value);
    for (const csp_emit::SwarmRange& range : swarm.ranges)
        if (!is_set(instantiation.ranges, range.type.text))
            instantiation.ranges.push_back(fmt::format("{}={}..{}", range.type.text, range.low, range.high));
    if (swarm.grid && settings.claims.times == Times::both) settings.claims.times = Times::timed;
}

const csp_emit::Emission& emit_csp(Project& project, const ClaimSettings& claims, const SwarmSettings& swarm_settings,
                                   csp_emit::Time time) {
    if (const auto made = project.scripts.find(time); made != project.scripts.end()) return made->second;
    const diagnostics::Budget::Phase phase(*project.diagnostics.budget(), "writing the CSP semantics");
    csp_emit::Options options;
    options.core_properties = claims.core && (time == csp_emit::Time::timed || claims.times == Times::untimed);
    const csp_emit::Emission& emission =
        project.scripts
            .emplace(time, csp_emit::emit(project.system, project.instantiation, time, options, project.sources,
                                          project.diagnostics))
            .first->second;
    if (!project.diagnostics.ok()) return emission;
    if (!swarm_settings.file.empty()) {
        const csp_emit::Swarm swarm = swarm_of(swarm_settings, project.sources, project.diagnostics);
        if (!project.diagnostics.ok()) return emission;
        csp_emit::make_swarm(project.scripts.at(time), swarm, time, project.system, project.instantiation,
                             project.sources, project.diagnostics);
        if (!project.diagnostics.ok()) return emission;
    }
    if (!emission.captured.empty())
        throw std::logic_error(
            fmt::format("the script takes {} for something of the model's", fmt::join(emission.captured, ", ")));
    // Scripts that are written or checked must satisfy FDR's type rules. If a script contains no text of the user, a
    // finding is an internal error.
    csp_emit::check_script(emission, project.system, project.diagnostics);
    if (!project.diagnostics.ok() && project.system.csp_blocks.empty()) {
        diagnostics::TextStyle style;
        throw std::logic_error(fmt::format("the script does not type check:\n{}",
                                           diagnostics::render_text(project.sources, project.diagnostics, style)));
    }
    const bool claimed = time == csp_emit::Time::timed && swarm_settings.file.empty() && project.diagnostics.ok();
    if (claimed) add_claims(project, project.scripts.at(time));
    return emission;
}

namespace {

/// True if a RoboChart and a RoboSim component have this qualified name.
bool is_in_both_notations(const ir::System& system, const ir::ComponentRef& component) {
    return std::ranges::any_of(all_components(system), [&](const ir::ComponentRef& other) {
        return ir::qualified_name(other) == ir::qualified_name(component) &&
               ir::is_robosim(system, other) != ir::is_robosim(system, component);
    });
}

}  // namespace

std::string file_name(const Project& project, const ir::ComponentRef& component) {
    const bool shared = project.shared_names.contains(component.path) && !component.package.empty();
    std::string name = shared ? component.package + "_" + component.path : component.path;
    if (ir::is_robosim(project.system, component) && is_in_both_notations(project.system, component))
        name += "_robosim";
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    return name;
}

std::optional<diagnostics::SourceId> load_input(diagnostics::SourceManager& sources, const std::string& path,
                                                std::string& error) {
    if (path != "-") return sources.load_file(path, error);
    std::string text = diagnostics::standard_input(diagnostics::SourceManager::max_bytes, error);
    if (!error.empty()) return std::nullopt;
    return sources.add("standard input", std::move(text));
}

std::string files_inside(const std::string& folder, std::string_view ending) {
    std::vector<std::string> names;
    std::error_code code;
    fs::directory_iterator at(folder, code);
    for (const fs::directory_iterator end; !code && at != end; at.increment(code))
        if (const std::string name = at->path().filename().string(); name.ends_with(ending)) names.push_back(name);
    if (names.empty()) return "";
    std::ranges::sort(names);
    constexpr std::size_t few = 3;
    const std::size_t more = names.size() > few ? names.size() - few : 0;
    names.resize(names.size() - more);
    return fmt::format("; it has {}{}", fmt::join(names, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

namespace {

/// A component's name as a user writes it: `P::S`, `S`, or with its notation `robosim:P::S`, `robochart:S`.
struct GivenName {
    std::string name;
    std::optional<bool> robosim;  ///< no value: any notation
};

constexpr std::string_view robochart_prefix = "robochart:", robosim_prefix = "robosim:";

GivenName read_name(const std::string& text) {
    for (const std::string_view prefix : {robochart_prefix, robosim_prefix})
        if (text.starts_with(prefix) && text.substr(prefix.size(), 1) != ":")
            return {text.substr(prefix.size()), prefix == robosim_prefix};
    return {text, std::nullopt};
}

}  // namespace

std::vector<ir::ComponentRef> code_components(const ir::System& system, const std::string& name, bool robosim_too) {
    const GivenName given = read_name(name);
    std::vector<ir::ComponentRef> charts, robosim;
    for (const ir::ComponentRef& ref : all_components(system)) {
        const bool in_robosim = ir::is_robosim(system, ref);
        if ((in_robosim && !robosim_too) || (given.robosim && *given.robosim != in_robosim)) continue;
        std::vector<ir::ComponentRef>& list = in_robosim ? robosim : charts;
        const bool named = ref.path == given.name || ref.package + "::" + ref.path == given.name;
        if (given.name.empty() ? list.empty() || list.front().kind == ref.kind : named) list.push_back(ref);
    }
    charts.insert(charts.end(), robosim.begin(), robosim.end());
    return charts;
}

std::string component_name(const ir::System& system, const ir::ComponentRef& component) {
    const std::string_view prefix = ir::is_robosim(system, component) ? robosim_prefix : robochart_prefix;
    return fmt::format("{}{}", is_in_both_notations(system, component) ? prefix : "", ir::qualified_name(component));
}

namespace {

/// Checks that the component that the options name exists in some part. If it does not, the error is reported in the
/// first part.
void check_component(const std::vector<Part>& parts, const LoadSettings& settings) {
    const std::string& component = settings.component;
    std::vector<std::string> known;
    bool in_robosim = false;
    for (const Part& part : parts) {
        const ir::System& system = part.project->system;
        if (component.empty() || !code_components(system, component, settings.robosim).empty()) return;
        in_robosim = in_robosim || !code_components(system, component, true).empty();
        for (const ir::ComponentRef& ref : all_components(system))
            if (settings.robosim || !ir::is_robosim(system, ref)) known.push_back(ref.path);
    }
    if (in_robosim) {
        parts.front().project->diagnostics.report(
            rules::bad_option, {},
            {fmt::format("--component {}: it is written in RoboSim, and this command is built for RoboChart only",
                         component)});
        return;
    }
    const std::string meant = diagnostics::nearest_spelling(component, known);
    diagnostics::sort_unique(known);
    constexpr std::size_t few = 8;
    std::string help;
    if (!meant.empty())
        help = fmt::format("; did you mean '{}'?", meant);
    else if (known.empty())
        help = "; it has none";
    else if (known.size() <= few)
        help = fmt::format("; there are {}", fmt::join(known, ", "));
    parts.front().project->diagnostics.report(
        rules::bad_option, {},
        {fmt::format("--component {}: the model has no module, controller or state machine of this name{}", component,
                     help)});
}

}  // namespace

bool is_acceptable(const Project& project, const LoadSettings& settings) {
    return project.diagnostics.ok() && !(settings.deny_warnings && project.diagnostics.warning_count() > 0);
}

}  // namespace robochart::driver
