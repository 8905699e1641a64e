// SPDX-License-Identifier: Apache-2.0
#include "driver/claims/model_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "base/diagnostics/escape.hpp"
#include "driver/claims/class_project.hpp"
#include "driver/claims/free_claims.hpp"
#include "driver/claims/kept_text.hpp"
#include "driver/claims/probability_claims.hpp"
#include "driver/claims/time_claims.hpp"
#include "driver/model/claim_scripts.hpp"
#include "driver/model/preferences.hpp"
#include "driver/model/project_claims.hpp"

namespace robochart::driver {
namespace {

using csp_emit::Time;

/// Lists the claims that only other tools can check. They are not reported as successes.
void report_unchecked(const Project& project, const SearchContext& search, ClaimResults& results) {
    const auto unchecked = [&](const std::string& name, diagnostics::Span span, const std::string& why) {
        if (!is_selected(search.settings.claims, name)) return;
        AssertionReport one;
        one.title = project.label + name;
        one.name = name;
        set_place(project.sources, span, one);
        one.answer = Answer::unchecked;
        one.reason = fmt::format("{}: not checked: {}", diagnostics::escape_for_display(one.place), why);
        const auto edit = search.services.edit();
        results.assertions.push_back(std::move(one));
    };
    for (const auto& file : project.model->files)
        for (const frontend::KeptPart& part : file->kept)
            if (part.claims) unchecked(part.name, part.span, fmt::format("`{}` is for another tool", part.form));
}

/// The claims of one semantics, as indices in the results, if two projects decide them.
struct DividedClaims {
    Time time;
    std::size_t first, end;
};

/// Sorts these claims in the order of the project's script.
void order_claims(const Project& project, const csp_emit::Emission& emission, const DividedClaims& divided,
                  std::vector<AssertionReport>& assertions) {
    std::map<std::string, std::size_t> order;
    for (const csp_emit::Obligation& obligation : emission.obligations)
        order.emplace(project.label + obligation.title, order.size());
    const auto at = assertions.begin();
    std::ranges::stable_sort(at + static_cast<std::ptrdiff_t>(divided.first),
                             at + static_cast<std::ptrdiff_t>(divided.end), {}, [&](const AssertionReport& one) {
                                 const auto found = order.find(one.title);
                                 return found == order.end() ? order.size() : found->second;
                             });
}

/// Adds the claims of a list. They are decided only in this list, not with free data.
void add_claims(TimeClaims& list, std::vector<WaitingClaim>& claims) {
    for (const ListedClaim& claim : list.claims())
        claims.push_back(TimeClaims::waiting(
            claim, [&list, claim](const Turn& turn) { return list.store(list.decide(turn, claim), claim); }));
}

using Lists = std::vector<std::unique_ptr<TimeClaims>>;

/// Lists the claims of claims files that are not decided in the script of the project: those that read states and
/// variables, and those that set constants.
class OtherScripts {
public:
    OtherScripts(const SearchContext& search, const ClassProject& classes, Lists& lists,
                 std::vector<WaitingClaim>& claims, ClaimResults& results)
        : search_(search), classes_(classes), lists_(lists), claims_(claims), results_(results) {}

    void add_all(Project& project) {
        add_showing(project);
        for (const InstantiatedClaims& instantiated : project.claims->instantiated) {
            Project& own = *instantiated.project;
            own.label = project.label;
            own.diagnostics.set_budget(project.diagnostics.budget());
            own.instantiation.budget = project.instantiation.budget;
            ClaimSettings settings = search_.settings.claims;
            settings.core = false;
            const csp_emit::Emission& script = emit_csp(own, settings, {}, Time::timed);
            if (!own.diagnostics.ok()) project.diagnostics.add(own.diagnostics);
            add(own, script, classes_.project ? Values::of_carriers : Values::of_project,
                [&own](const csp_emit::Obligation& obligation) { return !is_in_other_script(own, obligation); });
            lists_.back()->write_certificates();
            add_showing(own);
        }
    }

private:
    void add_showing(Project& project) {
        for (const ShowingScript& script : showing_scripts(project))
            add(project, *script.emission, Values::of_project, [](const csp_emit::Obligation&) { return true; });
    }
    void add(Project& project, const csp_emit::Emission& script, Values values, ClaimFilter takes) {
        lists_.push_back(
            std::make_unique<TimeClaims>(project, script, search_, Time::timed, std::move(takes), values, results_));
        add_claims(*lists_.back(), claims_);
    }

    const SearchContext& search_;
    const ClassProject& classes_;
    Lists& lists_;
    std::vector<WaitingClaim>& claims_;
    ClaimResults& results_;
};

/// Adds to probabilistic claims that they are decided for the values of carriers, because a class of values has no
/// probability. Called only if the report also lists data that classes replace in other claims. `first` is the index of
/// the first claim of the project.
void note_carriers_of_probabilities(const SearchContext& search, std::size_t first, ClaimResults& results) {
    const auto edit = search.services.edit();
    for (std::size_t i = first; i < results.assertions.size(); ++i) {
        AssertionReport& one = results.assertions[i];
        if (!one.probability) continue;
        if (one.answer == Answer::holds || one.answer == Answer::fails || one.answer == Answer::computed)
            add(one.basis, {GroundKind::carriers,
                            "probabilities are those of the values of the finite instantiation",
                            {},
                            {},
                            {},
                            {}});
    }
}

}  // namespace

void check_assertions(Project& project, const SearchContext& search, ClaimResults& results) {
    // A preferences file that cannot be read is an error even if no claim needs it.
    auto preferences = read_preferences(project, search.settings.probability);
    if (!preferences) return;
    std::vector<WaitingClaim> claims;
    const std::size_t first_claim = results.assertions.size();
    std::unique_ptr<ProbabilityClaims> probabilities;
    if (search.settings.swarm.file.empty()) {
        probabilities = std::make_unique<ProbabilityClaims>(project, search, std::move(*preferences), results);
        report_unchecked(project, search, results);
    }
    const ClassProject classes = class_project(project, search.settings);
    Project& decided = classes.project ? *classes.project : project;
    for (const ir::KeptData& data : classes.kept) results.kept_data.push_back(described(project.sources, data));
    FreeData free_data(project, search.settings, classes);
    Lists times, others;
    std::vector<std::unique_ptr<FreeClaims>> free;
    std::vector<DividedClaims> divided;
    bool uses_classes = false;
    for (const Time time : {Time::untimed, Time::timed}) {
        if (!includes_time(search.settings.claims.times, time) || !project.diagnostics.ok() ||
            !decided.diagnostics.ok())
            continue;
        const auto add = [&](Project& of, Values values) {
            const auto takes = [&classes, &of, values](const csp_emit::Obligation& obligation) {
                return !is_in_other_script(of, obligation) &&
                       is_decided_in_carriers(classes, of.system, obligation) == (values == Values::of_carriers);
            };
            const csp_emit::Emission& script = emit_csp(of, search.settings.claims, search.settings.swarm, time);
            times.push_back(std::make_unique<TimeClaims>(of, script, search, time, takes, values, results));
            times.back()->write_certificates();
        };
        const std::size_t first = results.assertions.size(), lists = times.size() + others.size();
        add(decided, Values::of_project);
        uses_classes = uses_classes || (classes.project && !times.back()->claims().empty());
        free.push_back(std::make_unique<FreeClaims>(*times.back(), free_data, search, time));
        free.back()->add_to(claims);
        const bool open = !(decided.outputs_replaced.empty() && decided.related.empty());
        const bool in_carriers = classes.project && (has_observers(project) || (classes.small_carriers && open));
        if (in_carriers) {
            add(project, Values::of_carriers);
            add_claims(*times.back(), claims);
        }
        if (time == Time::timed && search.settings.swarm.file.empty())
            OtherScripts(search, classes, others, claims, results).add_all(project);
        if (times.size() + others.size() > lists + 1) divided.push_back({time, first, results.assertions.size()});
    }
    if (&decided != &project) project.diagnostics.add(decided.diagnostics);
    if (uses_classes) results.data.insert(results.data.end(), classes.data.begin(), classes.data.end());
    if (probabilities) probabilities->add_to(claims);
    if (!project.diagnostics.ok()) return;
    decide_in_turns(claims, search, [&] {
        for (const Lists* const lists : {&times, &others})
            for (const auto& list : *lists) list->give_back();
        for (const auto& claims_of_time : free) claims_of_time->give_back();
        if (probabilities) probabilities->give_back();
    });
    if (uses_classes) note_carriers_of_probabilities(search, first_claim, results);
    for (const auto& time : times) time->measure_if_asked();
    for (const DividedClaims& claims_of_time : divided)
        order_claims(project, emit_csp(project, search.settings.claims, search.settings.swarm, claims_of_time.time),
                     claims_of_time, results.assertions);
}

}  // namespace robochart::driver
