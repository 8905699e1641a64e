// SPDX-License-Identifier: Apache-2.0
// See claim_files.hpp.
#include "driver/model/claim_files.hpp"
#include "driver/model/project_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "base/diagnostics/files.hpp"
#include "claims/checks/check.hpp"
#include "claims/checks/rules.hpp"
#include "claims/decide/letters.hpp"
#include "claims/syntax/reader.hpp"
#include "driver/model/instantiated_claims.hpp"
#include "driver/settings/instantiation_options.hpp"
#include "frontend/project/move_claims.hpp"
#include "frontend/project/project.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::driver {
namespace fs = std::filesystem;
namespace {

using claims::ClaimFile;

bool is_claims(const std::string& path) {
    return path.ends_with(".claims");
}

std::string folder_of(const std::string& path) {
    const fs::path parent = fs::path(path).parent_path();
    return parent.empty() ? "." : parent.string();
}

std::vector<std::string> models_in(const std::string& folder) {
    std::vector<std::string> result;
    for (const std::string& path : frontend::project_files(folder, false))
        if (path.ends_with(".rct")) result.push_back(fs::path(path).lexically_normal().string());
    return result;
}

std::vector<std::string> claims_in(const std::string& folder, bool deep) {
    std::vector<std::string> result;
    for (const std::string& path : diagnostics::files_below(folder, deep).files)
        if (is_claims(path)) result.push_back(fs::path(path).lexically_normal().string());
    return result;
}

std::set<std::string> packages_of(const frontend::Model& model) {
    std::set<std::string> result;
    for (const auto& file : model.files)
        if (!file->is_library) result.insert(file->package.text());
    return result;
}

std::set<std::string> declared_names(const frontend::Model& model) {
    std::set<std::string> result;
    for (const auto& file : model.files)
        if (!file->is_library)
            for (const auto& declaration : file->declarations) result.insert(declaration->name);
    return result;
}

/// True if the name, such as "warehouse::Warehouse::brain", contains a declared component.
bool mentions(const claims::Name& name, const std::set<std::string>& declared) {
    std::size_t from = 0;
    for (;;) {
        const std::size_t end = name.text.find("::", from);
        if (declared.contains(name.text.substr(from, end - from))) return true;
        if (end == std::string::npos) return false;
        from = end + 2;
    }
}

bool names_components(const ClaimFile& file) {
    return std::ranges::any_of(file.claims, [](const claims::Claim& claim) { return claim.component.has_value(); });
}

/// True if the file may be about this model. A file without imports and components may be about any model.
bool is_about(const ClaimFile& file, const frontend::Model& model) {
    const std::set<std::string> packages = packages_of(model);
    if (file.package && packages.contains(file.package->text)) return true;
    if (!file.imports.empty())
        return std::ranges::any_of(file.imports,
                                   [&](const claims::Import& import) { return packages.contains(import.name.text); });
    if (!names_components(file)) return true;
    const std::set<std::string> declared = declared_names(model);
    return std::ranges::any_of(file.claims, [&](const claims::Claim& claim) {
        return claim.component && mentions(*claim.component, declared);
    });
}

/// How the claims of a file are used.
enum class Use {
    named,   ///< the user names the file
    beside,  ///< the file is in the folder of the model, but may be about another model
    orders,  ///< the file is in the folder of a named file; only its unit and its orders are used
};

void add_file(Project& project, const std::string& path, Use use) {
    std::string error;
    const auto source = project.sources.load_file(path, error);
    if (!source) {
        if (!project.claims->ignored) project.diagnostics.report(frontend::syntax::unreadable, {}, {path, error});
        return;
    }
    diagnostics::Diagnostics findings;
    findings.set_budget(project.diagnostics.budget());
    ClaimFile file = claims::read(project.sources, *source, findings);
    if (use != Use::named && !is_about(file, *project.model)) return;
    if (!project.claims->ignored) project.diagnostics.add(findings);
    if (use == Use::orders) file.claims.clear();
    project.claims->files.push_back(std::make_shared<const ClaimFile>(std::move(file)));
}

}  // namespace

std::vector<std::string> model_inputs(const std::vector<std::string>& inputs) {
    std::vector<std::string> result;
    for (const std::string& input : inputs)
        if (!is_claims(input)) result.push_back(input);
    if (!result.empty()) return result;
    std::set<std::string> found, folders;
    for (const std::string& input : inputs) {
        std::vector<std::string> models = models_in(folder_of(input));
        if (models.empty()) models = models_in((fs::path(folder_of(input)) / "..").lexically_normal().string());
        found.insert(models.begin(), models.end());
        folders.insert(folder_of(input));
    }
    if (found.empty()) found = folders;  // the loader then reports that these folders contain no models
    result.assign(found.begin(), found.end());
    return result;
}

namespace {

/// Reads the claims in assertion files.
void read_claims_of_assertions(Project& project) {
    for (const auto& file : project.model->files) {
        std::vector<diagnostics::Span> places;
        for (const frontend::KeptPart& part : file->kept)
            if (frontend::is_claim(part)) places.push_back(part.whole);
        if (places.empty()) continue;
        ClaimFile read = claims::read_parts(project.sources, file->source, places, project.diagnostics);
        project.claims->files.push_back(std::make_shared<const ClaimFile>(std::move(read)));
    }
}

}  // namespace

void read_claim_files(Project& project, const LoadSettings& settings) {
    project.claims->ignored = settings.claims == ClaimUse::ignore;
    read_claims_of_assertions(project);
    for (const TextInput& input : settings.texts) {
        if (!is_claims(input.path)) continue;
        const diagnostics::SourceId source = project.sources.add(input.path, input.text);
        diagnostics::Diagnostics findings;
        project.claims->files.push_back(
            std::make_shared<const ClaimFile>(claims::read(project.sources, source, findings)));
        if (!project.claims->ignored) project.diagnostics.add(findings);
    }
    if (!settings.texts.empty()) return;
    std::set<std::string> seen;
    const auto add = [&](const std::string& path, Use use) {
        if (seen.insert(fs::path(path).lexically_normal().string()).second) add_file(project, path, use);
    };
    const bool only_claims = std::ranges::all_of(settings.inputs, is_claims);
    for (const std::string& input : settings.inputs) {
        std::error_code code;
        if (is_claims(input)) {
            add(input, Use::named);
        } else if (fs::is_directory(input, code)) {
            for (const std::string& path : claims_in(input, true)) add(path, Use::named);
        } else if (!only_claims && input.ends_with(".rct")) {
            for (const std::string& path : claims_in(folder_of(input), false)) add(path, Use::beside);
        }
    }
    if (!only_claims) return;
    for (const std::string& input : settings.inputs)
        for (const std::string& path : claims_in(folder_of(input), false)) add(path, Use::orders);
}

std::optional<claims::DeclaredUnit> unit_beside(const std::vector<std::string>& paths,
                                                diagnostics::SourceManager& sources,
                                                diagnostics::Diagnostics& diagnostics) {
    std::set<std::string> found;
    for (const std::string& path : paths) {
        std::error_code code;
        const bool folder = fs::is_directory(path, code);
        if (path == "-") continue;
        for (std::string& file : claims_in(folder ? path : folder_of(path), folder)) found.insert(std::move(file));
    }
    std::vector<std::shared_ptr<const ClaimFile>> files;
    for (const std::string& path : found) {
        std::string error;
        diagnostics::Diagnostics unreported;
        unreported.set_budget(diagnostics.budget());
        if (const auto source = sources.load_file(path, error))
            files.push_back(std::make_shared<const ClaimFile>(claims::read(sources, *source, unreported)));
    }
    return claims::find_unit(files, sources, diagnostics);
}

void read_ignored_claims(Project& project, const LoadSettings& settings) {
    if (settings.claims != ClaimUse::ignore || !project.diagnostics.ok()) return;
    LoadSettings reading = settings;
    reading.claims = ClaimUse::read;
    project.claims = make_project_claims();
    read_claim_files(project, reading);
    std::erase_if(project.claims->files, [&](const auto& file) { return !is_about(*file, *project.model); });
    check_claim_files(project, project.system);
    instantiate_claims(project, ir::Carriers::beyond);
}

void divide_claim_files(const std::vector<std::shared_ptr<const ClaimFile>>& files, const std::vector<Part>& parts) {
    for (const auto& file : files) {
        std::vector<Project*> about;
        for (const Part& part : parts)
            if (!part.again && is_about(*file, *part.project->model)) about.push_back(part.project.get());
        const bool many = about.size() > 1 && file->imports.empty() && !names_components(*file);
        const bool ignored = parts.front().project->claims->ignored;
        if (many && !ignored && !file->claims.empty())
            about.front()->diagnostics.report(claims::rules::unknown_component, file->claims.front().name.span,
                                              {"which model are these claims about? Write `import PACKAGE::*` before "
                                               "them, or `claim NAME of COMPONENT : ...`"});
        if (about.empty()) about.push_back(parts.front().project.get());
        for (Project* const project : about) project->claims->files.push_back(file);
    }
}

void find_unit(Project& project) {
    diagnostics::Diagnostics unreported;
    diagnostics::Diagnostics& findings = project.claims->ignored ? project.diagnostics : unreported;
    const auto unit = claims::find_unit(project.claims->files, project.sources, findings);
    if (!unit) return;
    project.unit = unit->nanoseconds;
    project.unit_place = unit->span;
}

std::vector<ClaimName> all_claims_of(const Project& project) {
    std::vector<ClaimName> result = claims_of(*project.model);
    for (const auto& file : project.claims->files)
        for (const claims::Claim& claim : file->claims) result.push_back({claim.name.text, claim.name.span});
    return result;
}

void check_claim_files(Project& project, const ir::System& system) {
    if (project.claims->files.empty() || project.claims->ignored) return;
    const std::set<std::string> packages = packages_of(*project.model);
    claims::ClaimedModel model{system, {packages.begin(), packages.end()}, {}};
    for (const ClaimName& claim : claims_of(*project.model)) model.names.push_back(claim.name);
    project.claims->checked = claims::check_claims(project.claims->files, model, project.sources, project.diagnostics);
}

namespace {

/// Expresses `can take E within D` as the assertion that the component never refuses E for D + 1 consecutive time
/// units.
ir::Property readiness(const claims::CheckedClaim& claim, const Project& project) {
    const claims::Component& component = claim.component;
    ir::Property result;
    result.name = claim.name;
    result.kind = ir::PropertyKind::event_missed;
    result.negated = true;
    result.untimed = false;
    result.subject.kind = ir::ComponentKind::machine;
    result.subject.package = component.package;
    result.subject.path = component.path;
    if (!component.package.empty()) result.subject.path.erase(0, component.package.size() + 2);
    result.subject.definition = component.machines.front().machine.index;
    result.event = component.channels[claim.body.events.any.front().channels.front()].name;
    if (claim.scope.condition) {
        const claims::Fact& fact = claim.facts[claim.scope.condition->index];
        result.state = project.system.machine(fact.of).nodes[fact.state->index].path;
    }
    result.time_units = claim.body.units.value_or(0) + 1;
    result.file = project.sources.path(claim.span.source);
    result.wording = fmt::format("{}: {}: {}", claim.name, component.path, claim.wording);
    result.origin = {component.path, claim.span};
    return result;
}

}  // namespace

namespace {

/// Returns a text such as "nat is 0..4 here; `--range` and `--const` choose values".
std::string values_text(const claims::EventMatch& match, const claims::CheckedClaim& claim, const Project& project) {
    std::map<std::string, std::string> ranges;  // key: the type
    for (const std::size_t channel : match.channels)
        for (const ir::TypeId id : claim.component.channels[channel].types) {
            const ir::Type& type = project.system.type(id);
            if (type.kind == ir::TypeKind::nat) ranges["nat"] = range_text(project.instantiation.nat);
            if (type.kind == ir::TypeKind::integer) ranges["int"] = range_text(project.instantiation.integer);
        }
    std::string result;
    for (const auto& [type, range] : ranges)
        result += fmt::format("{}{} is {}", result.empty() ? "" : ", ", type, range);
    return fmt::format("{}{}`--range` and `--const` choose values", result, result.empty() ? "" : " here; ");
}

/// Decides `can take` as an assertion.
void move_readiness(Project& project) {
    std::vector<claims::CheckedClaim>& all = project.claims->checked.claims;
    for (const claims::CheckedClaim& claim : all)
        if (claim.body.kind == claims::BodyKind::can_take && !has_own_project(project, claim))
            project.system.properties.push_back(readiness(claim, project));
    std::erase_if(all, [](const claims::CheckedClaim& claim) { return claim.body.kind == claims::BodyKind::can_take; });
}

/// Reports conditions that no value of the finite instantiation satisfies.
void check_values(const claims::CheckedClaim& claim, const Project& project, diagnostics::Diagnostics& diagnostics) {
    try {
        const auto letters = claims::letters_of(claim, project.system, project.instantiation, {});
        for (const claims::EventMatch* match : claims::matches_without_value(claim, letters))
            diagnostics.report(claims::rules::no_value, match->span,
                               {match->text, values_text(*match, claim, project)});
    } catch (const claims::NotDecided&) {
        // The answer to the claim gives the reason.
    } catch (const claims::NotComputable& error) {
        diagnostics.report(claims::rules::wrong_value, claim.span, {error.what()});
    }
}

}  // namespace

void check_claim_files(Project& project, ir::Carriers carriers) {
    check_claim_files(project, project.system);
    instantiate_claims(project, carriers);
    for (const InstantiatedClaims& instantiated : project.claims->instantiated) move_readiness(*instantiated.project);
    move_readiness(project);
    for (const claims::CheckedClaim& claim : project.claims->checked.claims)
        check_values(claim, project_of(project, claim), project.diagnostics);
}

}  // namespace robochart::driver
