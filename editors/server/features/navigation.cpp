// SPDX-License-Identifier: Apache-2.0
// Navigates from names to declarations and back.
#include <algorithm>

#include "editors/server/features/models.hpp"
#include "editors/server/workspace/names.hpp"

namespace robochart::lsp {

namespace {

using frontend::Access;
using frontend::NameKind;
using frontend::Occurrence;

Json locations_of(const Session& session, Project& project, const std::vector<const Occurrence*>& list) {
    Json result = Json::array();
    for (const Occurrence* occurrence : list) {
        Json place = lsp_location(session, project, occurrence->span);
        if (!place.is_null()) result.push_back(std::move(place));
    }
    return result;
}

int highlight_kind(Access access) {
    switch (access) {  // DocumentHighlightKind (LSP 3.17)
        case Access::none:
            return 1;
        case Access::read:
            return 2;
        case Access::write:
            break;
    }
    return 3;
}

}  // namespace

/// Finds the places of declarations. For a declaration of a library, this is a place in the installed file. For a call,
/// the results are the called signature and the definitions of the operation.
Json Models::definition(const Request& request) {
    const Target target = target_of(request);
    const Occurrence* name = target.project.occurrence_at(target.document.source, target.offset);
    if (name == nullptr) return {};
    std::vector<const Occurrence*> found;
    for (const Occurrence* occurrence : same_name(target.project, *name))
        if (occurrence->declares) found.push_back(occurrence);
    if (name->target != nullptr && name->target->kind == frontend::DeclKind::operation_signature)
        for (const Occurrence& occurrence : target.project.current_occurrences())
            if (occurrence.declares && occurrence.target != nullptr &&
                occurrence.target->kind == frontend::DeclKind::operation &&
                occurrence.target->name == name->target->name)
                found.push_back(&occurrence);
    Json result = locations_of(session_, target.project, found);
    if (!found.empty() || name->target == nullptr) return result;
    Json library = lsp_location(session_, target.project, name->target->name_span);
    if (!library.is_null()) result.push_back(std::move(library));
    return result;
}

Json Models::references(const Request& request) {
    const Target target = target_of(request);
    const Occurrence* name = target.project.occurrence_at(target.document.source, target.offset);
    if (name == nullptr) return Json::array();
    std::vector<const Occurrence*> found = same_name(target.project, *name);
    if (!request.params["context"]["includeDeclaration"].truth_or(true))
        std::erase_if(found, [](const Occurrence* occurrence) { return occurrence->declares; });
    return locations_of(session_, target.project, found);
}

Json Models::highlights(const Request& request) {
    const Target target = target_of(request);
    const Occurrence* name = target.project.occurrence_at(target.document.source, target.offset);
    Json result = Json::array();
    if (name == nullptr) return result;
    const PositionTable positions(target.project.sources(), target.document.source, session_.client.encoding);
    for (const Occurrence* occurrence : same_name(target.project, *name)) {
        if (occurrence->span.source != target.document.source) continue;
        const int kind = highlight_kind(occurrence->access);
        result.push_back(Json::object({{"range", positions.lsp_range(occurrence->span)}, {"kind", kind}}));
    }
    return result;
}

}  // namespace robochart::lsp
