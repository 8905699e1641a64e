// SPDX-License-Identifier: Apache-2.0
// See claim_scripts.hpp.
#include "driver/model/claim_scripts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "csp_emit/assertion_forms.hpp"
#include "driver/model/project.hpp"
#include "driver/model/project_claims.hpp"

namespace robochart::driver {
namespace {

const csp_emit::ComponentProcesses& processes_of(const claims::CheckedClaim& claim,
                                                 const csp_emit::Emission& emission) {
    const auto found =
        std::ranges::find(emission.components, claim.component.path, &csp_emit::ComponentProcesses::path);
    if (found == emission.components.end()) throw claims::NotDecided(claim.component.path + " was not emitted");
    return *found;
}

ScriptedClaim make_script(const Project& project, const csp_emit::Emission& emission, std::size_t number) {
    const claims::CheckedClaim& claim = project.claims->checked.claims[number];
    if (claim.raised)
        throw claims::NotDecided(
            "an event is raised in a cycle, which the timed semantics does not have; `conform` compares cycles");
    ScriptedClaim result;
    result.letters = claims::letters_of(claim, project.system, project.instantiation);
    claims::require_channels(claim, result.letters, emission.provenance);
    const claims::Automaton automaton = claims::make_automaton(claim, result.letters, project.diagnostics.budget());
    result.decision =
        claims::decide_by_processes(claim, result.letters, automaton, number, processes_of(claim, emission).process,
                                    csp_emit::outputs_of(emission.provenance, claim.component.path));
    return result;
}

}  // namespace

std::optional<std::size_t> claim_of(const Project& project, const csp_emit::Obligation& obligation) {
    if (obligation.property != ir::no_id || !obligation.component.empty() || obligation.name.empty())
        return std::nullopt;
    const auto& claims = project.claims->checked.claims;
    const auto found = std::ranges::find(claims, obligation.name, &claims::CheckedClaim::name);
    if (found == claims.end()) return std::nullopt;
    return static_cast<std::size_t>(found - claims.begin());
}

void add_claims(Project& project, csp_emit::Emission& emission) {
    project.claims->scripted.clear();
    std::vector<cspm::DeclPtr>& script = emission.script.decls;
    if (!project.claims->checked.claims.empty()) script.push_back(claims::shared_channels());
    for (std::size_t number = 0; number < project.claims->checked.claims.size(); ++number) {
        const claims::CheckedClaim& claim = project.claims->checked.claims[number];
        csp_emit::Obligation obligation;
        obligation.kind = ir::PropertyKind::refines;
        obligation.name = claim.name;
        obligation.time = csp_emit::Time::timed;
        obligation.title = fmt::format("{} [timed] {}: {}", claim.name, claim.component.path, claim.wording);
        obligation.origin.span = claim.span;
        ScriptedClaim scripted;
        try {
            scripted = make_script(project, emission, number);
            const claims::Decision& decision = scripted.decision;
            script.insert(script.end(), decision.declarations.begin(), decision.declarations.end());
            for (const cspm::DeclPtr& assertion :
                 {decision.holds, decision.asked, decision.happens, decision.standstill})
                if (assertion) script.push_back(assertion);
            obligation.preparation = decision.declarations;
            obligation.assertions = {decision.holds};
            if (claim.body.kind == claims::BodyKind::possible)
                obligation.reason = fmt::format("no run of {} has it", claim.component.path);
        } catch (const claims::NotDecided& error) {
            obligation.reason = error.what();
        }
        project.claims->scripted.push_back(std::move(scripted));
        emission.obligations.push_back(std::move(obligation));
    }
}

}  // namespace robochart::driver
