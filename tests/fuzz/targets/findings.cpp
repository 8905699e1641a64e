// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/targets/findings.hpp"

#include "base/diagnostics/render.hpp"

namespace robochart::fuzz {

namespace {

bool in_range(const diagnostics::SourceManager& sources, const diagnostics::Span& span) {
    return span.is_known() && static_cast<std::size_t>(span.source) < sources.size() && span.begin <= span.end &&
           span.end <= sources.source_text(span.source).size();
}

bool all_in_range(const diagnostics::SourceManager& sources, const diagnostics::Diagnostic& finding) {
    for (const diagnostics::Note& note : finding.notes)
        if (note.span.is_known() && !in_range(sources, note.span)) return false;  // a note may have no place
    for (const diagnostics::FixIt& fix : finding.fixes)
        if (!in_range(sources, fix.span)) return false;
    return in_range(sources, finding.span);
}

}  // namespace

std::string check_findings(const diagnostics::SourceManager& sources, const diagnostics::Diagnostics& findings) {
    for (const diagnostics::Diagnostic& finding : findings.sorted_findings()) {
        if (!all_in_range(sources, finding))
            return "a finding has a place outside the text: " + std::string(finding.rule->code) + " " +
                   finding.message();
        if (finding.message().empty()) return "a finding says nothing: " + std::string(finding.rule->code);
    }
    if (!findings.empty() && diagnostics::render_text(sources, findings).empty())
        return "findings are drawn as nothing";
    if (diagnostics::render_json(sources, findings).empty()) return "findings have no JSON";
    return {};
}

}  // namespace robochart::fuzz
