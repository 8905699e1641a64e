// SPDX-License-Identifier: Apache-2.0
// Draws the diagram of the component at a place, with the places of its elements in the text. While the text has syntax
// errors, the last picture is used.
#include "editors/server/features/diagram.hpp"

#include <algorithm>
#include <utility>

#include "editors/server/features/models.hpp"
#include "frontend/diagrams/layout/arrange.hpp"
#include "frontend/diagrams/stored/stored_diagrams.hpp"
#include "frontend/diagrams/svg/svg.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::lsp {

namespace {

using diagrams::Subject;

/// The parameters of a request.
struct DiagramParameters {
    bool at_position = false;
    std::string component;  ///< "" for none
    diagrams::Theme theme = diagrams::Theme::automatic;
};

[[noreturn]] void refuse_diagram(const char* why) {
    throw Refusal(ErrorCode::invalid_params, why);
}

diagrams::Theme theme_of(View theme) {
    if (theme.is_null() || theme.text() == "auto") return diagrams::Theme::automatic;
    if (theme.text() == "light") return diagrams::Theme::light;
    if (theme.text() == "dark") return diagrams::Theme::dark;
    refuse_diagram("theme must be `auto`, `light` or `dark`");
}

DiagramParameters diagram_parameters(View params) {
    const View position = params["position"];
    const View component = params["component"];
    if (!position.is_null() && !(position["line"].is_number() && position["character"].is_number()))
        refuse_diagram("position must have a line and a character");
    if (!component.is_null() && !component.is_text()) refuse_diagram("component must be a text");
    return {!position.is_null(), component.text(), theme_of(params["theme"])};
}

// ---------------------------------------------------------------- the requested component

Span span_of_declaration(const frontend::Declaration& declaration) {
    return diagnostics::join_spans(declaration.span, declaration.name_span);
}

bool contains_cursor(Span span, const Target& target) {
    return span.source == target.document.source && span.begin <= target.offset && target.offset <= span.end;
}

/// True if the place is in a type, function or interface. The diagram of a package shows these.
bool is_in_package(const Subject& subject, const Target& target) {
    const auto has_place = [&](const frontend::File* file) {
        return std::ranges::any_of(file->declarations, [&](const auto& declaration) {
            return contains_cursor(span_of_declaration(*declaration), target);
        });
    };
    return std::ranges::any_of(subject.files, has_place);
}

/// Returns the innermost component that contains a place; null if there is none.
const Subject* subject_at(const std::vector<Subject>& subjects, const Target& target) {
    const Subject* best = nullptr;
    std::uint32_t least = 0;
    for (const Subject& subject : subjects) {
        if (subject.component == nullptr) continue;
        const Span span = span_of_declaration(*subject.component);
        if (!contains_cursor(span, target) || (best != nullptr && span.end - span.begin >= least)) continue;
        best = &subject;
        least = span.end - span.begin;
    }
    if (best != nullptr) return best;
    const auto package = std::ranges::find_if(subjects, [&](const Subject& subject) {
        return subject.component == nullptr && is_in_package(subject, target);
    });
    return package != subjects.end() ? &*package : nullptr;
}

bool is_of(const Subject& subject, SourceId source) {
    if (subject.component != nullptr) return subject.component->span.source == source;
    return std::ranges::any_of(subject.files, [&](const frontend::File* file) { return file->source == source; });
}

/// Returns the component with this name, or with a name that ends with this name. Components of the document are
/// preferred to others, and full names to parts of names.
const Subject* subject_called(const std::vector<Subject>& subjects, const std::string& name, SourceId source) {
    const Subject* best = nullptr;
    int rank = 0;
    for (const Subject& subject : subjects) {
        const bool whole = subject.name == name;
        if (!whole && !subject.name.ends_with("::" + name)) continue;
        const int here = 1 + (whole ? 2 : 0) + (is_of(subject, source) ? 4 : 0);
        if (here > rank) best = &subject;
        rank = std::max(rank, here);
    }
    return best;
}

const Subject* first_of(const std::vector<Subject>& subjects, SourceId source) {
    const auto found = std::ranges::find_if(subjects, [&](const Subject& subject) { return is_of(subject, source); });
    return found != subjects.end() ? &*found : nullptr;
}

/// The selected component.
struct Choice {
    const Subject* subject = nullptr;
    bool certain = false;  ///< true if selected by place or name; false for the first component
};

Choice choose_subject(const std::vector<Subject>& subjects, const Target& target, const DiagramParameters& parameters) {
    const SourceId source = target.document.source;
    if (parameters.at_position)
        if (const Subject* found = subject_at(subjects, target)) return {found, true};
    if (!parameters.component.empty())
        if (const Subject* found = subject_called(subjects, parameters.component, source)) return {found, true};
    const bool only_named = !parameters.at_position && !parameters.component.empty();
    return {only_named ? nullptr : first_of(subjects, source), false};
}

/// Returns the documents that contain a component or package.
std::vector<const Document*> documents_of(const Subject& subject, Project& project) {
    std::vector<const Document*> result;
    if (subject.component != nullptr) result.push_back(project.find(subject.component->span.source));
    for (const frontend::File* file : subject.files) result.push_back(project.find(file->source));
    std::erase(result, nullptr);
    return result;
}

std::string kind_of(const Subject& subject) {
    return subject.component != nullptr ? std::string(frontend::to_text(subject.component->kind)) : "package";
}

// ---------------------------------------------------------------- the answer

/// Returns the indices of the elements that a picture shows.
std::set<std::size_t> shown_in(const diagrams::Picture& picture) {
    std::set<std::size_t> result;
    const auto add = [&](std::size_t element, const std::vector<diagrams::Text>& texts) {
        result.insert(element);
        for (const diagrams::Text& text : texts) result.insert(text.element);
    };
    for (const diagrams::PictureBox& box : picture.boxes) add(box.element, box.texts);
    for (const diagrams::PictureLine& line : picture.lines)
        if (line.points.size() >= 2) add(line.element, line.texts);
    result.erase(diagrams::none);
    return result;
}

Json places_of(const Session& session, Project& project, const diagrams::Picture& picture,
               const diagrams::Elements& elements) {
    Json result = Json::array();
    for (const std::size_t index : shown_in(picture)) {
        const diagrams::Element& element = elements.all_elements()[index];
        Json place = lsp_location(session, project, element.span);
        if (place.is_null()) continue;
        const Span name = element.name_span.is_known() ? element.name_span : element.span;
        result.push_back(
            Json::object({{"id", element.id},
                          {"kind", element.kind},
                          {"name", element.name},
                          {"uri", std::move(place["uri"])},
                          {"range", std::move(place["range"])},
                          {"selectionRange", lsp_range(project.sources(), name, session.client.encoding)}}));
    }
    return result;
}

Json version_of(const std::optional<std::int64_t>& version) {
    return version ? Json(*version) : Json(nullptr);
}

Json answer_of(const DrawnDiagram& drawn, const std::string& component, diagrams::Theme theme, bool stale) {
    return Json::object({{"version", version_of(drawn.version)},
                         {"component", component},
                         {"svg", diagrams::render_svg(drawn.picture, drawn.elements, {theme, ""})},
                         {"elements", drawn.places},
                         {"stale", stale}});
}

/// Draws a component from its current text.
DrawnDiagram draw_now(const Session& session, const Target& target, const Subject& subject, diagrams::AirdFiles& files,
                      diagrams::Memory& memory) {
    DrawnDiagram result{diagrams::Elements(target.project.current_model()), {}, nullptr, target.document.version};
    const diagrams::StoredDiagrams stored(target.project.current_model(), target.project.sources(), files,
                                          session.budget);
    try {
        result.picture =
            diagrams::draw_subject(subject, {result.elements, &memory, session.budget, stored.find(subject.component)});
    } catch (const diagrams::layout::TooLarge& large) {
        throw Refusal(ErrorCode::request_failed, large.what());
    }
    result.places = places_of(session, target.project, result.picture, result.elements);
    return result;
}

/// Returns the stored diagram to show while the text has errors: the diagram of the requested component, otherwise the
/// latest diagram of the document; null if there is none.
const KeptDiagram* stand_in(const KeptDiagrams& stored, const std::string& uri, const Choice& choice,
                            const std::string& component) {
    const KeptDiagram* found = choice.certain ? stored.find_last(uri, choice.subject->name) : nullptr;
    if (found == nullptr && !component.empty()) found = stored.find_last(uri, component);
    if (found == nullptr && !choice.certain) found = stored.find_last(uri, "");
    return found;
}

}  // namespace

KeptDiagram& KeptDiagrams::find_or_add(const std::string& uri, const std::string& kind, const std::string& name) {
    const auto found = std::ranges::find_if(entries_, [&](const KeptDiagram& entry) {
        return entry.uri == uri && entry.kind == kind && entry.name == name;
    });
    if (found != entries_.end()) {
        entries_.splice(entries_.begin(), entries_, found);
    } else {
        entries_.push_front({uri, kind, name, {}, {}});
    }
    if (entries_.size() > most) entries_.pop_back();
    return entries_.front();
}

const KeptDiagram* KeptDiagrams::find_last(std::string_view uri, std::string_view name) const {
    const auto found = std::ranges::find_if(entries_, [&](const KeptDiagram& entry) {
        return entry.drawn && entry.uri == uri && (name.empty() || entry.name == name);
    });
    return found != entries_.end() ? &*found : nullptr;
}

Json Models::diagram(const Request& request) {
    const Target target = target_of(request);
    const DiagramParameters parameters = diagram_parameters(request.params);
    KeptDiagrams& stored = *diagrams_;
    stored.requested.insert(target.document.uri);
    const std::vector<Subject> subjects =
        diagrams::find_subjects(target.project.current_model(), target.project.sources());
    const Choice choice = choose_subject(subjects, target, parameters);
    std::vector<const Document*> documents = {&target.document};
    if (choice.subject != nullptr) documents = documents_of(*choice.subject, target.project);
    const std::string uri = documents.empty() ? target.document.uri : documents.front()->uri;
    const bool broken =
        std::ranges::any_of(documents, [](const Document* document) { return !document->findings.ok(); });
    if (broken)
        if (const KeptDiagram* old = stand_in(stored, uri, choice, parameters.component))
            return answer_of(*old->drawn, old->name, parameters.theme, true);
    if (choice.subject == nullptr) return nullptr;
    KeptDiagram& entry = stored.find_or_add(uri, kind_of(*choice.subject), choice.subject->name);
    DrawnDiagram now = draw_now(session_, target, *choice.subject, stored.files, entry.memory);
    Json answer = answer_of(now, entry.name, parameters.theme, false);
    // A diagram of a text with errors may lack parts, so it is not stored.
    if (!broken) entry.drawn = std::move(now);
    return answer;
}

void Models::announce_diagrams(const Project& project) {
    std::set<std::string>& uris = diagrams_->requested;
    std::erase_if(uris, [&](const std::string& uri) { return find(uri) == nullptr; });
    for (const std::string& uri : uris) {
        const Workspace::Place place = workspace_.find(uri);
        if (place.project != &project) continue;
        const Json params = Json::object({{"uri", uri}, {"version", version_of(place.document->version)}});
        session_.send(Json::object({{"jsonrpc", "2.0"}, {"method", diagram_notification}, {"params", params}}));
    }
}

}  // namespace robochart::lsp
