// SPDX-License-Identifier: Apache-2.0
// Renders the report for programs as JSON. docs/cli.md contains the schema.
#include <nlohmann/json.hpp>

#include "app/report/probability_report.hpp"
#include "app/report/report.hpp"
#include "app/report/script_report.hpp"
#include "base/diagnostics/json.hpp"
#include "conformance/model/rules.hpp"
#include "counterexample/json.hpp"
#include "counterexample/text.hpp"

namespace robochart::app {

diagnostics::Json grounds_json(const driver::Basis& basis) {
    diagnostics::Json json = diagnostics::Json::array();
    for (const driver::Ground& ground : basis) {
        diagnostics::Json& one =
            json.emplace_back(diagnostics::Json{{"kind", name_of(ground.kind)}, {"text", ground.text}});
        if (!ground.element.empty()) one["element"] = ground.element;
        if (!ground.place.empty()) one["place"] = ground.place;
        if (!ground.remedy.empty()) one["remedy"] = ground.remedy;
    }
    return json;
}

namespace {

using diagnostics::Json;

Json statistics_json(const refine::Statistics& s) {
    return {{"states", s.states},        {"transitions", s.transitions}, {"depth", s.depth},
            {"chased", s.chased},        {"replicas", s.replicas},       {"distinguished", s.distinguished},
            {"specNodes", s.spec_nodes}, {"seconds", s.seconds}};
}

/// The counterexample as text, as events of the script, and as data.
Json run_counterexample_json(const runs::Run& run) {
    const auto loop = run.raw.end() - static_cast<std::ptrdiff_t>(run.raw_loop);
    Json json{{"text", runs::text_of(run, indent_of_runs)},
              {"events", std::vector<std::string>(run.raw.begin(), loop)}};
    json["loopEvents"] = std::vector<std::string>(loop, run.raw.end());
    json.update(runs::run_json(run));
    return json;
}

Json assertion_json(const driver::AssertionReport& a) {
    Json json{{"title", a.title},
              {"place", a.place},
              {"answer", name_of(a.answer)},
              {"statistics", statistics_json(a.statistics)}};
    const bool decided = a.answer == driver::Answer::holds || a.answer == driver::Answer::fails;
    if (decided && !a.searched) json["known"] = true;
    if (a.core)
        json["core"] = {
            {"component", a.core->component}, {"property", a.core->property}, {"information", a.core->information}};
    if (a.probability) json["probability"] = probability_json(*a.probability);
    if (!a.reason.empty()) json["reason"] = a.reason;
    if (!a.basis.empty()) json["basis"] = grounds_json(a.basis);
    if (a.run) json["counterexample"] = run_counterexample_json(*a.run);
    return json;
}

Json behaviour_json(const conformance::Behaviour& b) {
    return {{"outputs", b.outputs}, {"ends", b.ends}, {"state", b.state}};
}

Json cycles_json(const std::vector<conformance::Cycle>& list) {
    Json json = Json::array();
    for (const conformance::Cycle& cycle : list)
        json.push_back({{"inputs", cycle.inputs}, {"outputs", cycle.outputs}, {"state", cycle.state}});
    return json;
}

Json aside_json(const conformance::Aside& a) {
    if (a.holds) return {{"holds", true}};
    Json json{{"holds", false}, {"reason", a.reason}, {"cycles", cycles_json(a.cycles)}};
    if (a.rule != nullptr) json.update({{"code", a.rule->code}, {"meaning", conformance::meaning_of(a)}});
    if (a.run) json["run"] = runs::run_json(*a.run);
    return json;
}

Json missed_json(const conformance::MissedEvent& m) {
    const auto number = [](const std::optional<std::uint64_t>& cycles) {
        return cycles ? Json(*cycles) : Json(nullptr);
    };
    Json json{{"event", m.event}, {"code", conformance::rules::event_missed.code}, {"cycles", number(m.cycles)}};
    for (const conformance::MissedEvent::Reason& reason : m.reasons)
        json["reasons"].push_back({{"while", reason.why == conformance::MissedWhile::busy ? "busy" : "condition"},
                                   {"cycles", number(reason.cycles)},
                                   {"places", reason.places}});
    return json;
}

Json overtaken_json(const conformance::OvertakenEvent& found) {
    return {{"event", found.event},
            {"code", conformance::rules::event_overtaken.code},
            {"by", found.by},
            {"due", found.due},
            {"places", found.places}};
}

Json conformance_json(const ConformanceReport& c) {
    const conformance::Result& r = c.result;
    Json json{{"component", c.component},    {"outcome", name_of(r.outcome)},
              {"codeStates", r.code_states}, {"codeCycles", r.code_cycles},
              {"dispatched", r.dispatched},  {"statistics", statistics_json(r.product)},
              {"seconds", c.seconds}};
    for (const conformance::FewValues& represented : r.represented)
        json["represented"].push_back({{"type", represented.type}, {"values", represented.values}});
    if (!r.reason.empty()) json["reason"] = r.reason;
    if (const conformance::Explanation& e = r.explanation; e.rule != nullptr) {
        json["code"] = e.rule->code;
        json["explanation"] = {{"where", e.where}, {"remedy", e.remedy}};
    }
    if (r.explanation.run) json["explanation"]["run"] = runs::run_json(*r.explanation.run);
    if (!r.warnings.empty()) json["warnings"] = r.warnings;
    if (r.api_difference)
        json["apiDifference"] = {{"event", r.api_difference->event},
                                 {"differs", r.api_difference->what},
                                 {"step", behaviour_json(r.api_difference->cycle)},
                                 {"dispatch", behaviour_json(r.api_difference->dispatched)}};
    if (r.register_cycles) json["registerCycles"] = aside_json(*r.register_cycles);
    if (r.deadlines) json["deadlinesMet"] = aside_json(*r.deadlines);
    for (const conformance::MissedEvent& missed : r.missed) json["missedEvents"].push_back(missed_json(missed));
    for (const conformance::OvertakenEvent& overtaken : r.overtaken)
        json["overtakenEvents"].push_back(overtaken_json(overtaken));
    if (r.cycles.empty()) return json;
    json["cycles"] = cycles_json(r.cycles);
    json["expected"] = r.expected;
    json["events"] = r.raw;
    return json;
}

Json size(const driver::SizeReport::Size& size) {
    return {{"states", size.states}, {"transitions", size.transitions}, {"whole", size.whole}};
}

Json files_json(const std::vector<FileReport>& list) {
    Json json = Json::array();
    for (const FileReport& file : list) json.push_back({{"path", file.path}, {"bytes", file.bytes}});
    return json;
}

}  // namespace

std::string render_json(const Report& report) {
    Json json{{"schema", "robochart-verify/report/1"},
              {"model", report.model},
              {"summary", report.summary},
              {"notes", report.notes},
              {"exit", static_cast<int>(report.exit_code())}};
    if (!report.unclaimed.empty()) json["unclaimed"] = report.unclaimed;
    if (!report.limit.empty()) json["limit"] = report.limit;
    if (const std::string advice = report.limit_advice(); !advice.empty()) json["advice"] = advice;
    json["assertions"] = Json::array();
    for (const driver::AssertionReport& a : report.assertions) json["assertions"].push_back(assertion_json(a));
    json["bounds"] = Json::array();
    for (const driver::BoundReport& b : report.bounds)
        json["bounds"].push_back({{"element", b.element}, {"place", b.place}, {"text", b.text}, {"time", b.time}});
    for (const ir::ReplacedData& data : report.data) {
        json["data"].push_back({{"places", data.places},
                                {"classes", data.classes},
                                {"conditions", data.conditions},
                                {"allValues", data.all_values},
                                {"tested", !data.nothing_tested}});
        if (!data.term.empty()) json["data"].back()["term"] = data.term;
    }
    if (!report.sizes.empty()) json["sizes"] = Json::array();
    for (const driver::SizeReport& s : report.sizes)
        json["sizes"].push_back({{"component", s.component},
                                 {"time", s.time},
                                 {"process", size(s.process)},
                                 {"compressed", size(s.compressed)}});
    json["conformance"] = Json::array();
    for (const ConformanceReport& c : report.conformance) json["conformance"].push_back(conformance_json(c));
    json["cspFiles"] = files_json(report.csp_files);
    json["cppFiles"] = files_json(report.cpp_files);
    if (!report.prism_files.empty()) json["prismFiles"] = files_json(report.prism_files);
    if (!report.monitor_files.empty()) json["monitorFiles"] = files_json(report.monitor_files);
    if (!report.test_files.empty()) json["testFiles"] = files_json(report.test_files);
    if (!report.remarks.empty()) json["remarks"] = report.remarks;
    for (const RefusedReport& refused : report.refused)
        json["refused"].push_back(
            {{"model", refused.model}, {"diagnostics", Json::parse(refused.diagnostics, nullptr, false)}});
    // json_text replaces bytes that are not UTF-8, which names of files may contain.
    return diagnostics::json_text(json, 2) + "\n";
}

}  // namespace robochart::app
