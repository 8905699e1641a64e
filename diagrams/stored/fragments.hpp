// References of RoboTool's files to elements of a model: `FILE.rct#//@machines.0/@nodes.1`. A feature with a number is
// the declaration of that number, in the order of the text. No file is opened: only the last part of FILE is compared
// with the names of the model's files.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/syntax/ast.hpp"

namespace robochart::diagrams {

/// The declarations that references lead to.
class Fragments {
public:
    /// `folder`: where the referring file is, "" or with "/" at its end; of files of one name, the one there is meant.
    Fragments(const frontend::Model& model, const diagnostics::SourceManager& sources, const std::string& folder);

    /// Null where the reference leads to nothing that is drawn.
    [[nodiscard]] const frontend::Declaration* find(std::string_view href) const;
    /// What the same reference leads to with any number at its end.
    [[nodiscard]] std::vector<const frontend::Declaration*> siblings(std::string_view href) const;

private:
    struct Reference;
    [[nodiscard]] Reference read(std::string_view href) const;

    std::map<std::string, const frontend::File*> files_;  ///< by their names without folders
};

}  // namespace robochart::diagrams
