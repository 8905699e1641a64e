// SPDX-License-Identifier: Apache-2.0
// Finds the components and packages of a model that have a diagram, and draws them.
#pragma once

#include <string>
#include <vector>

#include "frontend/diagrams/notation/painter.hpp"

namespace robochart::diagrams {

/// A component, or the types and interfaces of a package.
struct Subject {
    std::string name;  ///< "P::C::S"; for a package without a name, the name of its file
    std::string file;  ///< a unique name for files, of letters, digits and "_"
    const frontend::Declaration* component = nullptr;  ///< null for a package
    std::vector<const frontend::File*> files;          ///< the files of the package
};

/// True for a component, which has its own diagram.
[[nodiscard]] bool has_diagram(const frontend::Declaration& declaration);

/// Lists, in textual order, all modules, controllers, machines, operations and platforms, including inline ones. Then
/// lists every package with types, functions or interfaces. `paths` contains the paths of the texts. They are used in
/// the place of a name for unnamed packages.
[[nodiscard]] std::vector<Subject> find_subjects(const frontend::Model& model,
                                                 const diagnostics::SourceManager& sources);

/// Returns the diagram of a subject. A model with errors is drawn as far as possible: an unresolved name becomes a box.
/// Throws layout::TooLarge.
[[nodiscard]] Picture draw_subject(const Subject& subject, const Drawing& drawing);

}  // namespace robochart::diagrams
