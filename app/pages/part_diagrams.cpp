// SPDX-License-Identifier: Apache-2.0
// See part_diagrams.hpp.
#include "app/pages/part_diagrams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/diagnostics/escape.hpp"
#include "frontend/diagrams/exports/outline.hpp"
#include "frontend/diagrams/layout/arrange.hpp"
#include "frontend/diagrams/svg/svg.hpp"

namespace robochart::app {
namespace {

/// Returns the text for the box at an end of a line: "Forward", "initial junction i", "ref EPuck, turned".
std::string end_text(const diagrams::Picture& picture, const diagrams::Outline& outline,
                     const diagrams::Elements& elements, std::size_t end) {
    const diagrams::PictureBox& box = picture.boxes[end];
    std::string text = outline.title_of_box(end);
    if (text.empty() && box.element != diagrams::none) {
        const diagrams::Element& element = elements.all_elements()[box.element];
        text = element.kind + " " + element.name;
    }
    return box.event_of == diagrams::none ? text : outline.title_of_box(box.event_of) + ", " + text;
}

/// Describes which boxes the lines join, for readers who cannot see the picture; "" if there are no lines.
std::string lines_text(const diagrams::Picture& picture, const diagrams::Elements& elements) {
    if (picture.lines.empty()) return "";
    const diagrams::Outline outline(picture);
    std::string text = outline.is_machine() ? "transitions" : "connections";
    text = fmt::format("<details class=\"lines\"><summary>{} as text</summary>\n<ul>\n", text);
    for (const diagrams::PictureLine& line : picture.lines) {
        const std::string label = outline.label_of(line);
        const std::string joined =
            fmt::format("{} {} {}{}{}", end_text(picture, outline, elements, line.from), line.both_ways ? "<->" : "->",
                        end_text(picture, outline, elements, line.to), label.empty() ? "" : ": ", label);
        text += fmt::format("<li>{}</li>\n", diagnostics::xml_text(joined));
    }
    return text + "</ul></details>\n";
}

}  // namespace

PartDiagrams::PartDiagrams(const std::vector<driver::Part>& parts, diagnostics::Budget& budget) : budget_(budget) {
    for (const driver::Part& part : parts)
        if (part.project->model && !part.again) add(*part.project);
}

namespace {

/// Returns the paths of a project's texts.
std::set<std::string> paths_of(const driver::Project& project) {
    std::set<std::string> paths;
    for (std::size_t i = 0; i < project.sources.size(); ++i)
        if (project.model && std::ranges::any_of(project.model->files, [&](const auto& file) {
                return file->source == static_cast<diagnostics::SourceId>(i);
            }))
            paths.emplace(project.sources.path(static_cast<diagnostics::SourceId>(i)));
    return paths;
}

}  // namespace

PartDiagrams::PartDiagrams(const std::vector<driver::Project*>& projects, diagnostics::Budget& budget)
    : budget_(budget) {
    std::set<std::set<std::string>> known;
    for (driver::Project* const project : projects)
        if (project->model && known.insert(paths_of(*project)).second) add(*project);
}

void PartDiagrams::add(driver::Project& project) {
    elements_.push_back(std::make_unique<diagrams::Elements>(*project.model, next_));
    next_ += elements_.back()->all_elements().size();
    for (const diagrams::Element& element : elements_.back()->all_elements()) {
        note_place(project.sources, element.span, element.id);
        note_place(project.sources, element.name_span, element.id);
    }
    name_elements(project);
    stored_findings_.set_budget(&budget_);
    stored_.read(*project.model, project.sources, stored_findings_);
    for (diagrams::Subject& subject : diagrams::find_subjects(*project.model, project.sources)) {
        const std::string name = subject.file;
        for (int i = 2; !files_.insert(subject.file).second; ++i) subject.file = fmt::format("{}_{}", name, i);
        const diagrams::StoredLayout* layout = stored_.find(subject.component);
        subjects_.push_back({&project, elements_.back().get(), std::move(subject), layout});
    }
}

void PartDiagrams::explain_layout(const PartSubject& subject) const {
    stored_.explain_mismatch(subject.subject.component, subject.project->diagnostics);
}

std::string PartDiagrams::id_at(const runs::Place& place) const {
    const auto found = by_place_.find({place.file, place.line, place.column});
    return found == by_place_.end() ? "" : found->second;
}

std::string PartDiagrams::id_at(const diagnostics::SourceManager& sources, diagnostics::Span span) const {
    const auto where = position_of(sources, span);
    const auto found = where ? by_place_.find(*where) : by_place_.end();
    return found == by_place_.end() ? "" : found->second;
}

std::string PartDiagrams::id_of_name(const std::string& element) const {
    const auto found = by_name_.find(element);
    return found == by_name_.end() ? "" : found->second;
}

std::string PartDiagrams::id_of_event(const runs::Event& event) const {
    const std::string id = id_of_name(event.element);
    return id.empty() && event.place ? id_at(*event.place) : id;
}

std::string PartDiagrams::draw_diagram(const PartSubject& subject, const std::string& prefix,
                                       const Classes& classes) const {
    try {
        const diagrams::Picture picture =
            diagrams::draw_subject(subject.subject, {*subject.elements, nullptr, &budget_, subject.layout});
        return diagrams::render_svg(picture, *subject.elements, {diagrams::Theme::automatic, prefix, classes}) +
               lines_text(picture, *subject.elements);
    } catch (const diagrams::layout::TooLarge& large) {
        return fmt::format("<p>{}</p>", diagnostics::xml_text(std::string(large.what())));
    }
}

std::string PartDiagrams::draw_diagram(const std::string& component, const std::string& prefix,
                                       const Classes& classes) const {
    for (const PartSubject& part_subject : subjects_)
        if (part_subject.subject.component != nullptr && part_subject.subject.name == component)
            return draw_diagram(part_subject, prefix, classes);
    return "";
}

std::vector<PartDiagrams::Drawn> PartDiagrams::draw_operations(const std::set<std::string>& elements,
                                                               const std::string& prefix,
                                                               const Classes& classes) const {
    std::vector<Drawn> result;
    for (const PartSubject& part_subject : subjects_) {
        const frontend::Declaration* const declared = part_subject.subject.component;
        if (declared == nullptr || declared->kind != frontend::DeclKind::operation) continue;
        std::string diagram = draw_diagram(part_subject, fmt::format("{}{}-", prefix, result.size()), classes);
        if (std::ranges::any_of(elements, [&](const std::string& id) {
                return diagram.find(fmt::format("data-element=\"{}\"", id)) != std::string::npos;
            }))
            result.push_back({declared->name, std::move(diagram)});
    }
    return result;
}

std::optional<PartDiagrams::Position> PartDiagrams::position_of(const diagnostics::SourceManager& sources,
                                                                diagnostics::Span span) {
    if (!span.is_known()) return std::nullopt;
    const diagnostics::Position begin = sources.position(span.source, span.begin);
    return Position{sources.path(span.source), begin.line, begin.column};
}

void PartDiagrams::note_place(const diagnostics::SourceManager& sources, diagnostics::Span span,
                              const std::string& id) {
    if (const auto where = position_of(sources, span)) by_place_.try_emplace(*where, id);
}

void PartDiagrams::name_elements(const driver::Project& project) {
    const auto name = [&](const ir::Origin& origin) {
        const std::string id = id_at(project.sources, origin.span);
        if (!id.empty()) by_name_.try_emplace(origin.element, id);
    };
    for (const ir::Machine& machine : project.system.machines) {
        for (const ir::Node& node : machine.nodes) name(node.origin);
        for (const ir::Transition& transition : machine.transitions) name(transition.origin);
    }
}

}  // namespace robochart::app
