// SPDX-License-Identifier: Apache-2.0
// Renders the report as SARIF 2.1.0 (OASIS, 2020). The report contains a result for each assertion that fails or is not
// decided, and for each component whose code does not conform. The code flow (3.36) of an assertion consists of the
// steps of its run that have places. An unknown answer has the kind `open` (3.27.9), which is neither a failure nor a
// pass. A claim that is true on some basis has the kind `informational`. Entries of the basis with a place are related
// locations (3.27.22); the others are part of the message.
#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "app/report/report.hpp"
#include "base/diagnostics/sarif.hpp"

namespace robochart::app {
namespace {

using diagnostics::Json;
using diagnostics::sarif_text;

enum class Rule : unsigned char { assertion, conformance };

// Kinds of results.
constexpr std::string_view failure = "fail", left_open = "open", informational = "informational";

Json sarif_rules() {
    return Json::array(
        {diagnostics::sarif_rule("assertion", "an assertion of the model does not hold",
                                 "A run of the model does what the assertion excludes, or it could not be decided "
                                 "whether there is one. The steps of the run are its code flow.",
                                 "error"),
         diagnostics::sarif_rule("conformance", "the generated code does not do what the model says",
                                 "In some control cycle the code that is generated of the component does what its "
                                 "model excludes, or it could not be decided whether it does.",
                                 "error")});
}

Json place_of(const runs::Place& place) {
    return diagnostics::sarif_place(place.file, {place.line, place.column}, {place.end_line, place.end_column});
}

std::string step_text(const runs::Step& step, durations::Unit unit) {
    return step.time ? fmt::format("{}: {}", durations::time_text(*step.time, unit), step.event.text) : step.event.text;
}

/// Returns the steps of the run that have places; null if there are none.
Json code_flow_json(const runs::Run& run) {
    Json locations = Json::array();
    for (std::size_t i = 0; i < run.steps.size(); ++i) {
        const runs::Step& step = run.steps[i];
        if (!step.event.place) continue;
        const Json location{{"physicalLocation", place_of(*step.event.place)},
                            {"message", sarif_text(step_text(step, run.unit))}};
        locations.push_back({{"location", location}, {"executionOrder", i + 1}});
    }
    if (locations.empty()) return nullptr;
    return Json::array({Json{{"threadFlows", Json::array({Json{{"locations", locations}}})}}});
}

/// Makes one result. If `region` has no value, the place is the beginning of `file`, because readers reject results
/// without a place.
Json sarif_result(Rule rule, std::string_view kind, const std::string& message, const std::string& subject,
                  const std::optional<runs::Place>& region, const std::string& file) {
    const runs::Place beginning{file, 1, 1, 1, 1};
    constexpr std::array<const char*, 2> ids{"assertion", "conformance"};
    const auto index = static_cast<std::size_t>(rule);
    return {{"ruleId", ids[index]},
            {"ruleIndex", index},
            {"kind", kind},
            {"level", kind == failure ? "error" : "none"},
            {"message", sarif_text(message)},
            {"locations", Json::array({Json{{"physicalLocation", place_of(region.value_or(beginning))}}})},
            {"partialFingerprints", diagnostics::sarif_fingerprint(ids[index], subject)}};
}

/// Adds the basis of the verdict to the message and to the locations.
void add_basis(const driver::Basis& basis, std::string& message, Json& related) {
    for (const driver::Ground& ground : basis) {
        message += fmt::format("; it rests on: {}", ground_text(ground));
        if (!ground.region) continue;
        related.push_back({{"id", related.size() + 1},
                           {"physicalLocation", place_of(*ground.region)},
                           {"message", sarif_text(ground.text)}});
    }
    std::set<std::string> remedies;
    for (const driver::Ground& ground : basis)
        if (!ground.remedy.empty() && remedies.insert(ground.remedy).second) message += "; " + ground.remedy;
}

std::string_view kind_in_log(driver::Answer answer) {
    if (answer == driver::Answer::holds) return informational;
    return answer == driver::Answer::fails || answer == driver::Answer::error ? failure : left_open;
}

std::string_view words_of(driver::Answer answer) {
    if (answer == driver::Answer::holds || answer == driver::Answer::fails) return name_of(answer);
    return answer == driver::Answer::error ? "cannot be evaluated" : "is not decided";
}

void add(const driver::AssertionReport& a, const std::string& file, Json& results) {
    if (a.answer == driver::Answer::no_check || a.answer == driver::Answer::computed) return;
    if (a.answer == driver::Answer::holds && a.basis.empty()) return;
    std::string why = a.reason;
    if (why.empty() && a.run) why = a.run->end.why;
    std::string message = fmt::format("{}: {}{}{}", a.title, words_of(a.answer), why.empty() ? "" : ": ", why);
    Json related = Json::array();
    add_basis(a.basis, message, related);
    Json one = sarif_result(Rule::assertion, kind_in_log(a.answer), message, a.title, a.region, file);
    if (!related.empty()) one["relatedLocations"] = related;
    if (a.run)
        if (const Json steps = code_flow_json(*a.run); !steps.is_null()) one["codeFlows"] = steps;
    results.push_back(one);
}

void add(const ConformanceReport& c, const std::string& file, Json& results) {
    using conformance::Outcome;
    if (c.result.outcome == Outcome::conforms) return;
    const bool known = c.result.outcome == Outcome::differs || c.result.outcome == Outcome::rounds ||
                       c.result.outcome == Outcome::not_schedulable;
    results.push_back(sarif_result(Rule::conformance, known ? failure : left_open,
                                   fmt::format("the code of {} {}: {}", c.component,
                                               known ? "does not conform" : "was not compared", c.result.reason),
                                   c.component, c.region, file));
}

/// Adds a claim about control cycles that fails or is not decided, for the model in cycles or for the code. If the
/// claim holds for the code, the answer for the model is only information.
void add(const conformance::CycleAnswers& claim, const conformance::CycleAnswer& answer, std::string_view subject,
         const std::optional<runs::Place>& region, const std::string& file, Json& results) {
    using conformance::Outcome;
    if (answer.outcome == Outcome::conforms) return;
    const bool known = answer.outcome == Outcome::differs;
    const std::string name = fmt::format("{} [{}]", claim.claim, subject);
    const std::string_view kind = known ? failure : left_open;
    results.push_back(sarif_result(
        Rule::assertion, claim.holds() ? informational : kind,
        fmt::format("{}: {}: {}: {}", name, claim.wording, known ? "FAILS" : "is not decided", answer.reason), name,
        region, file));
}

/// Returns the reason why the results are incomplete.
std::string why_incomplete(const Report& report) {
    if (!report.limit.empty()) return report.limit;
    if (!report.refused.empty()) return fmt::format("{} has errors", report.refused.front().model);
    return report.nothing_checked ? report.unclaimed : "";
}

}  // namespace

std::string render_sarif(const Report& report, const std::string& verb) {
    diagnostics::SarifRun run;
    run.version = program_version;
    run.what = fmt::format("{}/{}", verb, report.model);
    run.rules = sarif_rules();
    const std::string file = report.file.empty() ? report.model : report.file;
    for (const driver::AssertionReport& assertion : report.assertions)
        if (!assertion.core || !assertion.core->information) add(assertion, file, run.results);
    for (const ConformanceReport& component_report : report.conformance) {
        add(component_report, file, run.results);
        for (std::size_t i = 0; i < component_report.result.claims.size(); ++i) {
            const conformance::CycleAnswers& claim = component_report.result.claims[i];
            const std::optional<runs::Place>& region = component_report.claim_regions.at(i);
            add(claim, claim.model, model_in_cycles, region, file, run.results);
            add(claim, claim.code, this_code, region, file, run.results);
        }
    }
    run.limit = why_incomplete(report);
    run.properties = {{"model", report.model}, {"exit", static_cast<int>(report.exit_code())}};
    return diagnostics::sarif_log(run);
}

}  // namespace robochart::app
