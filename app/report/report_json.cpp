// SPDX-License-Identifier: Apache-2.0
// Renders the report for programs as JSON. docs/cli.md contains the schema.
#include "app/report/probability_report.hpp"
#include "app/report/report.hpp"
#include "app/report/script_report.hpp"
#include "base/diagnostics/json_values.hpp"
#include "conformance/model/rules.hpp"
#include "counterexample/json.hpp"
#include "counterexample/text.hpp"

namespace robochart::app {

namespace {

using diagnostics::Json;
using diagnostics::json_array;

Json ground_json(const driver::Ground& ground) {
    Json json{{"kind", name_of(ground.kind)}, {"text", ground.text}};
    if (!ground.element.empty()) json["element"] = ground.element;
    if (!ground.place.empty()) json["place"] = ground.place;
    if (!ground.remedy.empty()) json["remedy"] = ground.remedy;
    return json;
}

Json statistics_json(const refine::Statistics& s) {
    Json json{{"states", s.states},        {"transitions", s.transitions}, {"depth", s.depth},
              {"chased", s.chased},        {"replicas", s.replicas},       {"distinguished", s.distinguished},
              {"specNodes", s.spec_nodes}, {"seconds", s.seconds},         {"decidedBy", proof_name(s.decided_by)}};
    if (s.decided_by == refine::DecidedBy::diagrams) {
        json["diagramNodes"] = s.diagram_nodes;
        json["log10States"] = s.log10_states;
    }
    return json;
}

/// Writes the counterexample as text, as events of the script, and as data.
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
    if (!a.name.empty()) json["name"] = a.name;
    const bool decided = a.answer == driver::Answer::holds || a.answer == driver::Answer::fails;
    if (decided && !a.searched) json["known"] = true;
    if (a.core)
        json["core"] = {
            {"component", a.core->component}, {"property", a.core->property}, {"information", a.core->information}};
    if (a.probability) json["probability"] = probability_json(*a.probability);
    if (!a.reason.empty()) json["reason"] = a.reason;
    if (!a.basis.empty()) json["basis"] = grounds_json(a.basis);
    if (a.certificate) json["certificate"] = certificate_json(*a.certificate);
    if (a.run) json["counterexample"] = run_counterexample_json(*a.run);
    return json;
}

Json behaviour_json(const conformance::Behaviour& b) {
    return {{"outputs", b.outputs}, {"ends", b.ends}, {"state", b.state}};
}

Json cycle_json(const conformance::Cycle& cycle) {
    return {{"inputs", cycle.inputs}, {"outputs", cycle.outputs}, {"state", cycle.state}};
}

Json aside_json(const conformance::Aside& a) {
    if (a.holds) return {{"holds", true}};
    Json json{{"holds", false}, {"reason", a.reason}, {"cycles", json_array(a.cycles, cycle_json)}};
    if (a.rule != nullptr) json.update({{"code", a.rule->code}, {"meaning", conformance::meaning_of(a)}});
    if (a.run) json["run"] = runs::run_json(*a.run);
    return json;
}

Json reason_json(const conformance::MissedEvent::Reason& reason) {
    return {{"while", reason.why == conformance::MissedWhile::busy ? "busy" : "condition"},
            {"cycles", diagnostics::json_or_null(reason.cycles)},
            {"places", reason.places}};
}

Json missed_json(const conformance::MissedEvent& m) {
    return {{"event", m.event},
            {"code", conformance::rules::event_missed.code},
            {"cycles", diagnostics::json_or_null(m.cycles)},
            {"reasons", json_array(m.reasons, reason_json)}};
}

Json overtaken_json(const conformance::OvertakenEvent& found) {
    return {{"event", found.event},
            {"code", conformance::rules::event_overtaken.code},
            {"by", found.by},
            {"due", found.due},
            {"places", found.places}};
}

Json data_json(const ir::ReplacedData& data) {
    Json json{{"places", data.places},
              {"classes", data.classes},
              {"conditions", data.conditions},
              {"allValues", data.all_values},
              {"tested", !data.nothing_tested}};
    if (!data.term.empty()) json["term"] = data.term;
    return json;
}

Json kept_json(const driver::KeptDataReport& data) {
    Json json{{"places", data.places}, {"carrier", data.reason}};
    if (!data.place.empty()) json["place"] = data.place;
    return json;
}

Json special_json(const conformance::RobotNumbers::Special& special) {
    return {{"value", special.value}, {"limit", special.limit}, {"unlike", special.unlike}};
}

Json robot_json(const conformance::RobotNumbers& robot) {
    Json json{
        {"values", robot.numbers}, {"regions", robot.regions}, {"special", json_array(robot.special, special_json)}};
    if (!robot.difference.empty()) json["roundingDifference"] = robot.difference;
    if (!robot.limit.empty()) json["limit"] = robot.limit;
    return json;
}

Json represented_json(const conformance::FewValues& represented) {
    return {{"type", represented.type}, {"values", represented.values}};
}

Json cycle_answer_json(const conformance::CycleAnswer& answer) {
    const char* verdict = "inconclusive";
    if (answer.outcome == conformance::Outcome::conforms) verdict = "holds";
    if (answer.outcome == conformance::Outcome::differs) verdict = "fails";
    Json json{{"verdict", verdict}};
    if (!answer.reason.empty()) json["reason"] = answer.reason;
    if (!answer.cycles.empty()) json["cycles"] = json_array(answer.cycles, cycle_json);
    return json;
}

Json cycle_claim_json(const conformance::CycleAnswers& claim) {
    return {{"name", claim.claim},
            {"claim", claim.wording},
            {"asked", claim.asked},
            {"carriers", claim.in_carriers},
            {"modelInCycles", cycle_answer_json(claim.model)},
            {"thisCode", cycle_answer_json(claim.code)}};
}

Json conformance_json(const ConformanceReport& c) {
    const conformance::Result& r = c.result;
    Json json{{"component", c.component},    {"outcome", name_of(r.outcome)},
              {"codeStates", r.code_states}, {"codeCycles", r.code_cycles},
              {"dispatched", r.dispatched},  {"statistics", statistics_json(r.product)},
              {"seconds", c.seconds}};
    if (!c.order.empty()) json["order"] = c.order;
    if (!r.all_values.empty()) json["data"] = json_array(r.all_values, data_json);
    if (r.robot) json["robot"] = robot_json(*r.robot);
    if (!r.not_for_all.empty()) json["notForAllValues"] = r.not_for_all;
    if (!r.represented.empty()) json["represented"] = json_array(r.represented, represented_json);
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
    if (!r.claims.empty()) json["claims"] = json_array(r.claims, cycle_claim_json);
    if (!r.missed.empty()) json["missedEvents"] = json_array(r.missed, missed_json);
    if (!r.overtaken.empty()) json["overtakenEvents"] = json_array(r.overtaken, overtaken_json);
    if (c.certificate) json["certificate"] = certificate_json(*c.certificate);
    if (const std::string trusted = still_trusted(c); !trusted.empty()) json["certificate"]["trusted"] = trusted;
    if (r.cycles.empty()) return json;
    json["cycles"] = json_array(r.cycles, cycle_json);
    json["expected"] = r.expected;
    json["events"] = r.raw;
    return json;
}

Json bound_json(const driver::BoundReport& bound) {
    return {{"element", bound.element}, {"place", bound.place}, {"text", bound.text}, {"time", bound.time}};
}

Json size_json(const driver::SizeReport::Size& size) {
    return {{"states", size.states}, {"transitions", size.transitions}, {"whole", size.whole}};
}

Json sizes_json(const driver::SizeReport& sizes) {
    return {{"component", sizes.component},
            {"time", sizes.time},
            {"process", size_json(sizes.process)},
            {"compressed", size_json(sizes.compressed)}};
}

Json file_json(const FileReport& file) {
    return {{"path", file.path}, {"bytes", file.bytes}};
}

Json refused_json(const RefusedReport& refused) {
    return {{"model", refused.model}, {"diagnostics", Json::parse(refused.diagnostics, nullptr, false)}};
}

}  // namespace

Json certificate_json(const driver::CertificateReport& certificate) {
    if (certificate.folders.empty()) return {{"reason", certificate.reason}};
    Json json{{"level", certificate.level},
              {"reduced", !certificate.reduction.empty()},
              {"folders", certificate.folders},
              {"certified", certificate.certification == driver::Certification::certified}};
    if (!certificate.why_product.empty()) json["why_product_level"] = certificate.why_product;
    if (certificate.certification == driver::Certification::certified) {
        json["pairs"] = certificate.pairs;
        json["components"] = certificate.components;
        if (!certificate.reduction.empty()) json["reduction"] = certificate.reduction;
    } else {
        json["refused"] = certificate.certification == driver::Certification::refused;
        json["reason"] = certificate.reason;
    }
    return json;
}

Json grounds_json(const driver::Basis& basis) {
    return json_array(basis, ground_json);
}

std::string render_json(const Report& report) {
    Json json{{"schema", "robochart-verify/report/1"},
              {"model", report.model},
              {"summary", report.summary},
              {"notes", report.notes},
              {"exit", static_cast<int>(report.exit_code())}};
    if (!report.unclaimed.empty()) json["unclaimed"] = report.unclaimed;
    if (!report.limit.empty()) json["limit"] = report.limit;
    if (const std::string advice = report.limit_advice(); !advice.empty()) json["advice"] = advice;
    json["assertions"] = json_array(report.assertions, assertion_json);
    json["bounds"] = json_array(report.bounds, bound_json);
    for (const ir::ReplacedData& data : report.data) json["data"].push_back(data_json(data));
    for (const driver::KeptDataReport& data : report.kept_data) json["data"].push_back(kept_json(data));
    if (!report.sizes.empty()) json["sizes"] = json_array(report.sizes, sizes_json);
    json["conformance"] = json_array(report.conformance, conformance_json);
    json["cspFiles"] = json_array(report.csp_files, file_json);
    json["cppFiles"] = json_array(report.cpp_files, file_json);
    if (!report.prism_files.empty()) json["prismFiles"] = json_array(report.prism_files, file_json);
    if (!report.monitor_files.empty()) json["monitorFiles"] = json_array(report.monitor_files, file_json);
    if (!report.test_files.empty()) json["testFiles"] = json_array(report.test_files, file_json);
    if (!report.rst_files.empty()) json["rstFiles"] = json_array(report.rst_files, file_json);
    if (!report.remarks.empty()) json["remarks"] = report.remarks;
    if (!report.refused.empty()) json["refused"] = json_array(report.refused, refused_json);
    // json_text replaces bytes that are not UTF-8, which names of files may contain.
    return diagnostics::json_text(json, 2) + "\n";
}

}  // namespace robochart::app
