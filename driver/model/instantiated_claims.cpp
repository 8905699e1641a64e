// SPDX-License-Identifier: Apache-2.0
// See instantiated_claims.hpp.
#include "driver/model/instantiated_claims.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <set>

#include "base/diagnostics/diagnostic.hpp"
#include "claims/checks/rules.hpp"
#include "driver/model/project_claims.hpp"
#include "driver/settings/instantiation_options.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::driver {
namespace {

using claims::CheckedClaim;

const InstantiatedClaims* find_project(const Project& project, const CheckedClaim& claim) {
    const auto& all = project.claims->instantiated;
    const auto found = std::ranges::find(all, claim.settings, &InstantiatedClaims::settings);
    return found == all.end() ? nullptr : &*found;
}

/// The claims of a project with these constants, and the assumptions, which are about all constants.
claims::CheckedClaims claims_with(const Project& project, const std::vector<std::string>& settings) {
    claims::CheckedClaims result = project.claims->checked;
    std::erase_if(result.claims,
                  [&](const CheckedClaim& claim) { return !claim.assumption && claim.settings != settings; });
    return result;
}

/// The system without the assertions and CSP blocks, which are decided with the constants of the model.
ir::System without_assertions(ir::System system) {
    system.properties.clear();
    system.csp_blocks.clear();
    return system;
}

std::shared_ptr<Project> make_project(Project& project, const CheckedClaim& claim, ir::Carriers carriers) {
    diagnostics::Diagnostics found;
    found.set_budget(project.diagnostics.budget());
    ir::Instantiation instantiation =
        ir::instantiate_system(project.system, project.asked, found, carriers, claim.constants);
    project.diagnostics.add(found.ok() ? found.findings_in_texts({claim.span.source}) : found);
    std::shared_ptr<Project> result = with_data(project, without_assertions(project.system), std::move(instantiation));
    result->asked = project.asked;
    result->claims->settings = claim.settings;
    result->claims->checked = claims_with(project, claim.settings);
    return result;
}

/// Calls the function with the values of the constants of each machine and operation, in each of its contexts.
void for_each_context(const ir::System& system, const ir::Instantiation& instantiation,
                      const std::function<void(std::vector<ir::Value>)>& use) {
    const auto parts = [&](const ir::Module* module, const ir::Controller& controller) {
        for (const ir::MachineInstance& part : controller.machines)
            use(ir::constant_values(system, instantiation, module, &controller, part.name,
                                    system.machine(part.machine)));
        for (std::size_t i = 0; i < controller.definitions.size(); ++i)
            use(ir::constant_values(system, instantiation, module, &controller, controller.definition_names[i],
                                    system.machine(controller.definitions[i])));
    };
    for (const ir::Machine& machine : system.machines)
        use(ir::constant_values(system, instantiation, nullptr, nullptr, "", machine));
    for (const ir::Controller& controller : system.controllers) parts(nullptr, controller);
    for (const ir::Module& module : system.modules)
        for (const ir::ControllerInstance& instance : module.controllers)
            parts(&module, system.controller(instance.controller));
}

/// Reals are compared only if they have the same scale, so that instantiations with equal values may count as
/// different.
bool has_same_constants(const ir::System& system, const ir::Instantiation& one, const ir::Instantiation& other) {
    if (one.scale != other.scale) return false;
    const auto values_of = [&](const ir::Instantiation& instantiation) {
        std::vector<std::vector<ir::Value>> values;
        for_each_context(system, instantiation,
                         [&](std::vector<ir::Value> of_context) { values.push_back(std::move(of_context)); });
        return values;
    };
    return values_of(one) == values_of(other);
}

/// The instantiation of the project with the values for which a run was made.
ir::Instantiation instantiation_with(const Project& project, const std::vector<std::string>& weaker) {
    std::string error;
    ir::InstantiationOptions options = project.asked;
    options.constants.merge(
        ir::not_overridden(project.system, given_constants(weaker, error), project.asked.constants));
    diagnostics::Diagnostics found;
    found.set_budget(project.diagnostics.budget());
    return ir::instantiate_system(project.system, options, found);
}

}  // namespace

void instantiate_claims(Project& project, ir::Carriers carriers) {
    project.claims->instantiated.clear();
    const bool block = std::ranges::any_of(project.system.csp_blocks, ir::is_instantiations);
    for (const CheckedClaim& claim : project.claims->checked.claims) {
        if (claim.settings.empty() || find_project(project, claim) != nullptr) continue;
        if (block)
            project.diagnostics.report(
                claims::rules::wrong_form, claim.span,
                {"a csp block `Instantiations` defines the constants of the model, so a claim cannot set them"});
        else
            project.claims->instantiated.push_back({claim.settings, make_project(project, claim, carriers)});
    }
}

bool has_own_project(const Project& project, const CheckedClaim& claim) {
    return !claim.assumption && claim.settings != project.claims->settings;
}

Project& project_of(Project& project, const CheckedClaim& claim) {
    const InstantiatedClaims* const found = has_own_project(project, claim) ? find_project(project, claim) : nullptr;
    return found == nullptr ? project : *found->project;
}

std::string why_other_constants(const Project& project, const CheckedClaim& claim,
                                const std::vector<std::string>& weaker) {
    if (!has_own_project(project, claim)) return "";
    const InstantiatedClaims* const own = find_project(project, claim);
    const auto has_values_of_claim = [&](const ir::Instantiation& instantiation) {
        return own != nullptr && has_same_constants(project.system, instantiation, own->project->instantiation);
    };
    if (has_values_of_claim(weaker.empty() ? project.instantiation : instantiation_with(project, weaker))) return "";
    return fmt::format("it sets {}, and other values are used here: `--const {}` gives the same values",
                       fmt::join(claim.settings, ", "), fmt::join(claim.settings, " --const "));
}

}  // namespace robochart::driver
