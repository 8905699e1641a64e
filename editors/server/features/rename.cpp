// SPDX-License-Identifier: Apache-2.0
// Renames in a whole project. Names that are matched only by equality are renamed together: an operation and the
// signatures that it implements, a required variable and the variable that provides it (language reference 2, C3, C4,
// STM8 to STM10).
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "editors/server/features/models.hpp"
#include "editors/server/renaming/rename_blocks.hpp"
#include "editors/server/renaming/rename_check.hpp"
#include "editors/server/workspace/names.hpp"
#include "frontend/syntax/lexer.hpp"

namespace robochart::lsp {

namespace {

using frontend::Declaration;
using frontend::DeclKind;
using frontend::NameKind;
using frontend::Occurrence;

[[noreturn]] void refuse_rename(const std::string& why) {
    throw Refusal(ErrorCode::request_failed, why);
}

std::string_view text_of(Project& project, Span span) {
    return project.sources().source_text(span.source).substr(span.begin, span.end - span.begin);
}

bool is_declared_here(Project& project, const Occurrence& name) {
    const auto all = same_name(project, name);
    return std::ranges::any_of(all, [](const Occurrence* occurrence) { return occurrence->declares; });
}

/// Returns the name to rename. Throws a refusal if it cannot be renamed.
const Occurrence& find_renamable(const Target& target) {
    const Occurrence* name = target.project.occurrence_at(target.document.source, target.offset);
    if (name == nullptr) refuse_rename("there is no name here");
    switch (name->kind) {
        case NameKind::core_type:
            refuse_rename(fmt::format("`{}` belongs to the language", text_of(target.project, name->span)));
        case NameKind::type_variable:
            refuse_rename("type variables cannot be renamed");
        case NameKind::process:
            refuse_rename("a CSP process is named in CSP text too, which is not changed");
        case NameKind::definition:
            refuse_rename(
                fmt::format("`{}` may be named in files that are not read", text_of(target.project, name->span)));
        case NameKind::unknown:
            refuse_rename(fmt::format("it is not known what `{}` stands for", text_of(target.project, name->span)));
        case NameKind::declaration:
        case NameKind::package:
        case NameKind::assertion:
            break;
    }
    if (!is_declared_here(target.project, *name))
        refuse_rename(fmt::format("`{}` comes with the tool", text_of(target.project, name->span)));
    return *name;
}

/// Returns the name as it must be written in a file, with `^` if it would be read as a keyword.
std::string name_as_written(const std::string& name, const Document& document) {
    const auto& words = frontend::assertion_words();
    const bool word = document.is_assertions && std::ranges::find(words, name) != words.end();
    const bool collection = name == "Set" || name == "Seq";
    const bool reserved = frontend::is_reserved(name, frontend::dialect_of(document.path));
    return word || collection || reserved ? "^" + name : name;
}

/// Returns the new name without `^`. Throws a refusal if it is not a valid name.
std::string check_new_name(const std::string& wish) {
    const bool escaped = wish.starts_with("^");
    const std::string name = escaped ? wish.substr(1) : wish;
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    const auto digit = [](char c) { return c >= '0' && c <= '9'; };
    const bool good = !name.empty() && letter(name.front()) &&
                      std::ranges::all_of(name, [&](char c) { return letter(c) || digit(c); });
    if (!good) refuse_rename(fmt::format("`{}` is no name: letters, digits and `_`, not beginning with a digit", wish));
    if (!escaped && frontend::is_reserved(name))
        refuse_rename(fmt::format("`{}` is a reserved word; `^{}` would be the name", name, name));
    return name;
}

/// True for kinds whose declarations are matched by name between components.
bool same_family(DeclKind a, DeclKind b) {
    const auto group = [](DeclKind kind) {
        if (kind == DeclKind::operation_signature || kind == DeclKind::operation) return 1;
        if (kind == DeclKind::variable || kind == DeclKind::constant) return 2;
        if (kind == DeclKind::event) return 3;
        return kind == DeclKind::clock ? 4 : 0;
    };
    return group(a) != 0 && group(a) == group(b);
}

/// Returns the occurrences of equal names that other components may match with this occurrence.
std::vector<const Occurrence*> related_occurrences(Project& project, const Occurrence& name) {
    std::set<const Declaration*> members;
    for (const Occurrence& occurrence : project.current_occurrences())
        if (occurrence.declares && occurrence.target != nullptr && occurrence.target->name == name.target->name &&
            same_family(occurrence.target->kind, name.target->kind))
            members.insert(occurrence.target);
    std::vector<const Occurrence*> result;
    for (const Occurrence& occurrence : project.current_occurrences())
        if (members.contains(occurrence.target)) result.push_back(&occurrence);
    return result;
}

std::vector<Edit> edits_of(Project& project, const std::vector<const Occurrence*>& list, const std::string& name) {
    std::vector<Edit> edits;
    for (const Occurrence* occurrence : list) {
        const Document* document = project.find(occurrence->span.source);
        if (document != nullptr) edits.push_back({occurrence->span, name_as_written(name, *document)});
    }
    return edits;
}

/// Returns the edits of the smallest set of names that can be renamed together without changing a meaning.
std::vector<Edit> harmless_edits(Project& project, const Occurrence& name, const std::string& wish) {
    const bool by_name = name.kind == NameKind::declaration && same_family(name.target->kind, name.target->kind);
    const bool always_together =
        by_name && (name.target->kind == DeclKind::operation || name.target->kind == DeclKind::operation_signature);
    std::vector<Edit> alone = edits_of(project, same_name(project, name), wish);
    std::string harm = always_together ? "not tried" : harm_of(project, alone);
    if (harm.empty()) return alone;
    if (by_name) {
        std::vector<Edit> together = edits_of(project, related_occurrences(project, name), wish);
        const std::string harm_together = harm_of(project, together);
        if (harm_together.empty()) return together;
        if (always_together) harm = harm_together;
    }
    refuse_rename(fmt::format("`{}` would not do: {}", wish, harm));
}

Json workspace_edit(const Session& session, Project& project, const std::vector<Edit>& edits) {
    Json changes;
    Json documents = Json::array();
    for (const auto& [path, document] : project.documents()) {
        Json list = Json::array();
        const PositionTable positions(project.sources(), document->source, session.client.encoding);
        for (const Edit& edit : edits)
            if (edit.span.source == document->source)
                list.push_back(Json::object({{"range", positions.lsp_range(edit.span)}, {"newText", edit.text}}));
        if (list.empty()) continue;
        const Json version = document->version ? Json(*document->version) : Json();
        documents.push_back(Json::object(
            {{"textDocument", Json::object({{"uri", document->uri}, {"version", version}})}, {"edits", list}}));
        changes[document->uri] = std::move(list);
    }
    if (session.client.versioned_edits) return Json::object({{"documentChanges", std::move(documents)}});
    return Json::object({{"changes", std::move(changes)}});
}

/// Warns that CSP text may refer to the name. The user must change such text by hand.
void warn_of_csp_text(const Session& session, Project& project, std::string_view name) {
    for (const auto& file : project.current_model().files)
        for (const frontend::CspBlock& block : file->csp_blocks) {
            if (block.text.find(name) == std::string::npos) continue;
            constexpr int warning = 2;
            const std::string text = fmt::format("CSP blocks may speak of `{}` too, and are not changed: {}", name,
                                                 project.sources().path_and_line(block.name_span));
            session.send(Json::object({{"jsonrpc", "2.0"},
                                       {"method", "window/showMessage"},
                                       {"params", Json::object({{"type", warning}, {"message", text}})}}));
            return;
        }
}

}  // namespace

Json Models::prepare_rename(const Request& request) {
    const Target target = target_of(request);
    const Occurrence& name = find_renamable(target);
    return Json::object({{"range", lsp_range(target.project.sources(), name.span, session_.client.encoding)},
                         {"placeholder", text_of(target.project, name.span)}});
}

Json Models::rename(const Request& request) {
    const Target target = target_of(request);
    const Occurrence& name = find_renamable(target);
    const std::string wish = check_new_name(request.params["newName"].text());
    std::vector<Edit> edits = harmless_edits(target.project, name, wish);
    std::string_view old = text_of(target.project, name.span);
    if (old.starts_with("^")) old.remove_prefix(1);
    const auto in_blocks = edits_of_blocks(target.project, std::string(old), wish, edits, session_.budget);
    if (in_blocks && !in_blocks->empty())
        edits.insert(edits.end(), in_blocks->begin(), in_blocks->end());
    else
        warn_of_csp_text(session_, target.project, old);
    return workspace_edit(session_, target.project, edits);
}

}  // namespace robochart::lsp
