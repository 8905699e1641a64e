// The diagrams of a model that people drew in RoboTool: found beside its files, and used where they are of the model as
// it is. They are never written.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "diagrams/notation/stored_layout.hpp"
#include "diagrams/stored/aird_files.hpp"

namespace robochart::diagrams {

/// How RoboTool calls the file in which it keeps diagrams.
inline constexpr std::string_view aird_file = "representations.aird";

/// The diagram of a component in such a file.
struct StoredDiagram {
    std::string file;  ///< its path
    StoredLayout layout;
    std::size_t elements = 0;  ///< nodes, parts, squares of events and lines
    std::size_t found = 0;     ///< of these, those that the model has, with their names or ends
    std::size_t boxes = 0;     ///< nodes and parts
    std::size_t stacked = 0;   ///< of these, those that stand where another one does: nobody has put them there

    /// Did somebody draw it? Else it is as RoboTool made it.
    [[nodiscard]] bool is_drawn() const { return elements > 0 && stacked * 100 <= boxes * 5; }
    /// Is it of this model?
    [[nodiscard]] bool fits() const { return is_drawn() && found * 100 >= elements * 95; }
};

/// The diagrams of the components of a model, or of several.
class StoredDiagrams {
public:
    /// None.
    StoredDiagrams() = default;
    /// As by `read`, for servers: without findings.
    StoredDiagrams(const frontend::Model& model, const diagnostics::SourceManager& sources, AirdFiles& files,
                   diagnostics::Budget* budget);

    /// Adds those in files `representations.aird` in the folders of the model's files, and in the one that they have in
    /// common. A file that cannot be read is a finding, once.
    void read(const frontend::Model& model, diagnostics::SourceManager& sources, diagnostics::Diagnostics& out);
    /// Adds those of a file with a path; of several of one component that fits best, then the first.
    void add(const Aird& aird, const std::string& path, const frontend::Model& model,
             const diagnostics::SourceManager& sources, diagnostics::Budget* budget);

    /// The diagram of a component, of this model or not; null where there is none.
    [[nodiscard]] const StoredDiagram* diagram(const frontend::Declaration* component) const;
    /// The layout of a component; null where there is none, or none of this model.
    [[nodiscard]] const StoredLayout* find(const frontend::Declaration* component) const;
    /// Says why the diagram of a component is not used, or what it does not have.
    void explain(const frontend::Declaration* component, diagnostics::Diagnostics& out) const;

private:
    std::map<std::string, Aird> files_;  ///< that `read` has read, by their paths
    std::unordered_map<const frontend::Declaration*, StoredDiagram> diagrams_;  ///< asked only, never walked
};

}  // namespace robochart::diagrams
