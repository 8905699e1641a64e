// Diagrams beside the text: requests and notifications of our own, `robochart/diagram` and `robochart/diagramChanged`
// (docs/lsp.md, "Diagrams").
#pragma once

#include <list>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "diagrams/notation/memory.hpp"
#include "diagrams/notation/subjects.hpp"
#include "diagrams/stored/aird_files.hpp"
#include "lsp/workspace/session.hpp"

namespace robochart::lsp {

inline constexpr const char* diagram_request = "robochart/diagram";
inline constexpr const char* diagram_notification = "robochart/diagramChanged";

/// A diagram with what it shows.
struct DrawnDiagram {
    diagrams::Elements elements;
    diagrams::Picture picture;
    Json places;  ///< of the elements, as they are answered
    std::optional<std::int64_t> version;
};

/// A component that was drawn: how it was laid out, and its last diagram of a text without mistakes of syntax.
struct KeptDiagram {
    std::string uri;   ///< of the document that it is in
    std::string kind;  ///< of declaration; "package"
    std::string name;
    diagrams::Memory memory;
    std::optional<DrawnDiagram> drawn;
};

/// The components that were drawn last, and the documents whose diagrams the editor has asked for.
class KeptDiagrams {
public:
    /// The entry of a component, made if there is none, as the latest; the oldest may be dropped for it.
    KeptDiagram& use(const std::string& uri, const std::string& kind, const std::string& name);
    /// The latest entry of a document with a picture and, unless it is "", this name; null if there is none.
    [[nodiscard]] const KeptDiagram* last(std::string_view uri, std::string_view name) const;

    std::set<std::string> asked;  ///< URIs
    diagrams::AirdFiles files;    ///< of RoboTool

private:
    static constexpr std::size_t most = 16;
    std::list<KeptDiagram> entries_;  ///< the latest first
};

/// Tells the editor, if it has asked for diagrams of documents of the project, that they may have changed.
void announce_diagrams(Session&, const Project&);

}  // namespace robochart::lsp
