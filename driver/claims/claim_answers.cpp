// SPDX-License-Identifier: Apache-2.0
// See claim_answers.hpp.
#include "driver/claims/claim_answers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "checker/lts/transition_system.hpp"
#include "checker/refine/verdict/verdict.hpp"
#include "claims/monitor/account.hpp"
#include "claims/sleec/conformance/endless.hpp"
#include "driver/model/project_claims.hpp"
#include "driver/rules/endless_counterexample.hpp"

namespace robochart::driver {
namespace {

class Answerer {
public:
    Answerer(const Project& project, const runs::Context& context, const SearchContext& search,
             const csp_emit::Obligation& obligation, std::size_t claim, AssertionReport& report)
        : project_(project),
          context_(context),
          search_(search),
          obligation_(obligation),
          report_(report),
          claim_(project.claims->checked.claims.at(claim)),
          scripted_(project.claims->scripted.at(claim)) {}

    void complete() {
        if (report_.answer == Answer::fails && report_.run) explain(*report_.run);
        complete_positive();
        const bool possible = claim_.body.kind == claims::BodyKind::possible;
        if (scripted_.exact || report_.answer != (possible ? Answer::holds : Answer::fails)) return;
        report_.answer = Answer::inconclusive;
        report_.reason =
            "not decided: a run was found, but another machine may have acted in it before the state was seen; a claim "
            "about the machine alone decides it";
    }

private:
    void complete_positive() {
        if (report_.answer != Answer::holds) return;
        if (scripted_.decision.standstill) decide_standstill();
        if (report_.answer == Answer::holds && scripted_.decision.waiting) decide_waiting();
        if (report_.answer == Answer::holds) add_vacuity();
    }

    [[nodiscard]] refine::Verdict check(const cspm::DeclPtr& assertion) const {
        return context_.session.check(*assertion, limits_of_check(search_, obligation_.title)).verdict;
    }

    /// Replays the events of the script with the claim's monitor.
    [[nodiscard]] claims::Account replay(const runs::Run& run) const {
        claims::Account account(claim_, project_.claims->checked.unit);
        for (const std::string& event : run.raw) follow(account, visible(event));
        return account;
    }
    void follow(claims::Account& account, const std::string& event) const {
        if (event == "tock" || event == claims::Decision::waiting_event) {
            account.tock();
        } else if (event == "✓") {
            account.end();
        } else if (const claims::Letter* const letter = claims::find_letter(scripted_.letters, event);
                   letter != nullptr && !letter->facts.empty()) {
            account.observe(letter->facts);
        } else if (letter != nullptr) {
            account.observe(letter->occurrence, claims::text_of(*letter, claim_, event));
        }
    }
    /// Returns e for a hidden step "τ(e)".
    [[nodiscard]] static std::string visible(const std::string& event) {
        constexpr std::string_view tau = "τ(";
        if (!event.starts_with(tau)) return event;
        return event.substr(tau.size(), event.size() - tau.size() - 1);
    }

    void explain(runs::Run& run) const {
        const claims::Account account = replay(run);
        if (!account.is_broken()) return;
        tell(run, account.reasons());
    }
    void tell(runs::Run& run, const std::vector<std::string>& reasons) const {
        mark_scopes(run);
        run.end.why = fmt::format("{}", fmt::join(reasons, "; "));
        run.end.allowed.clear();
    }

    /// Marks the steps after which the claim's scope is active, or a response is pending.
    void mark_scopes(runs::Run& run) const {
        claims::Account account(claim_, project_.claims->checked.unit);
        std::size_t at = 0;
        for (runs::Step& step : run.steps) {
            const std::size_t end = std::min(step.raw + step.count, run.raw.size());
            for (; at < end; ++at) follow(account, visible(run.raw[at]));
            const claims::MonitorState& state = account.state();
            step.in_scope = state.phase == claims::Phase::inside && claim_.scope.kind != claims::ScopeKind::whole;
            step.owed = state.left >= 0 || state.due || state.stay >= 0;
        }
    }

    /// Decides whether time can stop while a response is pending. In this case, the claim is broken although no run
    /// violates it.
    void decide_standstill() {
        const refine::Verdict verdict = check(scripted_.decision.standstill);
        report_.statistics.states = std::max(report_.statistics.states, verdict.statistics.states);
        if (verdict.outcome == refine::Outcome::inconclusive) {
            report_.answer = Answer::inconclusive;
            report_.reason = verdict.reason;
        } else if (verdict.outcome == refine::Outcome::fails && verdict.counterexample) {
            report_.answer = Answer::fails;
            csp_emit::Obligation stops = obligation_;
            stops.kind = ir::PropertyKind::timelock_free;
            report_.run = runs::interpret_counterexample(context_, stops, *verdict.counterexample);
            const std::string cause = report_.run->end.why;
            std::vector<std::string> reasons = replay(*report_.run).reasons_of_standstill();
            reasons.back() += fmt::format(": {}", cause);
            tell(*report_.run, reasons);
        }
    }

    /// Decides whether time can pass forever while a response without time limit is pending. Such a run breaks the
    /// claim.
    void decide_waiting() {
        const refine::Limits bounds = limits_of_check(search_, obligation_.title);
        try {
            const auto system = context_.session.system(scripted_.decision.waiting, bounds);
            const lts::Event waiting = context_.session.event_table().intern(claims::Decision::waiting_event);
            const auto run = sleec::endless_run(*system, waiting, [&](std::size_t states) {
                search_.services.budget().poll();
                if (states > bounds.max_states) throw process::Interrupted("max-states");
                report_.statistics.states = std::max<std::uint64_t>(report_.statistics.states, states);
            });
            if (run) report_endless(*system, *run, bounds);
        } catch (const process::Interrupted& limit) {
            report_.answer = Answer::inconclusive;
            report_.reason = limit.what();
        }
    }

    void report_endless(lts::TransitionSystem& system, const sleec::EndlessRun& run, const refine::Limits& bounds) {
        report_.answer = Answer::fails;
        claims::Account account(claim_, project_.claims->checked.unit);
        for (const sleec::EndlessStep& step : run.steps)
            follow(account, context_.session.event_table().name(step.revealed));
        const std::vector<std::string> reasons = account.reasons_of_waiting();
        report_.reason = fmt::format("{}", fmt::join(reasons, "; "));
        const auto drawn = endless_counterexample(system, run, bounds);
        if (!drawn) return;
        report_.run = runs::interpret_counterexample(context_, obligation_, *drawn);
        tell(*report_.run, reasons);
        report_.reason.clear();
    }

    void add_vacuity() {
        const auto never = [&](std::string text) {
            add(report_.basis, {GroundKind::never_asked, std::move(text), {}, {}, {}, {}});
        };
        const claims::Decision& decision = scripted_.decision;
        if (decision.asked && check(decision.asked).outcome == refine::Outcome::fails) {
            const std::string& trigger =
                claim_.body.kind == claims::BodyKind::leads_within || claim_.body.kind == claims::BodyKind::leads_before
                    ? claim_.body.events.text
                    : claim_.scope.first.text;
            if (claim_.body.condition && claim_.scope.kind == claims::ScopeKind::whole)
                never(fmt::format("never asked: in no run does `{}` hold", claim_.body.condition_text));
            else if (claim_.scope.kind == claims::ScopeKind::during)
                never(fmt::format("never asked: no run has {} in the scope", trigger));
            else if (claim_.scope.kind == claims::ScopeKind::whole)
                never(fmt::format("never asked: no run has {}", asked_text()));
            else
                never(fmt::format("never asked: no run has {} in the scope of {}", trigger, claim_.scope.first.text));
            return;
        }
        if (decision.happens && check(decision.happens).outcome == refine::Outcome::fails)
            never(fmt::format("never asked: no run has {}", claim_.body.events.text));
    }
    /// Returns the events that trigger the requirement of a claim without scope. If none of them occurs, the claim
    /// requires nothing.
    [[nodiscard]] const std::string& asked_text() const {
        return claim_.body.kind == claims::BodyKind::at_least ? claim_.body.others.text : claim_.body.events.text;
    }

    const Project& project_;
    const runs::Context& context_;
    const SearchContext& search_;
    const csp_emit::Obligation& obligation_;
    AssertionReport& report_;
    const claims::CheckedClaim& claim_;
    const ScriptedClaim& scripted_;
};

}  // namespace

void complete_answer(const Project& project, const runs::Context& context, const SearchContext& search,
                     const csp_emit::Obligation& obligation, std::size_t claim, AssertionReport& report) {
    Answerer(project, context, search, obligation, claim, report).complete();
}

}  // namespace robochart::driver
