// SPDX-License-Identifier: Apache-2.0
// Turns a path into a resolved and typed model, or into diagnostics. This is the entry point of the front end.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// Resolves names over all files of the model, computes types and checks the well-formedness rules. Overwrites the
/// fields marked "filled by". May be called again after files of the model were replaced. The order of files does not
/// matter.
void resolve(Model&, diagnostics::Diagnostics&);

/// Sets the toolkits of the model to those that its files import. Editors must call this function before `resolve` if a
/// file has changed. Unchanged toolkits are not read again.
void update_toolkits(diagnostics::SourceManager&, Model&, diagnostics::Diagnostics&);

/// Returns the paths of the model and assertion files in a folder, sorted, without hidden files. If `deep` is true, the
/// files in subfolders are included.
[[nodiscard]] std::vector<std::string> project_files(const std::string& folder, bool deep);

/// Reads, parses and resolves a project, and always returns a model, even if it has errors. If `path` is a folder, all
/// `.rct`, `.rst`, `.assertions` and `.rsa` files below it are loaded, sorted by path. If it is one file, the files in
/// the same folder that this file needs are loaded as well, so that imports work. Assertions are read only from this
/// file or, if it is a model, from the files of its dialect in its folder. If it is an assertion file in a folder
/// without models, the models of the parent folder are used and, for a `.rsa` file, also those in the subfolders of its
/// folder. A missing path and unreadable or empty input are reported.
[[nodiscard]] std::unique_ptr<Model> load_project(diagnostics::SourceManager&, const std::string& path,
                                                  diagnostics::Diagnostics&);

/// Loads several inputs as one project. The project contains the files of all inputs.
[[nodiscard]] std::unique_ptr<Model> load_project(diagnostics::SourceManager&, const std::vector<std::string>& paths,
                                                  diagnostics::Diagnostics&);

/// Loads exactly these texts as a project, without looking for further files.
[[nodiscard]] std::unique_ptr<Model> load_texts(diagnostics::SourceManager&,
                                                const std::vector<diagnostics::SourceId>& texts,
                                                diagnostics::Diagnostics&);

/// Returns the model as indented text, with one node per line. `--print ast` prints it before resolution. `--print
/// model` prints it after resolution, with targets and types.
[[nodiscard]] std::string dump_model(const Model&, const diagnostics::SourceManager&, bool resolved);

}  // namespace robochart::frontend
