// SPDX-License-Identifier: Apache-2.0
// Reports unsupported constructs and quotes the model's text.
#include "csp_emit/base/project.hpp"

#include <algorithm>

#include "base/diagnostics/text.hpp"
#include "checker/cspm/syntax/lexer.hpp"
#include "csp_emit/base/names.hpp"
#include "csp_emit/base/rules.hpp"

namespace robochart::csp_emit {

namespace {

std::size_t times_in(const std::string& text, const std::string& name) {
    std::size_t result = 0;
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
        const bool begins = at == 0 || !cspm::continues_name(text[at - 1]);
        const bool ends = at + name.size() == text.size() || !cspm::continues_name(text[at + name.size()]);
        if (begins && ends) ++result;
    }
    return result;
}

}  // namespace

bool Project::instantiations_replaced() const {
    return std::ranges::any_of(system.csp_blocks,
                               [&](const ir::CspBlock& block) { return replaces_instantiations(block); });
}

std::size_t Project::count_in_blocks(const std::string& name) const {
    std::size_t result = 0;
    for (const ir::CspBlock& block : system.csp_blocks)
        if (block_applies(block)) result += times_in(block.text, name);
    return result;
}

bool Project::blocks_mention(const std::string& name) const {
    return count_in_blocks(name) > 0;
}

bool Project::mentions_component(const std::string& path) const {
    const auto names = [&](const ir::ComponentRef& ref) { return qualified_name(ref.package, ref.path) == path; };
    return blocks_mention(path) || std::ranges::any_of(system.properties, [&](const auto& property) {
               return names(property.subject) || names(property.other);
           });
}

void Project::report_unsupported(const std::string& construct, diagnostics::Span span) const {
    const auto known =
        diagnostics.sorted_findings();  // a statement may be written at several points, but is reported once
    const bool again = std::ranges::any_of(known, [&](const diagnostics::Diagnostic& finding) {
        return finding.rule == &rules::unsupported && finding.span.source == span.source &&
               finding.span.begin == span.begin && finding.arguments.at(0) == construct;
    });
    if (!again) diagnostics.report(rules::unsupported, span, {construct});
}

std::string Project::model_text(diagnostics::Span span) const {
    if (!span.is_known()) return "";
    constexpr std::size_t longest = 80;
    std::string result =
        diagnostics::on_one_line(sources.source_text(span.source).substr(span.begin, span.end - span.begin));
    if (result.size() > longest) result = result.substr(0, longest - 3) + "...";
    return result;
}

}  // namespace robochart::csp_emit
