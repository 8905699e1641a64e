// Diagnostics as SARIF 2.1.0 (OASIS, 2020): one run, the rules that occur with their help, places with columns in code
// points, fixes as replacements.
#include <fmt/format.h>

#include <algorithm>

#include "diagnostics/escape.hpp"
#include "diagnostics/json.hpp"
#include "diagnostics/render.hpp"

namespace robochart::diagnostics {

namespace {

std::string_view level(Severity severity) {
    if (severity == Severity::error) return "error";
    return severity == Severity::warning ? "warning" : "note";
}

template <class Items, class Write>
std::string array(const Items& items, Write write) {
    std::string out = "[";
    for (const auto& item : items) out += (out.size() > 1 ? "," : "") + write(item);
    return out + "]";
}

std::string region(const SourceManager& sources, Span span) {
    const Position begin = sources.position(span.source, span.begin);
    const Position end = sources.position(span.source, span.end);
    return fmt::format(R"({{"startLine":{},"startColumn":{},"endLine":{},"endColumn":{}}})", begin.line, begin.column,
                       end.line, end.column);
}

std::string artifact(const SourceManager& sources, Span span) {
    return fmt::format(R"({{"uri":{}}})", json_string(uri_of_path(sources.path(span.source))));
}

std::string physical(const SourceManager& sources, Span span) {
    return fmt::format(R"("physicalLocation":{{"artifactLocation":{},"region":{}}})", artifact(sources, span),
                       region(sources, span));
}

std::string text(std::string_view message) {
    return fmt::format(R"({{"text":{}}})", json_string(message));
}

std::string fix(const SourceManager& sources, const FixIt& one) {
    return fmt::format(
        R"({{"description":{},"artifactChanges":[{{"artifactLocation":{},"replacements":[{{"deletedRegion":{},)"
        R"("insertedContent":{}}}]}}]}})",
        text(one.title), artifact(sources, one.span), region(sources, one.span), text(one.replacement));
}

std::string result(const SourceManager& sources, const Diagnostic& diagnostic, std::size_t rule) {
    std::string message = diagnostic.message();
    std::vector<Note> placed;
    for (const Note& note : diagnostic.notes) {
        if (note.span.known()) placed.push_back(note);
        if (!note.span.known()) message += "; " + note.message;
    }
    std::string out =
        fmt::format(R"({{"ruleId":{},"ruleIndex":{},"level":"{}","message":{})", json_string(diagnostic.rule->code),
                    rule, level(diagnostic.rule->severity), text(message));
    if (diagnostic.span.known()) out += fmt::format(R"(,"locations":[{{{}}}])", physical(sources, diagnostic.span));
    std::size_t id = 0;
    const auto related = [&](const Note& note) {
        return fmt::format(R"({{"id":{},{},"message":{}}})", ++id, physical(sources, note.span), text(note.message));
    };
    if (!placed.empty()) out += R"(,"relatedLocations":)" + array(placed, related);
    if (!diagnostic.fixes.empty())
        out += R"(,"fixes":)" + array(diagnostic.fixes, [&](const FixIt& one) { return fix(sources, one); });
    return out + "}";
}

std::string described(const Rule* rule) {
    return fmt::format(R"({{"id":{},"shortDescription":{},"help":{},"defaultConfiguration":{{"level":"{}"}}}})",
                       json_string(rule->code), text(rule->message), text(rule->explanation), level(rule->severity));
}

}  // namespace

namespace {

/// SARIF 2.1.0, 3.20: a run that was cut short says so here; its results are not all.
std::string invocations(std::string_view limit) {
    if (limit.empty()) return {};
    return fmt::format(
        R"("invocations":[{{"executionSuccessful":false,"toolExecutionNotifications":[{{"level":"error","message":{}}}]}}],)",
        text(limit));
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
    const std::string results = array(findings, [&](const Diagnostic& d) { return result(sources, d, index(d)); });
    return fmt::format(
        R"({{"$schema":"https://json.schemastore.org/sarif-2.1.0.json","version":"2.1.0","runs":[{{"tool":{{"driver":{{)"
        R"("name":"robochart-verify","version":{},"rules":{}}}}},{}"columnKind":"unicodeCodePoints","results":{},)"
        R"("properties":{{"errors":{},"warnings":{},"dropped":{}}}}}]}})"
        "\n",
        json_string(version), array(rules, described), invocations(limit), results, diagnostics.errors(), diagnostics.warnings(),
        diagnostics.dropped());
}

}  // namespace robochart::diagnostics
