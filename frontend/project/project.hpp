// The front end's door: a path in, a resolved and typed model or diagnostics out.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// Resolves names over all files of the model, computes types and checks the well-formedness rules.
/// Fills the "filled by" fields anew; may be called again after files of the model were replaced. Order of files does
/// not matter.
void resolve(Model&, diagnostics::Diagnostics&);

/// Makes the toolkits in the model those that its files import. Belongs before `resolve` where files are changed one by
/// one (editors); unchanged toolkits are not read again.
void update_toolkits(diagnostics::SourceManager&, Model&, diagnostics::Diagnostics&);

/// Model and assertion files of a folder, sorted by path, hidden ones left out; with `deep` those of its subfolders
/// too.
[[nodiscard]] std::vector<std::string> project_files(const std::string& folder, bool deep);

/// Loads a project: a folder (all `.rct` and `.assertions` below it, sorted by path) or one file
/// (with the other files of its folder, so that imports work; assertions only of the named file
/// or, for a `.rct`, of the folder's files; for assertions in a folder without models, with those of the folder above).
/// Reads, parses, resolves. Missing path, unreadable or empty input become diagnostics. Returns a model even when there
/// are errors.
[[nodiscard]] std::unique_ptr<Model> load_project(diagnostics::SourceManager&, const std::string& path,
                                                  diagnostics::Diagnostics&);

/// The same for several inputs read as one project: the union of their files.
[[nodiscard]] std::unique_ptr<Model> load_project(diagnostics::SourceManager&, const std::vector<std::string>& paths,
                                                  diagnostics::Diagnostics&);

/// The same for files whose texts are known already, and no others.
[[nodiscard]] std::unique_ptr<Model> load_texts(diagnostics::SourceManager&,
                                                const std::vector<diagnostics::SourceId>& texts,
                                                diagnostics::Diagnostics&);

/// The model as indented text, one node a line, for `--print ast` (before) and `--print model` (after resolution:
/// targets and types shown).
[[nodiscard]] std::string dump(const Model&, const diagnostics::SourceManager&, bool resolved);

}  // namespace robochart::frontend
