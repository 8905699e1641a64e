// SPDX-License-Identifier: Apache-2.0
// See claim_scripts.hpp.
#include "driver/model/claim_scripts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "base/diagnostics/render.hpp"
#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/assertion_forms.hpp"
#include "csp_emit/blocks/check_script.hpp"
#include "csp_emit/showing.hpp"
#include "driver/model/instantiated_claims.hpp"
#include "driver/model/project.hpp"
#include "driver/model/project_claims.hpp"

namespace robochart::driver {
namespace {

namespace build = cspm::build;
using claims::CheckedClaim;

/// The largest number of facts that one machine shows. A machine shows all its facts by one event, so the event has two
/// to the power of this number values.
constexpr std::size_t most_facts = 6;

const csp_emit::ComponentProcesses& processes_of(const CheckedClaim& claim, const csp_emit::Emission& emission) {
    const auto found =
        std::ranges::find(emission.components, claim.component.path, &csp_emit::ComponentProcesses::path);
    if (found == emission.components.end()) throw claims::NotDecided(claim.component.path + " was not emitted");
    return *found;
}

/// Adds the claims to a script.
class ClaimScript {
public:
    /// `showing` is null for the script without shown facts.
    ClaimScript(Project& project, csp_emit::Emission& emission, const ShowingScript* showing)
        : project_(project), emission_(emission), showing_(showing) {}

    void add_all() {
        const std::vector<CheckedClaim>& all = project_.claims->checked.claims;
        project_.claims->scripted.resize(all.size());
        if (!all.empty()) emission_.script.decls.push_back(claims::shared_channels());
        for (std::size_t number = 0; number < all.size(); ++number)
            if (!all[number].assumption && (showing_ == nullptr || showing_->claims.contains(all[number].name)))
                add(number);
    }

private:
    void add(std::size_t number) {
        const CheckedClaim& claim = project_.claims->checked.claims[number];
        csp_emit::Obligation obligation;
        obligation.kind = ir::PropertyKind::refines;
        obligation.name = claim.name;
        obligation.time = csp_emit::Time::timed;
        obligation.title = fmt::format("{} [timed] {}: {}", claim.name, claim.component.path, claim.wording);
        obligation.origin.span = claim.span;
        if (!has_own_project(project_, claim)) script_if_decided_here(number, obligation);
        emission_.obligations.push_back(std::move(obligation));
    }

    void script_if_decided_here(std::size_t number, csp_emit::Obligation& obligation) {
        const CheckedClaim& claim = project_.claims->checked.claims[number];
        try {
            if (showing_ == nullptr) claims::require_facts(claim, project_.system, project_.instantiation);
            if (showing_ != nullptr || claim.facts.empty()) script(number, obligation);
        } catch (const claims::NotDecided& error) {
            obligation.reason = error.what();
        }
    }

    void script(std::size_t number, csp_emit::Obligation& obligation) {
        const CheckedClaim& claim = project_.claims->checked.claims[number];
        ScriptedClaim scripted = make_script(claim, number, obligation);
        const claims::Decision& decision = scripted.decision;
        std::vector<cspm::DeclPtr>& decls = emission_.script.decls;
        decls.insert(decls.end(), decision.declarations.begin(), decision.declarations.end());
        for (const cspm::DeclPtr& assertion : {decision.holds, decision.asked, decision.happens, decision.standstill})
            if (assertion) decls.push_back(assertion);
        obligation.preparation.insert(obligation.preparation.end(), decision.declarations.begin(),
                                      decision.declarations.end());
        obligation.assertions = {decision.holds};
        if (claim.body.kind == claims::BodyKind::possible)
            obligation.reason = fmt::format("no run of {} has it", claim.component.path);
        project_.claims->scripted[number] = std::move(scripted);
    }

    ScriptedClaim make_script(const CheckedClaim& claim, std::size_t number, csp_emit::Obligation& obligation) {
        if (claim.raised) throw claims::NotDecided("it is about control cycles, which `conform` decides");
        ScriptedClaim result;
        result.letters = letters_of(claim);
        cspm::ExprPtr process = processes_of(claim, emission_).process;
        result.exact = sees_exactly(claim);
        std::vector<cspm::ExprPtr> outputs = csp_emit::outputs_of(emission_.provenance, claim.component.path);
        std::ranges::copy(claims::channels_of_facts(claim), std::back_inserter(outputs));
        process = with_assumptions(claim, process, outputs, result.letters, obligation);
        result.decision = claims::decide_by_processes(
            claim, result.letters, claims::make_automaton(claim, result.letters, project_.diagnostics.budget()), number,
            process, outputs);
        return result;
    }

    [[nodiscard]] std::vector<claims::Letter> letters_of(const CheckedClaim& claim) const {
        std::vector<claims::Letter> letters =
            claims::letters_of(claim, project_.system, project_.instantiation,
                               showing_ == nullptr ? claims::ShownFacts{} : showing_->shown);
        claims::require_channels(claim, letters, emission_.provenance);
        return letters;
    }

    /// True if the claim reads its facts without delay. If there are several machines, another machine may act after a
    /// step of a machine and before the machine shows its facts. This delay does not affect claims about what holds
    /// whenever time passes, nor claims about the facts of a single machine.
    [[nodiscard]] static bool sees_exactly(const CheckedClaim& claim) {
        if (claim.facts.empty() || claim.component.machines.size() == 1) return true;
        const bool whole = claim.scope.kind == claims::ScopeKind::whole;
        if (whole && claim.body.kind == claims::BodyKind::always) return true;
        const bool one = std::ranges::all_of(
            claim.facts, [&](const claims::Fact& fact) { return fact.machine == claim.facts.front().machine; });
        const auto sets = claims::sets_of(claim);
        const bool events = std::ranges::any_of(sets, [](const claims::Events* set) {
            return std::ranges::any_of(set->any,
                                       [](const claims::EventMatch& match) { return !match.channels.empty(); });
        });
        return one && !events;
    }

    /// Returns the component in parallel with the assumptions about it. An assumption refuses every event that breaks
    /// it, but must not stop time. A response that an assumption demands is an output of the environment, which is
    /// accepted at once like other outputs.
    cspm::ExprPtr with_assumptions(const CheckedClaim& claim, cspm::ExprPtr process,
                                   std::vector<cspm::ExprPtr>& outputs, std::vector<claims::Letter>& letters,
                                   csp_emit::Obligation& obligation) {
        std::vector<std::string> names, places;
        std::vector<claims::Assumed::Due> due;
        const std::vector<CheckedClaim>& all = project_.claims->checked.claims;
        for (std::size_t number = 0; number < all.size(); ++number) {
            const CheckedClaim& assumed = all[number];
            if (!assumed.assumption || assumed.component.path != claim.component.path) continue;
            names.push_back(assumed.name);
            places.push_back(fmt::format("{} ({})", assumed.name, project_.sources.path_and_line(assumed.span)));
            const claims::Assumed made = make_assumption(number, std::move(process), due);
            process = made.process;
            due.insert(due.end(), made.due.begin(), made.due.end());
        }
        if (names.empty()) return process;
        for (const claims::Assumed::Due& answer : due) {
            outputs.push_back(build::name(answer.due));
            add_name(answer, letters);
        }
        cspm::ExprPtr running = csp_emit::running_on(process, "tock");
        if (!outputs.empty()) running = build::hide(running, build::productions(outputs));
        csp_emit::Premise premise;
        premise.assertions = {csp_emit::timelock_free(running)};
        emission_.script.decls.push_back(premise.assertions.front());
        premise.text = fmt::format("time can pass under {}", fmt::join(names, " and "));
        premise.otherwise = fmt::format("{} would stop time", fmt::join(places, " and "));
        premise.reason = "an input that the assumption demands cannot be taken here";
        obligation.premise = std::make_shared<const csp_emit::Premise>(std::move(premise));
        return process;
    }

    claims::Assumed make_assumption(std::size_t number, cspm::ExprPtr process,
                                    const std::vector<claims::Assumed::Due>& earlier) {
        const CheckedClaim& assumed = project_.claims->checked.claims[number];
        std::vector<claims::Letter> letters = letters_of(assumed);
        for (const claims::Assumed::Due& due : earlier) add_name(due, letters);
        claims::Assumed made = claims::assume_by_processes(
            assumed, letters, claims::make_automaton(assumed, letters, project_.diagnostics.budget()), number,
            std::move(process));
        if (assumed_.insert(number).second)
            emission_.script.decls.insert(emission_.script.decls.end(), made.declarations.begin(),
                                          made.declarations.end());
        return made;
    }

    /// Adds the second name of a demanded response. Claims, later assumptions and reports treat both names as one
    /// event.
    void add_name(const claims::Assumed::Due& due, std::vector<claims::Letter>& letters) {
        if (const auto known = emission_.provenance.events.find(due.event); known != emission_.provenance.events.end())
            emission_.provenance.events.emplace(due.due, csp_emit::EventMeaning(known->second));
        for (claims::Letter& letter : letters)
            if (std::ranges::find(letter.events, due.event) != letter.events.end()) {
                letter.events.push_back(due.due);
                letter.prefixes.push_back(build::name(due.due));
            }
    }

    Project& project_;
    csp_emit::Emission& emission_;
    const ShowingScript* showing_;
    std::set<std::size_t> assumed_;  ///< the assumptions whose processes are in the script
};

/// True if the script may show the facts of this claim in addition.
bool may_take(const claims::ShownFacts& shown, const CheckedClaim& claim) {
    claims::ShownFacts both = shown;
    claims::add_facts(claim, both);
    return std::ranges::all_of(both, [](const auto& facts) { return facts.second.size() <= most_facts; });
}

bool is_translatable(const Project& project, const CheckedClaim& claim) {
    try {
        claims::require_facts(claim, project.system, project.instantiation);
        return true;
    } catch (const claims::NotDecided&) {
        return false;
    }
}

/// Divides the claims that read facts among scripts, so that no machine shows too many facts in one script.
std::vector<ShowingScript> divide_claims(const Project& project) {
    std::vector<ShowingScript> result;
    for (const CheckedClaim& claim : project.claims->checked.claims) {
        if (claim.facts.empty() || claim.assumption || has_own_project(project, claim)) continue;
        if (!is_translatable(project, claim)) continue;
        if (result.empty() || !may_take(result.back().shown, claim)) result.emplace_back();
        result.back().claims.insert(claim.name);
        claims::add_facts(claim, result.back().shown);
    }
    return result;
}

void emit_showing(Project& project, ShowingScript& script) {
    const csp_emit::Shown shown = claims::emitted_facts(script.shown, project.system, project.instantiation);
    diagnostics::Diagnostics findings;  // findings about the model are reported with the other script
    findings.set_budget(project.diagnostics.budget());
    script.emission = std::make_unique<csp_emit::Emission>(
        csp_emit::emit_showing(project.system, project.instantiation, shown, project.sources, findings));
    csp_emit::check_script(*script.emission, project.system, findings);
    if (!findings.ok() && project.system.csp_blocks.empty())
        throw std::logic_error("the script of claims about states does not type check:\n" +
                               diagnostics::render_text(project.sources, findings));
    script.emission->obligations.clear();
    ClaimScript(project, *script.emission, &script).add_all();
}

}  // namespace

std::optional<std::size_t> claim_of(const Project& project, const csp_emit::Obligation& obligation) {
    if (obligation.property != ir::no_id || !obligation.component.empty() || obligation.name.empty())
        return std::nullopt;
    const auto& claims = project.claims->checked.claims;
    const auto found = std::ranges::find(claims, obligation.name, &CheckedClaim::name);
    if (found == claims.end()) return std::nullopt;
    return static_cast<std::size_t>(found - claims.begin());
}

bool is_in_other_script(const Project& project, const csp_emit::Obligation& obligation) {
    const auto number = claim_of(project, obligation);
    if (!number) return false;
    const CheckedClaim& claim = project.claims->checked.claims[*number];
    return has_own_project(project, claim) || (!claim.facts.empty() && obligation.reason.empty());
}

const std::vector<ShowingScript>& showing_scripts(Project& project) {
    std::vector<ShowingScript>& scripts = project.claims->showing;
    if (!scripts.empty()) return scripts;
    scripts = divide_claims(project);
    for (ShowingScript& script : scripts) emit_showing(project, script);
    return scripts;
}

void add_claims(Project& project, csp_emit::Emission& emission) {
    ClaimScript(project, emission, nullptr).add_all();
}

}  // namespace robochart::driver
