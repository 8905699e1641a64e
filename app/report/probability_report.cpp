// SPDX-License-Identifier: Apache-2.0
// See probability_report.hpp.
#include "app/report/probability_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/report/prism_report.hpp"
#include "base/diagnostics/json_values.hpp"

namespace robochart::app {
namespace {

using diagnostics::Json;
using diagnostics::json_array;
using probability::Row;
using Kind = prism::Result::Kind;

std::string result_text(const prism::Result& result) {
    if (result.estimate) {
        const std::string binomial = binomial_text(result);
        const std::string answer =
            result.kind == Kind::unknown ? "not decided: " + result.reason : sampled_text(result);
        return answer + (binomial.empty() ? "" : "; " + binomial);
    }
    switch (result.kind) {
        case Kind::truth:
            if (!result.truth && !result.where.empty())
                return fmt::format("false, for example in the state {}", result.where);
            return result.truth ? "true" : "false";
        case Kind::number:
            return value_text(result.low) +
                   (result.reason.empty() ? "" : fmt::format("; wider than asked for: {}", result.reason));
        case Kind::range:
            return fmt::format("from {} to {}", value_text(result.low), value_text(result.high));
        case Kind::states:  // not used by assertions
        case Kind::unknown:
            break;
    }
    return "not decided: " + result.reason;
}

const char* word_of(const Row& row) {
    if (!row.error.empty()) return "error";
    for (const prism::Result& result : row.results)
        if (result.kind == Kind::unknown) return "not decided";
    if (row.path) return "path";
    const prism::Result& first = row.results.front();
    if (first.kind == Kind::truth) return first.truth ? "true" : "false";
    return first.estimate ? "estimate" : "value";
}

Json path_json(const probability::Path& path) {
    const auto step = [](const probability::Path::Step& taken) -> Json {
        return {{"by", taken.by}, {"changes", taken.changes}};
    };
    return {{"from", path.begin}, {"steps", json_array(path.steps, step)}, {"deadlock", path.deadlock}};
}

Json row_json(const Row& row) {
    Json json{{"constants", diagnostics::json_object(row.constants)},
              {"answer", word_of(row)},
              {"states", row.states},
              {"transitions", row.transitions},
              {"seconds", diagnostics::round_to_places(row.seconds, 3)}};
    if (!row.error.empty()) json["reason"] = row.error;
    if (row.path) json["path"] = path_json(*row.path);
    for (const prism::Result& result : row.results) {
        if (!result.reason.empty()) json["reason"] = result.reason;
        if (!result.where.empty()) json["state"] = result.where;
    }
    if (!row.results.empty() && row.results.front().estimate) {
        const prism::Result& sampled = row.results.front();
        json["estimate"] = estimate_json(*sampled.estimate);
        if (sampled.kind == Kind::number) json.update(interval_json(sampled));
        return json;
    }
    const bool values =
        std::ranges::all_of(row.results, [](const auto& result) { return result.kind == Kind::number; });
    if (!values || row.results.empty()) return json;
    if (row.results.size() == 1) {
        json.update(real_json(row.results.front().low));
    } else {
        json["least"] = real_json(row.results.front().low);
        json["greatest"] = real_json(row.results.back().low);
    }
    return json;
}

const char* schedulers_text(std::string_view scheduler) {
    if (scheduler == "any") return "over all schedulers";
    if (scheduler == "urgent") return "over the schedulers by which inputs and time wait for all that needs neither";
    return "where all possible steps are equally likely";
}

}  // namespace

std::string row_text(const Row& row) {
    if (!row.error.empty()) return "error: " + row.error;
    const auto open =
        std::ranges::find_if(row.results, [](const prism::Result& result) { return result.kind == Kind::unknown; });
    if (open != row.results.end()) return result_text(*open);
    if (row.path)
        return fmt::format("a random path of {} steps{}", row.path->steps.size(),
                           row.path->deadlock ? ", to a deadlock" : "");
    if (row.results.size() == 1) return result_text(row.results.front());
    return fmt::format("least {}, greatest {}", result_text(row.results.front()), result_text(row.results.back()));
}

std::string path_text(const Row& row, const std::string& indent) {
    if (!row.path) return "";
    std::string text = fmt::format("{}0: {}\n", indent, row.path->begin);
    std::size_t number = 0;
    for (const probability::Path::Step& step : row.path->steps)
        text +=
            fmt::format("{}{}: {}{}{}\n", indent, ++number, step.by, step.changes.empty() ? "" : ": ", step.changes);
    return text;
}

std::vector<std::pair<std::string, std::string>> varying_constants(const driver::ProbabilityReport& report,
                                                                   const Row& row) {
    std::vector<std::pair<std::string, std::string>> result;
    for (std::size_t i = 0; i < row.constants.size(); ++i)
        if (std::ranges::any_of(report.rows,
                                [&](const Row& other) { return other.constants[i].second != row.constants[i].second; }))
            result.push_back(row.constants[i]);
    return result;
}

std::string reading_of(const driver::ProbabilityReport& report) {
    const auto sampled = [](const Row& row) {
        return row.path || std::ranges::any_of(row.results,
                                               [](const prism::Result& result) { return result.estimate.has_value(); });
    };
    if (report.encoding == "robotool")
        return fmt::format("{} RoboTool's encoding, where all possible steps are equally likely and bounds count steps",
                           std::ranges::any_of(report.rows, sampled) ? "by random paths in" : "in");
    return fmt::format("in the timed CSP semantics, {}; bounds count time units", schedulers_text(report.scheduler));
}

std::string probability_text(const driver::ProbabilityReport& report, const std::string& indent) {
    if (report.rows.empty()) return "";
    std::string text = fmt::format("{}{}:\n", indent, reading_of(report));
    for (const Row& row : report.rows) {
        std::string constants;
        for (const auto& [name, value] : varying_constants(report, row))
            constants += fmt::format("{}{}={}", constants.empty() ? "" : ", ", name, value);
        text += fmt::format("{}  {}{}{}\n", indent, constants, constants.empty() ? "" : ": ", row_text(row));
        text += path_text(row, indent + "    ");
    }
    return text;
}

Json probability_json(const driver::ProbabilityReport& report) {
    Json json{{"encoding", report.encoding}, {"rows", json_array(report.rows, row_json)}};
    if (!report.scheduler.empty()) json["scheduler"] = report.scheduler;
    return json;
}

}  // namespace robochart::app
