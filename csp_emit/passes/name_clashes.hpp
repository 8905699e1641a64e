// SPDX-License-Identifier: Apache-2.0
// Resolves clashes of names between generated code and the CSP blocks of users, which form one script. If both use the
// same name for different things, one of the names gets a number. Otherwise a generated parameter with the name of a
// channel or constructor would be a pattern that matches only that value, and a function with the name of a library or
// predefined function would replace that function.
//
// At the top of the script, no declaration of a block has a name that CSPM or the library defines. So the library and
// all generated code keep their meaning, independently of what a block defines. A block's definition for the model (in
// its Instantiations) gets the name that the model's element has in the script. Each .assertions file is a scope:
// RoboTool makes a script for each.
#pragma once

#include "checker/cspm/syntax/rename.hpp"
#include "csp_emit/base/names.hpp"
#include "csp_emit/base/user_names.hpp"
#include "csp_emit/passes/safe_names.hpp"

namespace robochart::csp_emit {

/// The blocks of one .assertions file.
struct FileBlocks {
    std::string file;
    std::vector<cspm::DeclPtr> instantiations;
    std::vector<cspm::DeclPtr> others;
};

/// Returns the definitions of the instantiations, by the names that the model's elements have in the script.
[[nodiscard]] std::set<std::string> given_names(const std::vector<FileBlocks>& files, const NamesForBlocks& of_model);

/// Returns new names for the bound names in generated code that are also names of the user's channels or constructors.
[[nodiscard]] cspm::NewNames new_names_of_ours(const UserNames& theirs, const std::vector<cspm::DeclPtr>& generated,
                                               NameManager& names);

/// Returns new names for the users' blocks, file by file. Elements of the model that blocks define or mention get their
/// names in the script. Numbers are appended to names that CSPM predefines or the library declares, and to names that
/// several files declare. They are also appended to channels and constructors with the name of a value inside the
/// generated modules, because the names in these modules are RoboTool's.
[[nodiscard]] std::vector<cspm::QualifiedNames> new_names_of_theirs(const std::vector<FileBlocks>& files,
                                                                    const NamesForBlocks& of_model,
                                                                    const std::vector<cspm::DeclPtr>& generated,
                                                                    NameManager& names);

/// Returns the predefined and library names that are captured: the declarations call them, but a declaration or binding
/// around the call hides them. For generated code the result must be empty. Otherwise there is an internal error.
[[nodiscard]] std::set<std::string> captured_names(const std::vector<cspm::DeclPtr>& generated);

}  // namespace robochart::csp_emit
