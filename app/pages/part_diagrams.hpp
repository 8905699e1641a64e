// SPDX-License-Identifier: Apache-2.0
// Makes the diagrams of a run's parts, and finds the diagram element for a place or name of the model. The elements of
// all parts are numbered consecutively, so that their ids are unique in a page.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "counterexample/run.hpp"
#include "driver/model/pipeline.hpp"
#include "frontend/diagrams/notation/subjects.hpp"
#include "frontend/diagrams/stored/stored_diagrams.hpp"

namespace robochart::app {

/// The model element that a diagram shows, and the part that contains this element.
struct PartSubject {
    driver::Project* project = nullptr;
    const diagrams::Elements* elements = nullptr;
    diagrams::Subject subject;                       ///< its file name is unique among all parts
    const diagrams::StoredLayout* layout = nullptr;  ///< drawn by a person; null: automatic layout
};

class PartDiagrams {
public:
    /// Parts that could not be read have no diagrams. A part with the same texts as an earlier part has no diagrams
    /// either.
    PartDiagrams(const std::vector<driver::Part>& parts, diagnostics::Budget& budget);
    /// Constructor for projects that were loaded separately. If two projects have the same texts, only the first has
    /// diagrams, which then also show places of the second.
    PartDiagrams(const std::vector<driver::Project*>& projects, diagnostics::Budget& budget);

    /// The subjects in the order of the model's text.
    [[nodiscard]] const std::vector<PartSubject>& subjects() const { return subjects_; }
    /// Findings about the files of diagrams that people drew. `explain` adds the finding about one subject to the
    /// subject's project.
    [[nodiscard]] const diagnostics::Diagnostics& stored_findings() const { return stored_findings_; }
    void explain_layout(const PartSubject& subject) const;
    /// Returns the id of the element that begins at a place; "" if there is none.
    [[nodiscard]] std::string id_at(const runs::Place& place) const;
    [[nodiscard]] std::string id_at(const diagnostics::SourceManager& sources, diagnostics::Span span) const;
    /// Returns the id of the state or transition with this name in the resolved model; "" if no diagram shows it.
    [[nodiscard]] std::string id_of_name(const std::string& element) const;

    /// Returns the id of the element that causes an event; "" if no diagram shows it.
    [[nodiscard]] std::string id_of_event(const runs::Event& event) const;

    /// Additional HTML classes of groups, by element id.
    using Classes = std::map<std::string, std::string>;
    /// Returns the diagram for a page, with a text description of its lines. If the diagram is too large, returns a
    /// paragraph that says so. All ids begin with `prefix`.
    [[nodiscard]] std::string draw_diagram(const PartSubject& subject, const std::string& prefix,
                                           const Classes& = {}) const;
    /// Returns the diagram of the component with this qualified name; "" if it has no diagram.
    [[nodiscard]] std::string draw_diagram(const std::string& component, const std::string& prefix,
                                           const Classes& = {}) const;
    /// Returns the diagrams of the operations that contain one of these elements, given by their ids.
    struct Drawn {
        std::string name, diagram;
    };
    [[nodiscard]] std::vector<Drawn> draw_operations(const std::set<std::string>& elements, const std::string& prefix,
                                                     const Classes& = {}) const;

private:
    using Position = std::tuple<std::string, std::uint32_t, std::uint32_t>;

    [[nodiscard]] static std::optional<Position> position_of(const diagnostics::SourceManager& sources,
                                                             diagnostics::Span span);
    void add(driver::Project& project);
    void note_place(const diagnostics::SourceManager& sources, diagnostics::Span span, const std::string& id);
    void name_elements(const driver::Project& project);

    diagnostics::Budget& budget_;
    std::vector<std::unique_ptr<diagrams::Elements>> elements_;
    diagrams::StoredDiagrams stored_;
    diagnostics::Diagnostics stored_findings_;
    std::vector<PartSubject> subjects_;
    std::set<std::string> files_;  ///< files of the subjects
    std::size_t next_ = 1;         ///< number of the next element
    std::map<Position, std::string> by_place_;
    std::map<std::string, std::string> by_name_;
};

}  // namespace robochart::app
