// Which files of a project belong together: what refers to each other, imports each other or is of one package. What
// does not belong together shares nothing, a finite instantiation least of all.
#pragma once

#include <vector>

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// Files that are read, made finite and checked together, by place in Model::files.
struct Unit {
    std::vector<std::size_t> files;
    bool again = false;  ///< the models in it stand in a unit before it too, with other instantiations
};

/// The files of a resolved model in groups, by place in Model::files; libraries are in none. Files are in one group
/// where one refers to a declaration of the other (a csp block: by a name of a component or package in front of `::`)
/// or imports from its package, and where they are of one named package and in one folder or one above the other;
/// assertion files without any such tie belong to the models that are nearest to them. Of files that declare the same
/// name the nearest is meant (`nearness`); all of them where they are equally near, so that they meet in one group and
/// the rules report the name. What could not be read completely belongs to the files nearest to it. Groups are in the
/// order of their first files.
[[nodiscard]] std::vector<std::vector<std::size_t>> groups(const Model& model);

/// The groups as they are made finite. Where several assertion files of a group have different blocks `Instantiations`,
/// each of them is a unit with the group's models, and the assertion files without any are one with the generated
/// instantiations: RoboTool makes a script of each assertion file.
[[nodiscard]] std::vector<Unit> units(const Model& model);

/// A block that replaces the generated instantiations. RoboTool's documents write `Instantiations`, some models
/// `instantiations`.
[[nodiscard]] bool replaces_instantiations(const CspBlock& block);

}  // namespace robochart::frontend
