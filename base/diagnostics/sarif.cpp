// SPDX-License-Identifier: Apache-2.0
// Writes diagnostics as SARIF 2.1.0 (OASIS, 2020): one run, the rules that occur with their help texts, places with
// columns in code points, and fixes as replacements.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/render.hpp"
#include "base/diagnostics/sarif.hpp"

namespace robochart::diagnostics {

namespace {

Json span_of_lines(Position begin, Position end) {
    return {{"startLine", begin.line}, {"startColumn", begin.column}, {"endLine", end.line}, {"endColumn", end.column}};
}

std::string_view level_of_severity(Severity severity) {
    if (severity == Severity::error) return "error";
    return severity == Severity::warning ? "warning" : "note";
}

Json text_region(const SourceManager& sources, Span span) {
    return span_of_lines(sources.position(span.source, span.begin), sources.position(span.source, span.end));
}

Json artifact_location(const SourceManager& sources, Span span) {
    return sarif_file(sources.path(span.source));
}

Json physical_location(const SourceManager& sources, Span span) {
    return sarif_place(sources.path(span.source), sources.position(span.source, span.begin),
                       sources.position(span.source, span.end));
}

Json fix_object(const SourceManager& sources, const FixIt& fix) {
    const Json replacement{{"deletedRegion", text_region(sources, fix.span)},
                           {"insertedContent", sarif_text(fix.replacement)}};
    const Json change{{"artifactLocation", artifact_location(sources, fix.span)},
                      {"replacements", Json::array({replacement})}};
    return {{"description", sarif_text(fix.title)}, {"artifactChanges", Json::array({change})}};
}

/// Returns the first line of a finding without the blanks around it. This text does not change when lines are added
/// above it.
std::string_view line_of(const SourceManager& sources, Span span) {
    std::string_view line = sources.line_text(span.source, sources.position(span.source, span.begin).line);
    constexpr std::string_view space = " \t\r";
    line.remove_prefix(std::min(line.find_first_not_of(space), line.size()));
    return line.substr(0, line.find_last_not_of(space) + 1);
}

/// Converts a finding to a result. Notes with a place become related locations; the other notes become part of the
/// message.
Json sarif_result(const SourceManager& sources, const Diagnostic& diagnostic, std::size_t rule) {
    std::string message = diagnostic.message();
    Json related = Json::array();
    for (const Note& note : diagnostic.notes) {
        if (note.span.is_known())
            related.push_back({{"id", related.size() + 1},
                               {"physicalLocation", physical_location(sources, note.span)},
                               {"message", sarif_text(note.message)}});
        else
            message += "; " + note.message;
    }
    Json json{{"ruleId", diagnostic.rule->code},
              {"ruleIndex", rule},
              {"level", level_of_severity(diagnostic.rule->severity)},
              {"message", sarif_text(message)}};
    json["locations"] = Json::array({Json{{"physicalLocation", physical_location(sources, diagnostic.span)}}});
    json["partialFingerprints"] = sarif_fingerprint(diagnostic.rule->code, line_of(sources, diagnostic.span));
    if (!related.empty()) json["relatedLocations"] = related;
    for (const FixIt& fix : diagnostic.fixes) json["fixes"].push_back(fix_object(sources, fix));
    return json;
}

/// Returns an invocation, which states that the results are incomplete if the run was cut short (SARIF 2.1.0, 3.20). It
/// also contains the findings that are not results.
Json sarif_invocation(const SarifRun& run) {
    Json notifications = Json::array();
    if (!run.limit.empty()) notifications.push_back({{"level", "error"}, {"message", sarif_text(run.limit)}});
    bool failed = !run.limit.empty();
    for (const Json& notification : run.notifications) {
        notifications.push_back(notification);
        failed = failed || notification.at("level") == "error";
    }
    return {{"executionSuccessful", !failed}, {"toolExecutionNotifications", notifications}};
}

/// Converts a title to an identifier: "A state is never reached" becomes `AStateIsNeverReached`.
std::string identifier_of_title(std::string_view title) {
    std::string name;
    bool begins = true;
    for (const char c : title) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x80 || std::isalnum(byte) == 0) {
            begins = true;
            continue;
        }
        name += begins ? static_cast<char>(std::toupper(byte)) : c;
        begins = false;
    }
    return name;
}

/// Returns the text with a full stop at its end.
std::string with_full_stop(std::string_view text) {
    return std::string(text) + (text.ends_with('.') ? "" : ".");
}

std::string capitalize_first(std::string_view text) {
    std::string result(text);
    if (!result.empty()) result.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(result.front())));
    return result;
}

}  // namespace

std::string render_sarif(const SourceManager& sources, const Diagnostics& diagnostics, const SarifRules& about) {
    const std::vector<Diagnostic> findings = diagnostics.sorted_findings();
    // Rows of the rule table that share a code are one rule in SARIF. The row whose finding comes first describes it.
    std::vector<const Rule*> rules;
    const auto index = [&](const Diagnostic& d) {
        const auto same = std::ranges::find_if(rules, [&](const Rule* r) { return r->code == d.rule->code; });
        const auto position = static_cast<std::size_t>(same - rules.begin());
        if (same == rules.end()) rules.push_back(d.rule);
        return position;
    };
    SarifRun run;
    run.version = about.version;
    run.what = about.what;
    run.limit = about.limit;
    for (const Diagnostic& finding : findings) {
        if (finding.span.is_known())
            run.results.push_back(sarif_result(sources, finding, index(finding)));
        else
            run.notifications.push_back(
                sarif_notification(finding.rule->code, level_of_severity(finding.rule->severity), finding.message()));
    }
    for (const Rule* rule : rules)
        run.rules.push_back(
            sarif_rule(rule->code, about.title(*rule), about.reason(*rule), level_of_severity(rule->severity)));
    run.properties = {{"errors", diagnostics.error_count()},
                      {"warnings", diagnostics.warning_count()},
                      {"dropped", diagnostics.dropped_count()}};
    return sarif_log(run);
}

Json sarif_text(std::string_view message) {
    return {{"text", message}};
}

Json sarif_file(std::string_view path) {
    namespace fs = std::filesystem;
    fs::path file = fs::path(path).lexically_normal();
    if (file.is_absolute()) {
        std::error_code lost;
        const fs::path relative = file.lexically_relative(fs::current_path(lost));
        if (!lost && !relative.empty() && *relative.begin() != "..") file = relative;
    }
    if (file.is_absolute()) return {{"uri", uri_of_path(file.string())}};
    return {{"uri", uri_of_path(file.string())}, {"uriBaseId", "%SRCROOT%"}};
}

Json sarif_place(std::string_view path, Position begin, Position end) {
    return {{"artifactLocation", sarif_file(path)}, {"region", span_of_lines(begin, end)}};
}

Json sarif_rule(std::string_view id, std::string_view title, std::string_view text, std::string_view level) {
    const std::string full = with_full_stop(capitalize_first(text.empty() ? title : text));
    return {{"id", id},
            {"name", identifier_of_title(title)},
            {"shortDescription", sarif_text(with_full_stop(capitalize_first(title)))},
            {"fullDescription", sarif_text(full)},
            {"help", sarif_text(full)},
            {"defaultConfiguration", {{"level", level}}}};
}

/// Computes FNV-1a with 64 bits. This suffices, because a log need not be secure against the author of the model.
Json sarif_fingerprint(std::string_view rule, std::string_view subject) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    const auto take = [&](std::string_view text) {
        for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    };
    take(rule);
    take("\n");
    take(subject);
    return {{"primaryLocationLineHash", fmt::format("{:016x}", hash)}};
}

Json sarif_notification(std::string_view rule, std::string_view level, std::string_view message) {
    return {{"descriptor", {{"id", rule}}}, {"level", level}, {"message", sarif_text(message)}};
}

std::string sarif_log(const SarifRun& run) {
    const Json driver{{"name", "robochart-verify"},
                      {"version", run.version},
                      {"semanticVersion", run.version},
                      // The program has no website, so this is the website of its language.
                      {"informationUri", "https://robostar.cs.york.ac.uk/"},
                      {"rules", run.rules}};
    Json json{{"tool", {{"driver", driver}}}, {"automationDetails", {{"id", run.what + "/"}}}};
    if (!run.limit.empty() || !run.notifications.empty()) json["invocations"] = Json::array({sarif_invocation(run)});
    json["columnKind"] = "unicodeCodePoints";
    json["results"] = run.results;
    json["properties"] = run.properties;
    return json_text({{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                      {"version", "2.1.0"},
                      {"runs", Json::array({json})}}) +
           "\n";
}

}  // namespace robochart::diagnostics
