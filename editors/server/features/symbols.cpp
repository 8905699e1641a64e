// SPDX-License-Identifier: Apache-2.0
// Makes outlines of documents, and searches for names in all projects.
#include <algorithm>
#include <cctype>

#include "editors/server/features/models.hpp"
#include "editors/server/workspace/describe.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::lsp {

namespace {

using namespace frontend;

template <class Items>
void add_all(std::vector<const Declaration*>& list, const Items& items) {
    for (const auto& item : items) list.push_back(&*item);
}

/// Returns the declarations inside a declaration, in textual order, without members of interfaces.
std::vector<const Declaration*> inner_declarations(const Declaration& declaration) {
    std::vector<const Declaration*> list;
    if (const auto* type = dynamic_cast<const TypeDeclaration*>(&declaration)) {
        add_all(list, type->fields);
        add_all(list, type->literals);
    }
    if (const auto* context = dynamic_cast<const Context*>(&declaration)) {
        add_all(list, context->variables);
        add_all(list, context->events);
        add_all(list, context->clocks);
        add_all(list, context->signatures);
        for (const Context* registers : {context->input.get(), context->output.get()})
            if (registers != nullptr) list.push_back(registers);
    }
    if (const auto* component = dynamic_cast<const Component*>(&declaration)) add_all(list, component->order);
    if (const auto* container = dynamic_cast<const NodeContainer*>(&declaration)) {
        add_all(list, container->nodes);
        add_all(list, container->transitions);
    }
    std::ranges::sort(
        list, [](const Declaration* a, const Declaration* b) { return a->name_span.begin < b->name_span.begin; });
    std::erase_if(list, [](const Declaration* inner) { return inner->name.empty() || !inner->name_span.is_known(); });
    return list;
}

/// Returns the span of the declaration together with its parts, because in text with errors, a part may extend beyond
/// the end of the declaration.
Span full_extent(const Declaration& declaration) {
    Span result = join_spans(declaration.span, declaration.name_span);
    for (const Declaration* inner : inner_declarations(declaration)) result = join_spans(result, full_extent(*inner));
    return result;
}

/// Converts a declaration to a DocumentSymbol. The recursion is bounded, because the parser limits nesting.
Json document_symbol(const PositionTable& positions, const Declaration& declaration) {
    Json result = Json::object({{"name", declaration.name},
                                {"detail", detail_of(declaration)},
                                {"kind", symbol_kind(declaration)},
                                {"range", positions.lsp_range(full_extent(declaration))},
                                {"selectionRange", positions.lsp_range(declaration.name_span)}});
    Json children = Json::array();
    for (const Declaration* inner : inner_declarations(declaration))
        children.push_back(document_symbol(positions, *inner));
    if (!children.empty()) result["children"] = std::move(children);
    return result;
}

Json claim_symbol(const PositionTable& positions, const std::string& name, std::string_view what, int kind, Span span,
                  Span name_span) {
    return Json::object({{"name", name},
                         {"detail", std::string(what)},
                         {"kind", kind},
                         {"range", positions.lsp_range(join_spans(span, name_span))},
                         {"selectionRange", positions.lsp_range(name_span)}});
}

/// True if the name contains the letters of `query` in this order, ignoring case.
bool matches_query(std::string_view name, std::string_view query) {
    std::size_t at = 0;
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    for (const char c : name)
        if (at < query.size() && lower(c) == lower(query[at])) ++at;
    return at == query.size();
}

/// Calls `use` for a declaration and for everything inside it.
template <class Use>
void visit_all(const Declaration& declaration, const Use& use) {
    use(declaration);
    for (const Declaration* inner : inner_declarations(declaration)) visit_all(*inner, use);
}

Json symbol_information(const Declaration& declaration, Json place) {
    if (place.is_null()) return {};
    return Json::object({{"name", declaration.name},
                         {"kind", symbol_kind(declaration)},
                         {"location", std::move(place)},
                         {"containerName", declaration.parent != nullptr ? declaration.parent->name : ""}});
}

}  // namespace

Json Models::document_symbols(const Request& request) {
    const Target target = target_of(request);
    const File& file = target.project.tree_of(target.document);
    const PositionTable positions(target.project.sources(), target.document.source, session_.client.encoding);
    Json result = Json::array();
    for (const auto& declaration : file.declarations) {
        if (declaration->name.empty()) continue;
        if (session_.client.hierarchical_symbols) {
            result.push_back(document_symbol(positions, *declaration));
        } else {
            visit_all(*declaration, [&](const Declaration& visited) {
                const Json place =
                    Json::object({{"uri", target.document.uri}, {"range", positions.lsp_range(visited.name_span)}});
                result.push_back(symbol_information(visited, place));
            });
        }
    }
    constexpr int boolean_kind = 17;
    constexpr int function_kind = 12;
    constexpr int constant_kind = 14;
    constexpr int class_kind = 5;
    for (const auto& simulation : file.simulations)
        if (!simulation->name.empty())
            result.push_back(claim_symbol(positions, simulation->name, "simulation", class_kind, simulation->span,
                                          simulation->name_span));
    for (const Assertion& assertion : file.assertions)
        if (!assertion.name.empty())
            result.push_back(claim_symbol(positions, assertion.name, "assertion", boolean_kind, assertion.span,
                                          assertion.name_span));
    for (const CspBlock& block : file.csp_blocks)
        if (!block.name.empty())
            result.push_back(claim_symbol(positions, block.name, "csp", function_kind, block.span, block.name_span));
    for (const ProbabilisticDefinition& definition : file.probabilistic_definitions)
        if (!definition.name.empty())
            result.push_back(claim_symbol(positions, definition.name, to_text(definition.kind), constant_kind,
                                          definition.span, definition.name_span));
    for (const ProbabilisticAssertion& assertion : file.probabilistic_assertions)
        if (!assertion.name.empty())
            result.push_back(claim_symbol(positions, assertion.name,
                                          assertion.property ? "prob property" : "prob generate path", boolean_kind,
                                          assertion.span, assertion.name_span));
    return result;
}

Json Models::workspace_symbols(const std::string& query) {
    constexpr std::size_t limit = 500;
    Json result = Json::array();
    for (const auto& project : workspace_.projects())
        for (const auto& file : project->current_model().files)
            for (const auto& declaration : file->declarations)
                visit_all(*declaration, [&](const Declaration& visited) {
                    if (file->is_library || result.size() >= limit || !matches_query(visited.name, query)) return;
                    Json found = symbol_information(visited, lsp_location(session_, *project, visited.name_span));
                    if (!found.is_null()) result.push_back(std::move(found));
                });
    return result;
}

}  // namespace robochart::lsp
