// SPDX-License-Identifier: Apache-2.0
// Reports imports of packages or declarations that neither the project nor a toolkit declares (RC-N04; language
// reference 1.3). RoboTool ignores such imports silently.
#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/spelling.hpp"
#include "frontend/checks/checks.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/toolkits/toolkits.hpp"

namespace robochart::frontend {

namespace {

std::string join_parts(const std::vector<std::string>& parts, std::size_t count) {
    return fmt::format("{}", fmt::join(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(count), "::"));
}

class Imports {
public:
    Imports(const Names& names, Diagnostics& out) : names_(names), out_(out), packages_(names.packages()) {
        for (const Toolkit& toolkit : all_toolkits()) packages_.emplace_back(toolkit.package);
    }

    void check(const Import& import) {
        const std::string full = import.name.text();
        if (import.name.empty() || names_.is_lost(import.name)) return;
        if (!names_.declarations_of(full).empty() || names_.leads_to_package(full)) return;
        const std::string owner = join_parts(import.name.parts, import.name.parts.size() - 1);
        if (!import.wildcard && !owner.empty() && names_.has_package(owner)) return unknown_member(import, owner);
        unknown_package(import, import.wildcard || owner.empty() ? full : owner);
    }

private:
    void unknown_member(const Import& import, const std::string& package) {
        const std::string& member = import.name.parts.back();
        const std::string inside = package + "::";
        std::vector<std::string> members;
        for (auto entry = names_.entries().lower_bound(inside);
             entry != names_.entries().end() && entry->first.starts_with(inside); ++entry)
            if (entry->first.find("::", inside.size()) == std::string::npos)
                members.push_back(entry->first.substr(inside.size()));
        auto& finding =
            out_.report(rules::unknown_import, import.name.span,
                        {import.name.text(), fmt::format("no declaration `{}` in package `{}`", member, package)});
        const std::string meant = diagnostics::nearest_spelling(member, members);
        if (!meant.empty())
            finding.fixes.push_back({import.name.spans.back(), meant,
                                     diagnostics::suggestion_verb(diagnostics::is_certain(member, meant, members))});
    }

    void unknown_package(const Import& import, const std::string& package) {
        auto& finding = out_.report(rules::unknown_import, import.name.span,
                                    {import.name.text(), fmt::format("no package `{}`", package)});
        const std::string meant = diagnostics::nearest_spelling(package, packages_);
        if (meant.empty()) return;
        const Span& last = import.name.spans.at(static_cast<std::size_t>(std::ranges::count(package, ':')) / 2);
        const Span& first = import.name.spans.front();
        finding.fixes.push_back({{first.source, first.begin, last.end},
                                 meant,
                                 diagnostics::suggestion_verb(diagnostics::is_certain(package, meant, packages_))});
    }

    const Names& names_;
    Diagnostics& out_;
    std::vector<std::string> packages_;
};

}  // namespace

void check_imports(const Model& model, const Names& names, Diagnostics& out) {
    // If a syntax error hides the package name of one file, any import could refer to that file, so none is reported.
    for (const auto& file : model.files)
        if (file->has_syntax_errors && file->package.empty()) return;
    Imports imports(names, out);
    for (const auto& file : model.files) {
        if (file->is_library) continue;
        for (const Import& import : file->imports) imports.check(import);
    }
}

}  // namespace robochart::frontend
