// SPDX-License-Identifier: Apache-2.0
// Resolves references in RoboTool's files to elements of a model: `FILE.rct#//@machines.0/@nodes.1`. A feature with a
// number denotes the declaration with that number in textual order. No file is opened: only the last part of FILE is
// compared with the names of the model's files.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/syntax/ast.hpp"

namespace robochart::diagrams {

/// Finds the declarations to which references lead.
class Fragments {
public:
    /// `folder` is the folder of the file with the references: "" or a path that ends with "/". If several files of the
    /// model have the same name, the file in this folder is used.
    Fragments(const frontend::Model& model, const diagnostics::SourceManager& sources, const std::string& folder);

    /// Returns the declaration to which the reference leads, or null if diagrams do not show it.
    [[nodiscard]] const frontend::Declaration* find(std::string_view href) const;
    /// Returns the declarations to which the reference leads if 0, 1, 2 and so on replace the number at its end.
    [[nodiscard]] std::vector<const frontend::Declaration*> siblings(std::string_view href) const;

private:
    struct Reference;
    [[nodiscard]] Reference read(std::string_view href) const;

    std::map<std::string, const frontend::File*> files_;  ///< keyed by file name without the folder
};

}  // namespace robochart::diagrams
