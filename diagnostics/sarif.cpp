// Diagnostics as SARIF 2.1.0 (OASIS, 2020): one run, the rules that occur with their help, places with columns in code
// points, fixes as replacements.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "diagnostics/escape.hpp"
#include "diagnostics/render.hpp"
#include "diagnostics/sarif.hpp"

namespace robochart::diagnostics {

namespace {

Json span_of_lines(Position begin, Position end) {
    return {{"startLine", begin.line}, {"startColumn", begin.column}, {"endLine", end.line}, {"endColumn", end.column}};
}

std::string_view level(Severity severity) {
    if (severity == Severity::error) return "error";
    return severity == Severity::warning ? "warning" : "note";
}

Json region(const SourceManager& sources, Span span) {
    return span_of_lines(sources.position(span.source, span.begin), sources.position(span.source, span.end));
}

Json artifact(const SourceManager& sources, Span span) {
    return {{"uri", uri_of_path(sources.path(span.source))}};
}

Json physical(const SourceManager& sources, Span span) {
    return sarif_place(sources.path(span.source), sources.position(span.source, span.begin),
                       sources.position(span.source, span.end));
}

Json fix_object(const SourceManager& sources, const FixIt& fix) {
    const Json replacement{{"deletedRegion", region(sources, fix.span)},
                           {"insertedContent", sarif_text(fix.replacement)}};
    const Json change{{"artifactLocation", artifact(sources, fix.span)}, {"replacements", Json::array({replacement})}};
    return {{"description", sarif_text(fix.title)}, {"artifactChanges", Json::array({change})}};
}

/// Notes with a place are related locations, the others part of the message.
Json result(const SourceManager& sources, const Diagnostic& diagnostic, std::size_t rule) {
    std::string message = diagnostic.message();
    Json related = Json::array();
    for (const Note& note : diagnostic.notes) {
        if (note.span.known())
            related.push_back({{"id", related.size() + 1},
                               {"physicalLocation", physical(sources, note.span)},
                               {"message", sarif_text(note.message)}});
        else
            message += "; " + note.message;
    }
    Json json{{"ruleId", diagnostic.rule->code},
              {"ruleIndex", rule},
              {"level", level(diagnostic.rule->severity)},
              {"message", sarif_text(message)}};
    if (diagnostic.span.known())
        json["locations"] = Json::array({Json{{"physicalLocation", physical(sources, diagnostic.span)}}});
    if (!related.empty()) json["relatedLocations"] = related;
    for (const FixIt& fix : diagnostic.fixes) json["fixes"].push_back(fix_object(sources, fix));
    return json;
}

Json described(const Rule& rule) {
    return {{"id", rule.code},
            {"shortDescription", sarif_text(rule.message)},
            {"help", sarif_text(rule.explanation)},
            {"defaultConfiguration", {{"level", level(rule.severity)}}}};
}

/// SARIF 2.1.0, 3.20: a run that was cut short says so here; its results are not all.
Json invocation(std::string_view limit) {
    const Json notification{{"level", "error"}, {"message", sarif_text(limit)}};
    return {{"executionSuccessful", false}, {"toolExecutionNotifications", Json::array({notification})}};
}

}  // namespace

std::string render_sarif(const SourceManager& sources, const Diagnostics& diagnostics, std::string_view version,
                         std::string_view limit) {
    const std::vector<Diagnostic> findings = diagnostics.sorted();
    // Rows that share a code are one rule to the readers of SARIF: the first row by place describes it.
    std::vector<const Rule*> rules;
    const auto index = [&](const Diagnostic& d) {
        const auto same =
            std::find_if(rules.begin(), rules.end(), [&](const Rule* r) { return r->code == d.rule->code; });
        if (same == rules.end()) return rules.push_back(d.rule), rules.size() - 1;
        return static_cast<std::size_t>(same - rules.begin());
    };
    Json results = Json::array();
    for (const Diagnostic& each : findings) results.push_back(result(sources, each, index(each)));
    Json descriptions = Json::array();
    for (const Rule* rule : rules) descriptions.push_back(described(*rule));
    return sarif_log(
        descriptions, results, version, limit,
        {{"errors", diagnostics.errors()}, {"warnings", diagnostics.warnings()}, {"dropped", diagnostics.dropped()}});
}

Json sarif_text(std::string_view message) {
    return {{"text", message}};
}

Json sarif_place(std::string_view path, Position begin, Position end) {
    return {{"artifactLocation", {{"uri", uri_of_path(path)}}}, {"region", span_of_lines(begin, end)}};
}

std::string sarif_log(const Json& rules, const Json& results, std::string_view version, std::string_view limit,
                      const Json& properties) {
    const Json driver{{"name", "robochart-verify"}, {"version", version}, {"rules", rules}};
    Json run{{"tool", {{"driver", driver}}}};
    if (!limit.empty()) run["invocations"] = Json::array({invocation(limit)});
    run["columnKind"] = "unicodeCodePoints";
    run["results"] = results;
    run["properties"] = properties;
    return json_text({{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                      {"version", "2.1.0"},
                      {"runs", Json::array({run})}}) +
           "\n";
}

}  // namespace robochart::diagnostics
