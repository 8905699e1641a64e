// SPDX-License-Identifier: Apache-2.0
// Resolves names through scopes and imports. An unknown name is reported once, with the known name whose spelling is
// nearest.
#include "frontend/names/name_lookup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/diagnostics/spelling.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/foreign_words.hpp"
#include "frontend/syntax/lexer.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::frontend {

namespace {

constexpr DeclKind all_kinds[] = {DeclKind::primitive_type, DeclKind::record_type, DeclKind::enumeration,
                                  DeclKind::enum_literal,   DeclKind::function,    DeclKind::interface,
                                  DeclKind::platform,       DeclKind::operation,   DeclKind::state_machine,
                                  DeclKind::controller,     DeclKind::module,      DeclKind::reference};

/// Returns the row of foreign_words for this name, if another notation uses the name for this kind of declaration, or
/// null otherwise.
const ForeignWord* foreign_name(std::string_view what, const QualifiedName& name) {
    constexpr std::array<std::pair<std::string_view, ForeignPlace>, 4> places = {
        {{"type", ForeignPlace::type},
         {"operation", ForeignPlace::operation},
         {"event", ForeignPlace::event},
         {"variable, constant, literal or function", ForeignPlace::value}}};
    if (name.parts.size() != 1) return nullptr;
    for (const auto& [looked_for, place] : places)
        if (looked_for == what) return foreign_word(name.parts.front(), place);
    return nullptr;
}

const Declaration* find_other_kind(const Names& names, const Place& place, const QualifiedName& name) {
    for (const DeclKind kind : all_kinds)
        if (const Declaration* found = names.find(place, name, {kind})) return found;
    return nullptr;
}

}  // namespace

const Declaration* Finder::find(const Place& place, const QualifiedName& name, const Kinds& kinds,
                                std::string_view what) {
    if (const Declaration* found = names_.find(place, name, kinds)) return found;
    if (names_.is_lost(name)) return nullptr;
    if (const Declaration* other = find_other_kind(names_, place, name)) {
        diagnostics::Diagnostic& finding =
            out_->report(rules::ambiguous_kind, name.span,
                         {shorten_token(name.text()), std::string(to_text(other->kind)), std::string(what)});
        finding.notes.push_back({other->name_span, "it is declared here"});
        return nullptr;
    }
    const Declaration* const hidden = names_.find_anywhere(name.parts.back(), kinds);
    const std::string full = hidden != nullptr ? names_.full_name(hidden) : std::string();
    const std::size_t cut = full.rfind("::");
    const bool importable = cut != std::string::npos && name.parts.size() == 1;
    // Names that are unknown because of the same missing or unresolved import are reported only once.
    std::string package;
    if (importable)
        package = full.substr(0, cut);
    else if (hidden == nullptr)
        package = lost_import(place);
    if (!package.empty() && !reported_.emplace(name.span.source, "import\n" + package).second) return nullptr;
    diagnostics::Diagnostic& finding = report_unknown(name, what, "that is visible here", candidate_names(kinds));
    if (hidden != nullptr)
        finding.notes.push_back(
            {hidden->name_span, importable
                                    ? fmt::format("there is `{}`; `import {}::*` makes it visible", full, package)
                                    : fmt::format("there is `{}`", full)});
    else if (!package.empty())
        finding.notes.push_back({{},
                                 fmt::format("there is no package `{}`, which the file imports: names that it may "
                                             "have declared are not reported again",
                                             package)});
    return nullptr;
}

/// Returns the first package that the file imports but that does not exist, or "" if all exist.
std::string Finder::lost_import(const Place& place) const {
    if (place.file == nullptr) return {};
    for (const Import& import : place.file->imports) {
        const std::string package = import.name.text();
        if (import.wildcard && !names_.leads_to_package(package) && names_.declarations_of(package).empty())
            return package;
    }
    return {};
}

std::vector<std::string> Finder::candidate_names(const Kinds& kinds) const {
    return out_->error_count() < diagnostics::Diagnostics::max_kept ? names_.names_of_kinds(kinds)
                                                                    : std::vector<std::string>();
}

diagnostics::Diagnostic& Finder::report_unknown(const QualifiedName& name, std::string_view what,
                                                std::string_view where, const std::vector<std::string>& candidates) {
    const ForeignWord* const foreign = foreign_name(what, name);
    std::string key = std::string(what) + "\n" + name.text() + "\n" + std::string(where);
    if (foreign != nullptr) key += "\n" + std::to_string(name.span.begin);  // every place needs its own fix
    const bool reported = !reported_.emplace(name.span.source, key).second;
    if (reported || names_.is_lost(name)) {
        untold_ = {};
        return untold_;
    }
    diagnostics::Diagnostic& finding = out_->report(
        rules::unknown_name, name.span, {std::string(what), shorten_token(name.text()), std::string(where)});
    if (out_->error_count() > diagnostics::Diagnostics::max_kept) return finding;
    const std::string& written = name.parts.back();
    const std::string meant =
        foreign != nullptr ? std::string(foreign->instead) : diagnostics::nearest_spelling(written, candidates);
    if (foreign != nullptr) finding.notes.push_back({{}, std::string(foreign->reason)});
    if (!meant.empty())
        finding.fixes.push_back(
            {name.spans.back(), meant,
             diagnostics::suggestion_verb(foreign != nullptr || diagnostics::is_certain(written, meant, candidates))});
    return finding;
}

}  // namespace robochart::frontend
