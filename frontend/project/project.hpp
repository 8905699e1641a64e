// SPDX-License-Identifier: Apache-2.0
// The entry point of the front end: turns a path into a resolved and typed model, or into diagnostics.
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

/// Sets the toolkits of the model to those that its files import. Editors, in which single files change, must call it
/// before `resolve`. Unchanged toolkits are not read again.
void update_toolkits(diagnostics::SourceManager&, Model&, diagnostics::Diagnostics&);

/// Model and assertion files of a folder, sorted by path, without hidden files. With `deep`, also those of its
/// subfolders.
[[nodiscard]] std::vector<std::string> project_files(const std::string& folder, bool deep);

/// Reads, parses and resolves a project, and always returns a model, even if there are errors. If `path` is a folder,
/// all `.rct`, `.rst`, `.assertions` and `.rsa` files below it are loaded, sorted by path. If it is one file, the files
/// of its folder that it needs are loaded as well, so that imports work. Assertions come only from the named file or,
/// for a model, from the files of its dialect in its folder. If a named assertion file is in a folder without models,
/// the models of the parent folder are used. For a `.rsa` file, the models in the subfolders of its folder are also
/// used. A missing path and unreadable or empty input are reported.
[[nodiscard]] std::unique_ptr<Model> load_project(diagnostics::SourceManager&, const std::string& path,
                                                  diagnostics::Diagnostics&);

/// Loads several inputs as one project, which contains the files of all inputs.
[[nodiscard]] std::unique_ptr<Model> load_project(diagnostics::SourceManager&, const std::vector<std::string>& paths,
                                                  diagnostics::Diagnostics&);

/// Loads exactly these texts as a project, without looking for further files.
[[nodiscard]] std::unique_ptr<Model> load_texts(diagnostics::SourceManager&,
                                                const std::vector<diagnostics::SourceId>& texts,
                                                diagnostics::Diagnostics&);

/// The model as indented text, with one node per line: for `--print ast` before resolution, and for `--print model`
/// after resolution, with targets and types.
[[nodiscard]] std::string dump_model(const Model&, const diagnostics::SourceManager&, bool resolved);

}  // namespace robochart::frontend
