// SPDX-License-Identifier: Apache-2.0
// Divides the files of a project into groups. Files belong together if one refers to the other, imports it or has the
// same package. Files of different groups share no declaration and no finite instantiation.
#pragma once

#include <vector>

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// The files that are instantiated and checked together, as indices into Model::files.
struct Unit {
    std::vector<std::size_t> files;
    bool again = false;  ///< an earlier unit contains the same models with other instantiations
};

/// Divides the files of a resolved model into groups, as indices into Model::files. Libraries are in no group. Two
/// files are in one group if one imports the package of the other, or refers to a declaration in the other. (A csp
/// block refers to a component or package by its name before `::`.) Files of the same named package are in one group if
/// they are in one folder, or if the folder of one contains the other. Other assertion files join the models that are
/// nearest to them. If several files declare the same name, a reference is to the nearest file (`file_nearness`). If
/// several are equally near, all join one group, and the rules report the name. A file with syntax errors joins the
/// files nearest to it. Groups are in the order of their first files.
[[nodiscard]] std::vector<std::vector<std::size_t>> group_files(const Model& model);

/// Divides the groups by their instantiations. If assertion files of a group have different blocks `Instantiations`,
/// each of these files forms a unit with the group's models. The assertion files without such a block form one unit
/// with the generated instantiations. (RoboTool makes one script for each assertion file.)
[[nodiscard]] std::vector<Unit> split_into_units(const Model& model);

/// True if the block replaces the generated instantiations. RoboTool's documents name such a block `Instantiations`,
/// and some models `instantiations`.
[[nodiscard]] bool replaces_instantiations(const CspBlock& block);

}  // namespace robochart::frontend
