// Reporting and excerpts.
#include "csp_emit/project.hpp"

#include "csp_emit/rules.hpp"

namespace robochart::csp_emit {

void Project::refuse(const std::string& construct, diagnostics::Span span) const {
    diagnostics.report(rules::unsupported, span, {construct});
}

std::string Project::text(diagnostics::Span span) const {
    if (!span.known()) return "";
    constexpr std::size_t longest = 80;
    std::string result;
    for (const char c : sources.text(span.source).substr(span.begin, span.end - span.begin)) {
        const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
        if (blank && (result.empty() || result.back() == ' ')) continue;
        result += blank ? ' ' : c;
    }
    while (!result.empty() && result.back() == ' ') result.pop_back();
    if (result.size() > longest) result = result.substr(0, longest - 3) + "...";
    return result;
}

}  // namespace robochart::csp_emit
