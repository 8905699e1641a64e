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
    /// `folder`: the folder of the referring file, "" or ending with "/". If several files have the same name, the one
    /// in this folder is used.
    Fragments(const frontend::Model& model, const diagnostics::SourceManager& sources, const std::string& folder);

    /// Null if the reference does not lead to a drawn declaration.
    [[nodiscard]] const frontend::Declaration* find(std::string_view href) const;
    /// The declarations to which the reference leads with any number at its end.
    [[nodiscard]] std::vector<const frontend::Declaration*> siblings(std::string_view href) const;

private:
    struct Reference;
    [[nodiscard]] Reference read(std::string_view href) const;

    std::map<std::string, const frontend::File*> files_;  ///< keyed by file name without the folder
};

}  // namespace robochart::diagrams
