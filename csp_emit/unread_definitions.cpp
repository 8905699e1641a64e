// SPDX-License-Identifier: Apache-2.0
// See unread_definitions.hpp.
#include "csp_emit/unread_definitions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/spelling.hpp"
#include "csp_emit/base/rules.hpp"
#include "csp_emit/robotool_names.hpp"

namespace robochart::csp_emit {
namespace {

/// True if the script of the other semantics has already reported this finding.
bool is_known(const Project& project, diagnostics::Span place) {
    const auto known = project.diagnostics.sorted_findings();
    return std::ranges::any_of(known, [&](const diagnostics::Diagnostic& finding) {
        return finding.rule == &rules::definition_unread && finding.span == place;
    });
}

/// Returns the place of the first occurrence of a name inside another place.
diagnostics::Span name_in(const Project& project, diagnostics::Span place, const std::string& name) {
    const std::size_t at = project.sources.source_text(place.source).find(name, place.begin);
    if (at == std::string::npos) return place;
    return {place.source, static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(at + name.size())};
}

/// True if the name has the form of RoboTool's names of carriers and constants.
bool is_of_instantiations(const std::string& name) {
    return name.starts_with("core_") || name.starts_with("const_");
}

}  // namespace

void check_instantiations_read(const Project& project,
                               const std::map<std::string, std::vector<BlockDefinition>>& definitions,
                               const std::set<std::string>& known, const std::vector<std::string>& left_out) {
    for (const auto& [name, clauses] : definitions) {
        if (known.count(name) != 0 || project.count_in_blocks(name) > clauses.size()) continue;
        const diagnostics::Span place = clauses.front().place;
        const std::string carrier = name_of_carrier(name);
        const bool old = std::ranges::find(left_out, carrier) != left_out.end();
        const std::string meant = old ? carrier : diagnostics::nearest_spelling(name, left_out);
        if ((meant.empty() && !is_of_instantiations(name)) || is_known(project, place)) continue;
        std::string hint;
        if (old)
            hint = fmt::format("; its name is now '{}'", carrier);
        else if (!meant.empty())
            hint = fmt::format("; did you mean '{}'?", meant);
        diagnostics::Diagnostic& finding = project.diagnostics.report(rules::definition_unread, place, {name, hint});
        if (old) finding.fixes.push_back({name_in(project, place, name), carrier, "today's name"});
    }
}

}  // namespace robochart::csp_emit
