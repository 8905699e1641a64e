// SPDX-License-Identifier: Apache-2.0
// Shows diagrams next to the text, by the project's own request `robochart/diagram` and notification
// `robochart/diagramChanged` (docs/lsp.md, "Diagrams").
#pragma once

#include <list>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "editors/server/protocol/json.hpp"
#include "frontend/diagrams/notation/memory.hpp"
#include "frontend/diagrams/notation/subjects.hpp"
#include "frontend/diagrams/stored/aird_files.hpp"

namespace robochart::lsp {

inline constexpr const char* diagram_request = "robochart/diagram";
inline constexpr const char* diagram_notification = "robochart/diagramChanged";

/// A diagram with the places of its elements.
struct DrawnDiagram {
    diagrams::Elements elements;
    diagrams::Picture picture;
    Json places;  ///< the places of the elements, as sent in the answer
    std::optional<std::int64_t> version;
};

/// A drawn component: its layout, and its last diagram of a text without syntax errors.
struct KeptDiagram {
    std::string uri;   ///< the document that contains the component
    std::string kind;  ///< the kind of the declaration; "package" for a package
    std::string name;
    diagrams::Memory memory;
    std::optional<DrawnDiagram> drawn;
};

/// The components that were drawn most recently, and the documents whose diagrams the editor has requested.
class KeptDiagrams {
public:
    /// Returns the entry of a component as the most recent one; creates it if necessary. The oldest entry may be
    /// dropped.
    KeptDiagram& find_or_add(const std::string& uri, const std::string& kind, const std::string& name);
    /// Returns the latest entry of a document that has a picture and, unless `name` is "", this name. Returns null if
    /// there is none.
    [[nodiscard]] const KeptDiagram* find_last(std::string_view uri, std::string_view name) const;

    std::set<std::string> requested;  ///< URIs
    diagrams::AirdFiles files;        ///< RoboTool's files with diagrams

private:
    static constexpr std::size_t most = 16;
    std::list<KeptDiagram> entries_;  ///< most recent first
};

}  // namespace robochart::lsp
