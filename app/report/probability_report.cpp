// See probability_report.hpp.
#include "app/report/probability_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/report/prism_report.hpp"

namespace robochart::app {
namespace {

using diagnostics::Json;
using probability::Row;
using Kind = prism::Result::Kind;

std::string result_text(const prism::Result& result) {
    switch (result.kind) {
        case Kind::truth:
            return result.truth           ? "true"
                   : result.where.empty() ? "false"
                                          : fmt::format("false, for example in the state {}", result.where);
        case Kind::number:
            return value_text(result.low) +
                   (result.reason.empty() ? "" : fmt::format("; wider than asked for: {}", result.reason));
        case Kind::range:
            return fmt::format("from {} to {}", value_text(result.low), value_text(result.high));
        case Kind::unknown:
            break;
    }
    return "not decided: " + result.reason;
}

const char* word_of(const Row& row) {
    if (!row.error.empty()) return "error";
    for (const prism::Result& each : row.results)
        if (each.kind == Kind::unknown) return "not decided";
    const prism::Result& first = row.results.front();
    return first.kind == Kind::truth ? (first.truth ? "true" : "false") : "value";
}

Json row_json(const Row& row) {
    Json json{{"constants", Json::object()},
              {"answer", word_of(row)},
              {"states", row.states},
              {"transitions", row.transitions},
              {"seconds", diagnostics::rounded(row.seconds, 3)}};
    for (const auto& [name, value] : row.constants) json["constants"][name] = value;
    if (!row.error.empty()) json["reason"] = row.error;
    for (const prism::Result& each : row.results) {
        if (!each.reason.empty()) json["reason"] = each.reason;
        if (!each.where.empty()) json["state"] = each.where;
    }
    const bool values =
        std::all_of(row.results.begin(), row.results.end(), [](const auto& each) { return each.kind == Kind::number; });
    if (!values || row.results.empty()) return json;
    if (row.results.size() == 1) {
        json.update(real_json(row.results.front().low));
    } else {
        json["least"] = real_json(row.results.front().low);
        json["greatest"] = real_json(row.results.back().low);
    }
    return json;
}

}  // namespace

std::string row_text(const Row& row) {
    if (!row.error.empty()) return "error: " + row.error;
    const auto open = std::find_if(row.results.begin(), row.results.end(),
                                   [](const prism::Result& each) { return each.kind == Kind::unknown; });
    if (open != row.results.end()) return result_text(*open);
    if (row.results.size() == 1) return result_text(row.results.front());
    return fmt::format("least {}, greatest {}", result_text(row.results.front()), result_text(row.results.back()));
}

std::vector<std::pair<std::string, std::string>> varying(const ProbabilityReport& report, const Row& row) {
    std::vector<std::pair<std::string, std::string>> result;
    for (std::size_t i = 0; i < row.constants.size(); ++i)
        if (std::any_of(report.rows.begin(), report.rows.end(),
                        [&](const Row& other) { return other.constants[i].second != row.constants[i].second; }))
            result.push_back(row.constants[i]);
    return result;
}

std::string reading_of(const ProbabilityReport& report) {
    if (report.encoding == "robotool")
        return "in RoboTool's encoding, where all possible steps are equally likely and bounds count steps";
    const std::string who = report.scheduler == "any" ? "over all schedulers"
                            : report.scheduler == "urgent"
                                ? "over the schedulers by which inputs and time wait for all that needs neither"
                                : "where all possible steps are equally likely";
    return fmt::format("in the timed CSP semantics, {}; bounds count time units", who);
}

std::string probability_text(const ProbabilityReport& report, const std::string& indent) {
    if (report.rows.empty()) return "";
    std::string text = fmt::format("{}{}:\n", indent, reading_of(report));
    for (const Row& row : report.rows) {
        std::string constants;
        for (const auto& [name, value] : varying(report, row))
            constants += fmt::format("{}{}={}", constants.empty() ? "" : ", ", name, value);
        text += fmt::format("{}  {}{}{}\n", indent, constants, constants.empty() ? "" : ": ", row_text(row));
    }
    return text;
}

Json probability_json(const ProbabilityReport& report) {
    Json json{{"encoding", report.encoding}, {"rows", Json::array()}};
    if (!report.scheduler.empty()) json["scheduler"] = report.scheduler;
    for (const Row& row : report.rows) json["rows"].push_back(row_json(row));
    return json;
}

}  // namespace robochart::app
