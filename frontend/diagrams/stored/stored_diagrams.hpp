// SPDX-License-Identifier: Apache-2.0
// Finds the diagrams of a model that people drew in RoboTool. The search covers the folders of the model's files. A
// diagram is used if it matches the current model. The files are never written.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "frontend/diagrams/notation/stored_layout.hpp"
#include "frontend/diagrams/stored/aird_files.hpp"

namespace robochart::diagrams {

/// The name of the file in which RoboTool stores diagrams.
inline constexpr std::string_view aird_file = "representations.aird";

/// The diagram of a component in such a file.
struct StoredDiagram {
    std::string file;  ///< its path
    StoredLayout layout;
    std::size_t elements = 0;  ///< nodes, parts, squares of events and lines
    std::size_t found = 0;     ///< number of these elements that the model has, with their names or ends
    std::size_t boxes = 0;     ///< nodes and parts
    std::size_t stacked = 0;   ///< number of boxes at the place of another box, because nobody has moved them

    /// True if a person arranged the diagram, false if it is as RoboTool created it.
    [[nodiscard]] bool is_drawn() const { return elements > 0 && stacked * 100 <= boxes * 5; }
    /// True if the diagram matches this model.
    [[nodiscard]] bool fits_model() const { return is_drawn() && found * 100 >= elements * 95; }
};

/// The diagrams of the components of one or more models.
class StoredDiagrams {
public:
    /// Contains no diagrams.
    StoredDiagrams() = default;
    /// Reads the diagrams as `read` does, but reports no findings. Servers use this constructor.
    StoredDiagrams(const frontend::Model& model, const diagnostics::SourceManager& sources, AirdFiles& files,
                   diagnostics::Budget* budget);

    /// Adds the diagrams in files `representations.aird` in the folders of the model's files and in their common
    /// folder. A file that cannot be read is reported once.
    void read(const frontend::Model& model, diagnostics::SourceManager& sources, diagnostics::Diagnostics& out);
    /// Adds the diagrams of a file with this path. If a component has several diagrams, the first of those that fit
    /// best is used.
    void add(const Aird& aird, const std::string& path, const frontend::Model& model,
             const diagnostics::SourceManager& sources, diagnostics::Budget* budget);

    /// Returns the diagram of a component, even if it does not match this model, or null if there is none.
    [[nodiscard]] const StoredDiagram* diagram_of(const frontend::Declaration* component) const;
    /// Returns the layout of a component, or null if there is no diagram that matches this model.
    [[nodiscard]] const StoredLayout* find(const frontend::Declaration* component) const;
    /// Reports why the diagram of a component is not used, or which parts it does not contain.
    void explain_mismatch(const frontend::Declaration* component, diagnostics::Diagnostics& out) const;

private:
    std::map<std::string, Aird> files_;                                         ///< read by `read`, by path
    std::unordered_map<const frontend::Declaration*, StoredDiagram> diagrams_;  ///< for lookup only
};

}  // namespace robochart::diagrams
