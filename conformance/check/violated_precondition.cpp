// SPDX-License-Identifier: Apache-2.0
// See violated_precondition.hpp.
#include "conformance/check/violated_precondition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/text.hpp"
#include "conformance/check/model_run.hpp"
#include "conformance/model/provenance_text.hpp"
#include "conformance/model/rules.hpp"

namespace robochart::conformance {

namespace {

using cpp_emit::ViolationPlace;

/// Returns whether a member of the printed state has this value.
bool has_value(const std::string& state, const std::string& value) {
    const std::string pattern = "=" + value;
    for (std::size_t at = state.find(pattern); at != std::string::npos; at = state.find(pattern, at + 1)) {
        const std::size_t end = at + pattern.size();
        if (end == state.size() || state[end] == ' ') return true;
    }
    return false;
}

std::string text_of(diagnostics::Span span, const diagnostics::SourceManager& sources) {
    if (!span.is_known()) return "";
    const std::string_view text = sources.source_text(span.source).substr(span.begin, span.end - span.begin);
    return diagnostics::escape_for_display(diagnostics::on_one_line(text));
}

}  // namespace

std::vector<diagnostics::Span> blocked_calls(const Result& result, cspm::Session& session, const cspm::ExprPtr& process,
                                             const Alphabet& alphabet, const csp_emit::Provenance& provenance,
                                             const Options& options) {
    std::vector<diagnostics::Span> calls;
    if (!result.model_run) return calls;
    std::optional<refine::Counterexample> run;
    try {
        run = run_of_model(session, process, alphabet, options.cycle_length, {}, *result.model_run,
                           limits_of_explanation(options.limits));
    } catch (const process::Interrupted&) {
        return calls;
    } catch (const cspm::EvaluationError&) {
        return calls;
    }
    if (!run) return calls;
    for (const std::string& name : definitions_in(run->steps.empty() ? run->initial : run->steps.back().state)) {
        const auto definition = provenance.definitions.find(name);
        if (definition == provenance.definitions.end()) continue;
        for (const auto& offer : definition->second.offers) calls.push_back(offer->origin.span);
    }
    return calls;
}

void name_precondition(Result& result, const std::vector<ViolationPlace>& places,
                       const std::vector<diagnostics::Span>& blocked, const diagnostics::SourceManager& sources) {
    const std::size_t at = result.reason.find(outside_precondition);
    if (result.outcome != Outcome::differs || at == std::string::npos || result.cycles.empty()) return;
    std::vector<ViolationPlace> possible;
    for (const ViolationPlace& place : places)
        if (has_value(result.cycles.back().state, place.place)) possible.push_back(place);
    if (possible.empty()) return;
    const auto stopped = std::ranges::find_if(possible, [&](const ViolationPlace& place) {
        return place.call.is_known() && std::ranges::find(blocked, place.call) != blocked.end();
    });
    const bool of_model = stopped != possible.end();
    if (!of_model && possible.size() > 1) return;
    const ViolationPlace& place = of_model ? *stopped : possible.front();
    const std::string condition = text_of(place.condition, sources);
    const std::string cause =
        of_model ? fmt::format("the precondition `{}` of {} is false", condition, place.operation)
                 : fmt::format("the code calls {} outside its precondition `{}`", place.operation, condition);
    result.reason.replace(at, outside_precondition.size(), cause);
    if (result.explanation.run) result.explanation.run->end.why = result.reason;
    if (!of_model) return;
    result.explanation.rule = &rules::precondition_false;
    result.explanation.where = {
        fmt::format("precondition of {} ({})", place.operation, sources.path_and_line(place.condition)),
        fmt::format("call of {} ({})", place.operation, sources.path_and_line(place.call))};
}

}  // namespace robochart::conformance
