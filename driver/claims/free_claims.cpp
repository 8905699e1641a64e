// SPDX-License-Identifier: Apache-2.0
#include "driver/claims/free_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/diagnostics/utf8.hpp"
#include "counterexample/text.hpp"
#include "driver/claims/causes.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::driver {

FreeData::FreeData(const Project& project, const Settings& settings, const ClassProject& classes)
    : project_(project),
      settings_(settings),
      classes_(classes),
      possible_(!keeps_carriers(project, settings) && ir::robosim_components(project.system).empty() &&
                ir::has_data(project.system)) {}

const FreeProject& FreeData::project() {
    if (!made_) made_ = free_project(project_, settings_, classes_);
    return *made_;
}

bool FreeData::comes_first() {
    const Project& decided = classes_.project ? *classes_.project : project_;
    if (!large_) large_ = ir::has_large_carriers(decided.system, decided.instantiation);
    return *large_ && project().has_large_carriers;
}

namespace {

/// True if the carriers limit the answer. Either the claim is undecided, or the basis of the answer contains a limit of
/// the carriers and no run proves the answer. An evaluation error is due to the carriers only if it is about a large
/// set. Other evaluation errors are faults of the model.
bool is_limited_by_carriers(const AssertionReport& one) {
    if (one.answer == Answer::inconclusive) return true;
    if (one.answer == Answer::error) return is_about_large_set(one.reason);
    const bool decided = one.answer == Answer::holds || (one.answer == Answer::fails && !one.run);
    return decided && std::ranges::any_of(one.basis, [](const Ground& ground) {
               return ground.kind == GroundKind::bound || ground.kind == GroundKind::carriers;
           });
}

/// Returns a turn with the fraction 1 / `parts` of the remaining time of the given turn. If the given turn ends only
/// with the run, its remaining time is taken as forty seconds.
Turn part_of(const Turn& turn, int parts) {
    constexpr std::chrono::seconds usual{40};
    Turn result = turn;
    const auto now = std::chrono::steady_clock::now();
    result.ends = now + (turn.ends ? (*turn.ends - now) / parts : usual / parts);
    return result;
}

/// True if some answer with free data would also apply to the model.
bool may_carry_over(const csp_emit::Obligation& obligation) {
    return carries_over(obligation, Answer::holds) || carries_over(obligation, Answer::fails);
}

std::string reason_of(const FreeProject& free) {
    if (free.conditions == 0) return "for all values, whatever is computed from them";
    return fmt::format("for all values: {} condition{} on data may have either answer", free.conditions,
                       free.conditions == 1 ? "" : "s");
}

/// The inputs and outputs of a run with free data. A class of values is shown as one of its values.
std::string example_of(const runs::Run& run) {
    constexpr std::size_t longest = 300;
    const std::string text = runs::short_text_of(run);
    if (text.empty()) return "";
    return fmt::format(", for example after {}{}", diagnostics::beginning_of(text, longest),
                       text.size() > longest ? "..." : "");
}

}  // namespace

void FreeClaims::add_to(std::vector<WaitingClaim>& claims) {
    for (const ListedClaim& claim : own_.claims())
        claims.push_back(
            TimeClaims::waiting(claim, [this, claim](const Turn& turn) { return decide_in(turn, claim); }));
}

/// If carriers may limit the answer, first uses a part of the turn with carriers, then a part with free data, then the
/// rest with carriers.
bool FreeClaims::decide_in(const Turn& turn, const ListedClaim& claim) {
    const csp_emit::Obligation& obligation = *claim.obligation;
    const bool whole = search_.services.continues_searches();  // a search in files is not ended and restarted
    if (whole || !may_carry_over(obligation) || !data_.may_exist() || tried_.contains(obligation.title))
        return own_.store(decide_alone(turn, claim), claim);
    const bool first = data_.comes_first();
    AssertionReport one = first ? own_.undecided(claim) : decide_alone(part_of(turn, 20), claim);
    if (first || is_limited_by_carriers(one)) {
        if (answer(part_of(turn, 4), obligation, one)) {
            if (!search_.settings.claims.certificates.empty() && one.answer == Answer::holds)
                one.certificate = {{}, "it was decided for free values of computed data"};
            return own_.store(std::move(one), claim);
        }
        if (first || (one.answer == Answer::inconclusive && !turn.is_over())) one = decide_alone(turn, claim);
    }
    return own_.store(std::move(one), claim);
}

AssertionReport FreeClaims::decide_alone(const Turn& turn, const ListedClaim& claim) {
    AssertionReport one = own_.decide(turn, claim);
    const auto tried = tried_.find(claim.obligation->title);
    if (one.answer == Answer::inconclusive && tried != tried_.end() && tried->second.answer == Answer::fails)
        one.reason += fmt::format("; with free values of computed data it fails{}, which may not be a run of the model",
                                  tried->second.run);
    return one;
}

bool FreeClaims::answer(const Turn& turn, const csp_emit::Obligation& obligation, AssertionReport& report) {
    Tried& tried = tried_[obligation.title];
    const auto claim = free_claim(obligation);
    if (!claim) return false;
    AssertionReport known = free_->decide(turn, *claim);
    tried.answer = known.answer;
    if (known.run) tried.run = example_of(*known.run);
    if (known.answer != Answer::holds && known.answer != Answer::fails) return false;
    if (!carries_over(obligation, known.answer)) return false;
    report.answer = known.answer;
    report.reason = known.answer == Answer::holds ? reason_of(data_.project()) : known.reason;
    report.basis = std::move(known.basis);
    // the free model may terminate in runs that the model does not have
    std::erase_if(report.basis, [](const Ground& ground) {
        return ground.kind == GroundKind::ended || ground.kind == GroundKind::time_stops;
    });
    report.statistics = known.statistics;
    report.searched = known.searched;
    report.run.reset();
    if (report.core && known.core) report.core->unexercised = known.core->unexercised;
    return true;
}

/// Returns the same claim in the list with free data; no value if it cannot be decided with free data.
std::optional<ListedClaim> FreeClaims::free_claim(const csp_emit::Obligation& obligation) {
    if (!data_.project().project) return std::nullopt;
    if (!free_)
        free_ = std::make_unique<TimeClaims>(
            *data_.project().project,
            emit_csp(*data_.project().project, search_.settings.claims, search_.settings.swarm, time_), search_, time_,
            may_carry_over, Values::of_project, results_);
    const auto title = [](const ListedClaim& claim) -> const std::string& { return claim.obligation->title; };
    if (std::ranges::count(free_->claims(), obligation.title, title) != 1) return std::nullopt;
    return *std::ranges::find(free_->claims(), obligation.title, title);
}

}  // namespace robochart::driver
