// What of a model has a diagram, and the diagrams.
#pragma once

#include <string>
#include <vector>

#include "diagrams/notation/painter.hpp"

namespace robochart::diagrams {

/// A component, or the types and interfaces of a package.
struct Subject {
    std::string name;                                  ///< "P::C::S"; of a package without a name, that of its file
    std::string file;                                  ///< for names of files: letters, digits, "_"; no two are alike
    const frontend::Declaration* component = nullptr;  ///< null for a package
    std::vector<const frontend::File*> files;          ///< of the package
};

/// Whether it is a component, which has a diagram of its own.
[[nodiscard]] bool has_diagram(const frontend::Declaration& declaration);

/// In the order of the text: modules, controllers, machines, operations and platforms, also those declared inside of
/// others, then every package with types, functions or interfaces. `paths`: where texts are from, to name packages that
/// have no name.
[[nodiscard]] std::vector<Subject> subjects(const frontend::Model& model, const diagnostics::SourceManager& sources);

/// Its diagram. A model with findings is drawn as far as it is known: a name that means nothing is a box of its own.
/// Throws layout::TooLarge.
[[nodiscard]] Picture draw(const Subject& subject, const Drawing& drawing);

}  // namespace robochart::diagrams
