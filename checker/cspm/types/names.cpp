// SPDX-License-Identifier: Apache-2.0
// Looks up names and reports unknown names.
#include "checker/cspm/types/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/diagnostics/spelling.hpp"
#include "checker/cspm/types/builtins.hpp"
#include "checker/cspm/types/rules.hpp"

namespace robochart::cspm::types {

std::unique_ptr<ResolvedScript> NameResolver::run(const Script& script) {
    script_ = std::make_unique<ResolvedScript>();
    Place place;
    place.scope = new_scope(nullptr);
    place.top = true;
    scope_ = place.scope;
    script_->top = resolve_declarations(script.decls, place);
    return std::move(script_);
}

NameResolver::Scope* NameResolver::new_scope(Scope* parent) {
    scopes_.emplace_back().parent = parent;
    return &scopes_.back();
}

Symbol& NameResolver::new_symbol(const std::string& name, Span span, SymbolKind kind) {
    Symbol& symbol = script_->symbols.emplace_back();
    symbol.name = name;
    symbol.span = span;
    symbol.kind = kind;
    symbol.number = script_->symbols.size();
    return symbol;
}

diagnostics::Diagnostic& NameResolver::report(const diagnostics::Rule& rule, Span span,
                                              std::vector<std::string> arguments) {
    return diagnostics_->report(rule, span, std::move(arguments));
}

// ---------------------------------------------------------------- looking up

const Entry* NameResolver::find_plain(std::string_view name) const {
    for (const Scope* scope = scope_; scope != nullptr; scope = scope->parent) {
        const auto found = scope->names.find(name);
        if (found != scope->names.end()) return &found->second;
    }
    return nullptr;
}

// Finds the meaning of a name. M::x is one name, as in FDR. So a variable M does not hide it, and neither does an inner
// module M without x. But an inner module M with a private x hides an x in an outer module M.
NameResolver::Lookup NameResolver::find(std::string_view name) {
    const std::size_t colons = name.find("::");
    if (colons == std::string_view::npos) {
        const Entry* entry = find_plain(name);
        using enum BuiltinTypes::Where;
        if (entry == nullptr) return {{builtins_.find(name, timed_ ? timed_section : script), nullptr}, ""};
        return {*entry, ""};
    }
    for (const Scope* scope = scope_; scope != nullptr; scope = scope->parent) {
        const auto found = scope->names.find(name.substr(0, colons));
        if (found == scope->names.end() || found->second.module == nullptr) continue;
        Lookup inside = find_inside(*found->second.module, name.substr(colons + 2));
        const bool known = inside.entry.symbol != nullptr || inside.entry.module != nullptr;
        if (known || !inside.hint.empty()) return inside;
    }
    return {};
}

NameResolver::Lookup NameResolver::find_inside(const Module& module, std::string_view path) {
    if (module.parametrised && module.original == nullptr) {
        return {{}, "module '" + module.name + "' has parameters: make an instance of it"};
    }
    const std::size_t colons = path.find("::");
    const std::string_view part = path.substr(0, colons);
    const auto found = module.exported.find(part);
    if (found == module.exported.end()) {
        const bool hidden = module.hidden.contains(part);
        return {{}, hidden ? "it is private to module '" + module.name + "': declare it below `exports`" : ""};
    }
    if (colons == std::string_view::npos) return {found->second, ""};
    return found->second.module == nullptr ? Lookup{} : find_inside(*found->second.module, path.substr(colons + 2));
}

namespace {

/// Returns the predefined name for which another spelling or notation is common.
std::string_view predefined_for(std::string_view name) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 14> rows = {{{"int", "Int"},
                                                                                     {"integer", "Int"},
                                                                                     {"bool", "Bool"},
                                                                                     {"boolean", "Bool"},
                                                                                     {"char", "Char"},
                                                                                     {"Stop", "STOP"},
                                                                                     {"stop", "STOP"},
                                                                                     {"Skip", "SKIP"},
                                                                                     {"skip", "SKIP"},
                                                                                     {"Chaos", "CHAOS"},
                                                                                     {"Run", "RUN"},
                                                                                     {"TRUE", "true"},
                                                                                     {"FALSE", "false"},
                                                                                     {"events", "Events"}}};
    const auto* const found = std::ranges::find(rows, name, &std::pair<std::string_view, std::string_view>::first);
    return found == rows.end() ? std::string_view() : found->second;
}

std::vector<std::string> members_of(const Module& module, std::string_view prefix) {
    std::vector<std::string> result;
    for (const auto& [name, entry] : module.exported)
        if (entry.symbol != nullptr) result.push_back(fmt::format("{}::{}", prefix, name));
    return result;
}

}  // namespace

/// Returns the qualified name of a member if the user probably omitted the module.
std::string NameResolver::in_a_module(std::string_view name) {
    for (const Scope* scope = scope_; scope != nullptr; scope = scope->parent)
        for (const auto& [known, entry] : scope->names) {
            if (entry.module == nullptr || (entry.module->parametrised && entry.module->original == nullptr)) continue;
            std::string full = fmt::format("{}::{}", known, name);
            if (find(full).entry.symbol != nullptr) return full;
        }
    return "";
}

/// Suggests a correction for a qualified name. In this order: the last part alone if it is known; the only member whose
/// name is longer (the channel `moveCall` for `move`); the most similar member.
std::string NameResolver::suggest_member(std::string_view name) {
    const std::size_t colons = name.rfind("::");
    if (colons == std::string_view::npos) return "";
    const std::string last(name.substr(colons + 2));
    const Lookup inside = find(name.substr(0, colons));
    if (inside.entry.module == nullptr) return in_a_module(name);
    const std::vector<std::string> members = members_of(*inside.entry.module, name.substr(0, colons));
    if (const Entry* const plain = find_plain(last); plain != nullptr && plain->symbol != nullptr) return last;
    std::string longer;
    for (const std::string& member : members) {
        if (!member.starts_with(name)) continue;
        if (!longer.empty()) return diagnostics::nearest_spelling(name, members);
        longer = member;
    }
    return longer.empty() ? diagnostics::nearest_spelling(name, members) : longer;
}

// Suggests a correction for a name. In this order: a predefined name with another spelling; a member of a module; the
// most similar of the names in scope and the predefined names.
std::string NameResolver::suggest_name(std::string_view name) {
    if (const std::string_view own = predefined_for(name); !own.empty()) return std::string(own);
    if (std::string member = suggest_member(name); !member.empty()) return member;
    std::vector<std::string> candidates;
    const std::string ending = "::" + std::string(name);
    for (const Scope* scope = scope_; scope != nullptr; scope = scope->parent)
        for (const auto& [known, entry] : scope->names) {
            if (entry.symbol != nullptr) candidates.push_back(known);
            if (entry.module == nullptr || (entry.module->parametrised && entry.module->original == nullptr)) continue;
            for (std::string& member : members_of(*entry.module, known)) {
                if (member.ends_with(ending)) return member;
                if (name.find("::") != std::string_view::npos) candidates.push_back(std::move(member));
            }
        }
    for (const BuiltinName& builtin : builtin_names())
        if (builtin.visibility == Visibility::always) candidates.emplace_back(builtin.name);
    return name.size() < 3 ? "" : diagnostics::nearest_spelling(name, candidates);
}

void NameResolver::report_not_found(std::string_view name, Span span, const std::string& hint) {
    script_->names_missing = true;
    diagnostics::Diagnostic& finding = report(rules::not_in_scope, span, {std::string(name)});
    const std::string_view line = BuiltinTypes::hint(name);
    if (!hint.empty()) {
        finding.notes.push_back({span, hint});
    } else if (line == "timed") {
        finding.notes.push_back({span, "it exists in timed sections only"});
    } else if (!line.empty()) {
        finding.notes.push_back(
            {span, "make it known by a line `" + std::string(line) + " " + std::string(name) + "`"});
    } else if (const std::string other = suggest_name(name); !other.empty()) {
        finding.notes.push_back({span, "did you mean '" + other + "'?"});
    }
}

Symbol* NameResolver::value_named(std::string_view name, Span span) {
    const Lookup found = find(name);
    if (found.entry.symbol != nullptr) {
        record_use(found.entry.symbol);
        return found.entry.symbol;
    }
    if (found.entry.module != nullptr) {
        script_->names_missing = true;
        report(rules::wrong_kind_of_name, span, {std::string(name), "a module", "a value"});
    } else {
        report_not_found(name, span, found.hint);
    }
    return nullptr;
}

void NameResolver::record_use(Symbol* symbol) {
    if (symbol->owner == nullptr) return;
    for (Declaration* declaration = current_; declaration != nullptr; declaration = declaration->enclosing)
        declaration->uses.push_back(symbol);
}

// ---------------------------------------------------------------- entering

void NameResolver::enter_name(const Place& place, const std::string& name, const Entry& entry, Span span) {
    const auto [at, fresh] = place.scope->names.emplace(name, entry);
    if (!fresh) {
        const Entry& first = at->second;
        diagnostics::Diagnostic& finding = report(rules::declared_twice, span, {name});
        const Span where = first.module != nullptr ? first.module->span : first.symbol->span;
        if (where.is_known()) finding.notes.push_back({where, "the other declaration"});
        return;
    }
    if (place.module == nullptr) return;
    (place.exported ? place.module->exported : place.module->hidden).emplace(name, entry);
}

Symbol* NameResolver::declare_symbol(const Item& item, const std::string& name, Span span, SymbolKind kind) {
    Symbol& symbol = new_symbol(item.place.prefix + name, span, kind);
    symbol.owner = item.declaration;
    item.declaration->binds.push_back(&symbol);
    enter_name(item.place, name, {&symbol, nullptr}, span);
    if (item.place.top) script_->shown.push_back(&symbol);
    return &symbol;
}

}  // namespace robochart::cspm::types
