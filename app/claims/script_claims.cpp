// SPDX-License-Identifier: Apache-2.0
#include "app/claims/script_claims.hpp"

#include <fmt/format.h>

#include <utility>

#include "app/claims/script_basis.hpp"
#include "app/command/run.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "driver/claims/certificates.hpp"

namespace robochart::app {
namespace {

driver::Answer answer(refine::Outcome outcome) {
    if (outcome == refine::Outcome::holds) return driver::Answer::holds;
    return outcome == refine::Outcome::fails ? driver::Answer::fails : driver::Answer::inconclusive;
}

/// Returns the innermost calls and the number of further calls. A large number shows a deep recursion.
std::string call_stack(const std::vector<std::string>& frames) {
    constexpr std::size_t shown = 8;
    std::string text;
    for (std::size_t i = 0; i < frames.size() && i < shown; ++i)
        text += fmt::format("\n               in {}", frames[i]);
    if (frames.size() > shown) text += fmt::format("\n               and {} more", frames.size() - shown);
    return text;
}

/// Returns the result of an assertion before its check begins.
ScriptAssertion undecided_assertion(const cspm::Decl& assertion, std::size_t number,
                                    const diagnostics::SourceManager& sources) {
    ScriptAssertion result;
    result.number = number;
    result.text = text_of(assertion);
    result.place = sources.path_and_line(assertion.span);
    const cspm::Assertion& claim = assertion.assertion;
    const bool refinement = claim.kind == cspm::AssertionKind::refinement;
    if (refinement) result.specification = cspm::print(claim.specification);
    result.process = cspm::print(refinement ? claim.implementation : claim.specification);
    result.result.negated = claim.negated;
    result.errors = {driver::undecided_at_limit};
    return result;
}

/// Converts the result to an entry of the report over all scripts.
driver::AssertionReport in_report(const ScriptAssertion& assertion, const process::EventTable& events,
                                  const Options& options) {
    driver::AssertionReport report;
    report.title = assertion.text;
    report.place = assertion.place;
    report.answer = assertion.answer;
    report.statistics = assertion.result.verdict.statistics;
    report.searched = !assertion.result.verdict.known;
    report.basis = assertion.basis;
    report.certificate = assertion.certificate;
    if (!assertion.errors.empty()) report.reason = assertion.errors.front();
    if (assertion.result.verdict.counterexample && !options.script.brief)
        report.counterexample = counterexample_text(assertion, events, options);
    return report;
}

}  // namespace

OpenScript::OpenScript(const LoadedScript& loaded, const Options& options) : loaded_(loaded), options_(options) {
    (void)open_session();
}

cspm::Session& OpenScript::open_session() {
    if (session_) return *session_;
    session_ = std::make_unique<cspm::Session>(loaded_.script, &options_.run->budget());
    if (diagnostics::Cache* const cache = options_.run->cache()) session_->set_cache(*cache);
    for (const std::string& name : std::exchange(events_, {})) session_->event_table().intern(name);
    return *session_;
}

void OpenScript::give_back() {
    if (!session_) return;
    const process::EventTable& events = session_->event_table();
    for (process::Event event = 0; event < events.size(); ++event) events_.push_back(events.name(event));
    session_.reset();
}

std::string text_of(const cspm::Decl& assertion) {
    constexpr std::string_view keyword = "assert ";
    const std::string text = cspm::print(assertion);
    return text.starts_with(keyword) ? text.substr(keyword.size()) : text;
}

ScriptClaims::ScriptClaims(OpenScript& open, const LoadedScript& loaded, const Options& options,
                           const std::vector<std::size_t>& chosen, ScriptReport& script, Report& report)
    : open_(open),
      sources_(loaded.sources),
      options_(options),
      script_(script),
      report_(report),
      first_(report.assertions.size()),
      begun_(chosen.size()),
      shown_(chosen.size()) {
    const std::vector<cspm::DeclPtr> all = open.open_session().assertions();
    const auto edit = options.run->edit();
    for (const std::size_t i : chosen) {
        assertions_.push_back(all[i]);
        script.assertions.push_back(undecided_assertion(*all[i], i + 1, sources_));
        report.assertions.push_back(in_report(script.assertions.back(), open.open_session().event_table(), options));
    }
}

void ScriptClaims::decide_all(const Show& show) {
    std::vector<driver::WaitingClaim> claims;
    for (std::size_t at = 0; at < assertions_.size(); ++at)
        claims.push_back({script_.assertions[at].text,
                          [this, at, &show](const driver::Turn& turn) { return decide_in(turn, at, show); }});
    try {
        decide_in_turns(claims, search_context(options_), [this] { open_.give_back(); });
    } catch (const diagnostics::LimitReached& limit) {
        options_.run->finish();
        say_not_begun(limit.what());
    }
    const process::EventTable no_events;  // an assertion without an answer has no events to print
    for (std::size_t at = 0; at < assertions_.size(); ++at)
        if (!shown_[at]) show(script_.assertions[at], no_events);
}

bool ScriptClaims::decide_in(const driver::Turn& turn, std::size_t at, const Show& show) {
    driver::SearchContext search{options_, *options_.run, turn};
    search.turn.on_progress = [this, at](const refine::Progress& progress) { note_progress(progress, at); };
    begun_[at] = true;
    ScriptAssertion one = undecided_assertion(*assertions_[at], script_.assertions[at].number, sources_);
    decide_one(search, *assertions_[at], one);
    const bool decided = one.answer != driver::Answer::inconclusive;
    store_result(at, std::move(one));
    if (!decided) return false;
    shown_[at] = true;
    show(script_.assertions[at], open_.open_session().event_table());
    return true;
}

void ScriptClaims::decide_one(const driver::SearchContext& search, const cspm::Decl& assertion, ScriptAssertion& one) {
    const refine::Limits bounds = driver::limits_of_check(search, one.text);
    one.errors.clear();
    try {
        one.result = open_.open_session().check(assertion, bounds);
        one.answer = answer(one.result.verdict.outcome);
        one.basis = basis_of(open_.open_session(), assertion, one.result, search);
        if (one.answer == driver::Answer::holds && !options_.claims.certificates.empty())
            certify(assertion, search, one);
        if (one.result.verdict.counterexample && !options_.script.brief)
            one.behaviour =
                open_.open_session().behaviour_with_values(assertion, *one.result.verdict.counterexample, bounds);
        if (!one.result.verdict.reason.empty()) one.errors.push_back(ended_turn(one.result.verdict.reason, search));
    } catch (const cspm::EvaluationError& error) {
        one.answer = driver::Answer::error;
        one.errors.push_back(
            fmt::format("{}: {}{}", sources_.path_and_line(error.span), error.what(), call_stack(error.stack)));
    }
}

void ScriptClaims::certify(const cspm::Decl& assertion, const driver::SearchContext& search, ScriptAssertion& one) {
    const std::size_t script = report_.assertions.size() - script_.assertions.size();  // entries of earlier scripts
    const std::string number = script == 0 ? std::to_string(one.number) : fmt::format("{}.{}", script, one.number);
    one.certificate =
        driver::write_certificates(open_.open_session(), {number, one.text, one.place, {&assertion}, {}}, search);
}

void ScriptClaims::store_result(std::size_t at, ScriptAssertion one) {
    name_events(one, open_.open_session().event_table(), options_);
    driver::AssertionReport reported = in_report(one, open_.open_session().event_table(), options_);
    const auto edit = options_.run->edit();
    report_.assertions[first_ + at] = std::move(reported);
    script_.assertions[at] = std::move(one);
}

/// Stores the size of the search so far in both reports, in case the run ends now.
void ScriptClaims::note_progress(const refine::Progress& progress, std::size_t at) {
    const auto edit = options_.run->edit();
    refine::Statistics& known = report_.assertions[first_ + at].statistics;
    if (progress.phase != refine::Progress::Phase::searching || progress.states < known.states) return;
    report_.assertions[first_ + at].searched = true;
    known.states = progress.states;
    known.transitions = progress.transitions;
    known.depth = progress.depth;
    known.seconds = progress.seconds;
    script_.assertions[at].result.verdict.statistics = known;
}

void ScriptClaims::say_not_begun(const std::string& why) {
    const auto edit = options_.run->edit();
    for (std::size_t at = 0; at < assertions_.size(); ++at) {
        if (begun_[at]) continue;
        script_.assertions[at].errors = {"not begun: " + why};
        report_.assertions[first_ + at].reason = script_.assertions[at].errors.front();
    }
}

}  // namespace robochart::app
