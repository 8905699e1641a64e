// SPDX-License-Identifier: Apache-2.0
#include "app/report/prism_report.hpp"

#include <fmt/format.h>
#include <cmath>

#include <algorithm>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/json_values.hpp"

namespace robochart::app {
namespace {

using diagnostics::Json;
using diagnostics::json_array;
using Kind = prism::Result::Kind;

/// Returns a bound or value as a JSON number, or "Infinity".
Json number_json(double value) {
    if (std::isinf(value)) return value > 0 ? "Infinity" : "-Infinity";
    return value;
}

std::string double_text(double value) {
    if (std::isinf(value)) return value > 0 ? "Infinity" : "-Infinity";
    return fmt::format("{}", value);
}

double middle_of(const prism::Real& value) {
    const prism::Enclosure bounds = value.bounds();
    return std::isinf(bounds.high) || std::isinf(bounds.low) ? bounds.high : bounds.middle();
}

}  // namespace

std::string value_text(const prism::Real& value) {
    const prism::Enclosure bounds = value.bounds();
    if (value.is_exact()) return prism::fraction_text(value.value());
    if (bounds.low == bounds.high) return double_text(bounds.low);
    return fmt::format("{:.10g} (from {} to {})", middle_of(value), double_text(bounds.low), double_text(bounds.high));
}

Json real_json(const prism::Real& value) {
    const prism::Enclosure bounds = value.bounds();
    Json json{
        {"value", number_json(middle_of(value))}, {"low", number_json(bounds.low)}, {"high", number_json(bounds.high)}};
    if (value.is_exact()) json["exact"] = value.value().str();
    return json;
}

namespace {

/// Returns "(ci, 1000 paths of 4.6 steps, 1 to 31)".
std::string paths_text(const prism::Estimate& estimate) {
    constexpr double few = 10;
    const std::string mean = estimate.mean_steps < few ? fmt::format("{:.2g}", estimate.mean_steps)
                                                       : fmt::format("{:.0f}", estimate.mean_steps);
    return fmt::format("({}, {} paths of {} steps, {} to {})", prism::method_name(estimate.method), estimate.samples,
                       mean, estimate.least_steps, estimate.most_steps);
}

/// Returns "0.384 +- 0.04 at 99 %".
std::string estimate_text(const prism::Estimate& estimate) {
    if (std::isinf(estimate.mean)) return "Infinity, since a path never arrives";
    return fmt::format("{:.6g} +- {:.3g} at {:.6g} %", estimate.mean, *estimate.width, 100 * (1 - estimate.alpha));
}

}  // namespace

Json estimate_json(const prism::Estimate& estimate) {
    Json json{
        {"method", prism::method_name(estimate.method)},
        {"samples", estimate.samples},
        {"alpha", estimate.alpha},
        {"steps", {{"mean", estimate.mean_steps}, {"least", estimate.least_steps}, {"most", estimate.most_steps}}}};
    if (estimate.width) json["width"] = number_json(*estimate.width);
    if (estimate.hits) json["hits"] = *estimate.hits;
    if (estimate.binomial) json["clopperPearson"] = {estimate.binomial->low, estimate.binomial->high};
    return json;
}

std::string sampled_text(const prism::Result& result) {
    const prism::Estimate& estimate = *result.estimate;
    std::string answer = result.truth ? "true" : "false";
    if (result.kind == Kind::number) answer = estimate_text(estimate);
    return answer + " " + paths_text(estimate);
}

std::string binomial_text(const prism::Result& result) {
    if (!result.estimate || !result.estimate->binomial) return "";
    return fmt::format("Clopper-Pearson: from {:.6g} to {:.6g}", result.estimate->binomial->low,
                       result.estimate->binomial->high);
}

namespace {

std::string result_text(const PrismAnswer& answer) {
    const prism::Result& result = answer.result;
    if (!answer.error.empty()) return "error: " + answer.error;
    if (result.estimate && result.kind != Kind::unknown) return sampled_text(result);
    switch (result.kind) {
        case Kind::truth:
            if (!result.truth && !result.where.empty())
                return fmt::format("false, for example in the state {}", result.where);
            return result.truth ? "true" : "false";
        case Kind::number:
            return value_text(result.low);
        case Kind::range:
            return fmt::format("[{}, {}]", value_text(result.low), value_text(result.high));
        case Kind::states:
            return fmt::format("{} state{}", result.printed.size(), result.printed.size() == 1 ? "" : "s");
        case Kind::unknown:
            break;
    }
    return "not decided: " + result.reason;
}

std::string constants_text(const NamedValues& constants) {
    std::string text;
    for (const auto& [name, value] : constants) text += fmt::format("{}{}={}", text.empty() ? "" : ", ", name, value);
    return text;
}

std::string property_title(const PrismProperty& property) {
    return property.name.empty() ? property.text : fmt::format("\"{}\": {}", property.name, property.text);
}

std::string kind_text(const PrismReport& report) {
    if (report.kind != prism::ModelKind::mdp) return "dtmc";
    return report.scheduler.empty() ? "mdp" : fmt::format("mdp under the scheduler {}", report.scheduler);
}

std::string run_text(const PrismReport& report, const PrismRun& run) {
    std::string text = fmt::format("{}{}{}: {}, {} states", report.model, run.constants.empty() ? "" : ", ",
                                   constants_text(run.constants), kind_text(report), run.states);
    if (run.initial != 1) text += fmt::format(" ({} initial)", run.initial);
    if (report.kind == prism::ModelKind::mdp && report.scheduler.empty())
        text += fmt::format(", {} choices", run.choices);
    return text + fmt::format(", {} transitions", run.transitions);
}

std::string value_of(const std::string& name, const PrismRun& run, const PrismAnswer& answer) {
    for (const NamedValues* constants : {&run.constants, &answer.constants})
        for (const auto& [constant, value] : *constants)
            if (constant == name) return value;
    return "";
}

/// Returns the constants that take several values.
NamedValues varying(const PrismReport& report, const PrismRun& run, const PrismAnswer& answer) {
    NamedValues all = run.constants;
    all.insert(all.end(), answer.constants.begin(), answer.constants.end());
    std::erase_if(all, [&](const auto& constant) {
        for (const PrismRun& other : report.runs)
            for (const PrismAnswer& other_answer : other.answers)
                if (value_of(constant.first, other, other_answer) != constant.second) return false;
        return true;
    });
    return all;
}

/// Returns "0.25", "0.333333".
std::string total_text(const prism::Enclosure& total) {
    return total.is_exact() ? double_text(total.low) : fmt::format("{:.6g}", total.middle());
}

const char* way_text(const prism::Counterexample& found) {
    if (!found.never) return found.holds ? "on which the formula holds" : "on which the formula does not hold";
    return found.holds ? "after which the formula holds whatever follows"
                       : "after which the formula cannot hold any more";
}

/// Returns the most probable path, step by step.
std::string counterexample_text(const PrismReport& report, const prism::Counterexample& found,
                                const std::string& indent) {
    constexpr std::size_t most = 3;
    std::string paths = "a path";
    if (found.count != 1) paths = fmt::format("{} paths{}", found.count, found.scheduled ? " of one scheduler" : "");
    const std::string bound = found.bound.text();
    std::string comparison = fmt::format(" together; {} takes more", bound);
    if (found.enough) comparison = fmt::format(", {} {}", found.strict ? "above" : "which reaches", bound);
    std::string text =
        fmt::format("{}{} {} {} {}{}\n", indent, paths, way_text(found),
                    found.count == 1 ? "has probability" : "have probability", total_text(found.total), comparison);
    for (std::size_t i = 0; i < std::min(most, found.paths.size()); ++i) {
        const prism::ProbablePath& path = found.paths[i];
        text += fmt::format("{}{}: {}\n", indent, total_text(path.probability), path.from);
        for (const prism::ProbablePath::Step& step : path.steps)
            text += fmt::format("{}  {}{}\n", indent, text_of(step.by, *report.sources),
                                step.changes.empty() ? "" : ": " + step.changes);
    }
    if (found.count > most) text += fmt::format("{}and {} less probable ones\n", indent, found.count - most);
    return text;
}

std::string answer_text(const PrismReport& report, const PrismAnswer& answer, const std::string& indent) {
    std::string text = indent;
    if (!answer.constants.empty()) text += constants_text(answer.constants) + ": ";
    text += result_text(answer) + "\n";
    const bool number = answer.result.kind == Kind::number || answer.result.kind == Kind::range;
    const std::string binomial = binomial_text(answer.result);
    if (!binomial.empty()) text += fmt::format("{}  {}\n", indent, binomial);
    if (answer.counterexample) text += counterexample_text(report, *answer.counterexample, indent + "  ");
    if (number && !answer.result.reason.empty() && answer.error.empty())
        text += fmt::format("{}  wider than asked for: {}\n", indent, answer.result.reason);
    for (const auto& [state, value] : answer.result.printed) text += fmt::format("{}  {}: {}\n", indent, state, value);
    return text;
}

const char* answer_word(const PrismAnswer& answer) {
    if (!answer.error.empty()) return "error";
    switch (answer.result.kind) {
        case Kind::truth:
            return answer.result.truth ? "true" : "false";
        case Kind::number:
            return answer.result.estimate ? "estimate" : "number";
        case Kind::range:
            return "range";
        case Kind::states:
            return "states";
        case Kind::unknown:
            break;
    }
    return "not decided";
}

Json move_json(const prism::Move& move, const diagnostics::SourceManager& sources) {
    const auto command = [&](const prism::Move::Part& part) -> Json {
        return {{"module", part.module}, {"line", sources.position(part.command.source, part.command.begin).line}};
    };
    return {{"action", move.action}, {"commands", json_array(move.parts, command)}};
}

Json path_json(const prism::ProbablePath& path, const diagnostics::SourceManager& sources) {
    const auto move = [&](const prism::Move& by) { return move_json(by, sources); };
    const auto step = [&](const prism::ProbablePath::Step& taken) -> Json {
        return {{"by", json_array(taken.by, move)}, {"state", taken.state}};
    };
    return {{"low", path.probability.low},
            {"high", path.probability.high},
            {"from", path.from},
            {"steps", json_array(path.steps, step)}};
}

Json counterexample_json(const prism::Counterexample& found, const diagnostics::SourceManager& sources) {
    const auto path = [&](const prism::ProbablePath& probable) { return path_json(probable, sources); };
    return {{"formulaHolds", found.holds}, {"whateverFollows", found.never}, {"oneScheduler", found.scheduled},
            {"count", found.count},        {"low", found.total.low},         {"high", found.total.high},
            {"bound", found.bound.text()}, {"enough", found.enough},         {"paths", json_array(found.paths, path)}};
}

Json answer_json(const PrismReport& report, const PrismAnswer& answer) {
    Json json{{"property", answer.property + 1}, {"answer", answer_word(answer)}};
    if (!answer.constants.empty()) json["constants"] = diagnostics::json_object(answer.constants);
    const prism::Result& result = answer.result;
    if (!answer.error.empty()) {
        json["reason"] = answer.error;
        return json;
    }
    if (result.estimate) json["estimate"] = estimate_json(*result.estimate);
    if (result.estimate && result.kind == Kind::number) {
        json.update(interval_json(result));
    } else if (result.kind == Kind::number) {
        json.update(real_json(result.low));
    }
    if (result.kind == Kind::range) {
        json["least"] = real_json(result.low);
        json["greatest"] = real_json(result.high);
    }
    if (!result.where.empty()) json["state"] = result.where;
    if (!result.reason.empty()) json["reason"] = result.reason;
    for (const auto& [state, value] : result.printed) json["printed"].push_back({{"state", state}, {"value", value}});
    if (answer.counterexample) json["counterexample"] = counterexample_json(*answer.counterexample, *report.sources);
    return json;
}

Json run_json(const PrismReport& report, const PrismRun& run) {
    Json json{{"constants", diagnostics::json_object(run.constants)}};
    if (run.explored)
        json.update({{"states", run.states},
                     {"initial", run.initial},
                     {"choices", run.choices},
                     {"transitions", run.transitions},
                     {"deadlocks", run.deadlocks},
                     {"seconds", diagnostics::round_to_places(run.seconds, 3)}});
    json["answers"] = json_array(run.answers, [&](const PrismAnswer& answer) { return answer_json(report, answer); });
    return json;
}

/// Quotes a cell of a CSV file (RFC 4180).
std::string csv_cell(const std::string& text) {
    if (text.find_first_of("\",\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

/// Returns the names of all constants, in the order of first occurrence.
std::vector<std::string> names_of(const PrismReport& report) {
    std::vector<std::string> names;
    const auto add = [&](const NamedValues& constants) {
        for (const auto& [name, value] : constants)
            if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    };
    for (const PrismRun& run : report.runs) {
        add(run.constants);
        for (const PrismAnswer& answer : run.answers) add(answer.constants);
    }
    return names;
}

std::string csv_row(const PrismReport& report, const PrismRun& run, const PrismAnswer& answer,
                    const std::vector<std::string>& names) {
    std::string row;
    for (const std::string& name : names) row += csv_cell(value_of(name, run, answer)) + ",";
    row += csv_cell(property_title(report.properties[answer.property])) + "," + answer_word(answer);
    const prism::Result& result = answer.result;
    const bool number = answer.error.empty() && (result.kind == Kind::number || result.kind == Kind::range);
    if (!number) return row + ",,,\n";
    const prism::Enclosure bounds = interval_of(result);
    std::string value;
    if (result.kind != Kind::range)
        value = double_text(result.estimate ? result.estimate->mean : middle_of(result.low));
    return row + fmt::format(",{},{},{}\n", value, double_text(bounds.low), double_text(bounds.high));
}

}  // namespace

Json interval_json(const prism::Result& result) {
    const prism::Enclosure bounds = interval_of(result);
    return {{"value", number_json(result.estimate->mean)},
            {"low", number_json(bounds.low)},
            {"high", number_json(bounds.high)}};
}

prism::Enclosure interval_of(const prism::Result& result) {
    if (!result.estimate) return {result.low.bounds().low, result.high.bounds().high};
    const prism::Estimate& estimate = *result.estimate;
    if (estimate.binomial) return {estimate.binomial->low, estimate.binomial->high};
    return {estimate.mean - estimate.width.value_or(0), estimate.mean + estimate.width.value_or(0)};
}

Exit exit_of(const PrismReport& report) {
    bool failed = false;
    bool open = !report.limit.empty();
    if (!report.errors.empty()) return Exit::bad_input;
    for (const PrismRun& run : report.runs)
        for (const PrismAnswer& answer : run.answers) {
            if (!answer.error.empty()) return Exit::bad_input;
            failed = failed || (answer.result.kind == Kind::truth && !answer.result.truth);
            open = open || answer.result.kind == Kind::unknown;
        }
    if (failed) return Exit::failed;
    return open ? Exit::inconclusive : Exit::success;
}

/// Lists the properties of a single run. For several runs, prints one table per property.
std::string prism_text(const PrismReport& report, const Options& options) {
    std::string text;
    if (!options.output.quiet)
        for (const PrismRun& run : report.runs)
            if (run.explored) text += run_text(report, run) + "\n";
    for (std::size_t i = 0; i < report.properties.size(); ++i) {
        std::string answers;
        for (const PrismRun& run : report.runs)
            for (PrismAnswer answer : run.answers) {
                if (answer.property != i) continue;
                answer.constants = varying(report, run, answer);
                answers += answer_text(report, answer, "  ");
            }
        if (!answers.empty()) text += property_title(report.properties[i]) + "\n" + answers;
    }
    if (!report.limit.empty()) text += fmt::format("not finished: {}\n", report.limit);
    return text;
}

std::string prism_json(const PrismReport& report) {
    Json json{{"schema", "robochart-verify/prism/1"}, {"model", report.model}};
    if (report.kind) json["kind"] = report.kind == prism::ModelKind::mdp ? "mdp" : "dtmc";
    if (!report.scheduler.empty()) json["scheduler"] = report.scheduler;
    json["properties"] = json_array(report.properties, [](const PrismProperty& property) {
        return Json{{"name", property.name}, {"text", property.text}};
    });
    json["runs"] = json_array(report.runs, [&](const PrismRun& run) { return run_json(report, run); });
    if (!report.errors.empty()) json["errors"] = report.errors;
    if (!report.limit.empty()) json["limit"] = report.limit;
    return diagnostics::json_text(json) + "\n";
}

std::string prism_csv(const PrismReport& report) {
    const std::vector<std::string> names = names_of(report);
    std::string text;
    for (const std::string& name : names) text += csv_cell(name) + ",";
    text += "property,answer,value,low,high\n";
    for (const PrismRun& run : report.runs)
        for (const PrismAnswer& answer : run.answers) text += csv_row(report, run, answer, names);
    return text;
}

}  // namespace robochart::app
