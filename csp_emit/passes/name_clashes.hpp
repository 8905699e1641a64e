// What is generated and what users write in CSP blocks is one script. A name that both use for something of their own
// gets a number on one side: a parameter called like a channel or constructor would be a pattern that matches only that
// value, a function called like one of the library, or like a predefined one, would do the other's work.
//
// The rule that holds everywhere: no declaration of a block has at the top of the script a name that CSPM
// predefines or that the library has. So the library and all that is generated mean what is written there, whatever
// a block defines. What a block defines for the model, in its Instantiations, goes by the name that the model's element
// has in the script. Each .assertions file is a scope of its own: RoboTool makes a script of each.
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

/// What the instantiations define, under the names that the model's elements have in the script.
[[nodiscard]] std::set<std::string> given_names(const std::vector<FileBlocks>& files, const NamesForBlocks& of_model);

/// New names for what is generated: its bound names that are a user's channel or constructor.
[[nodiscard]] cspm::NewNames new_names_of_ours(const UserNames& theirs, const std::vector<cspm::DeclPtr>& generated,
                                               NameManager& names);

/// New names for what is in the users' blocks, file by file: what the model's elements that they define or speak of are
/// called in the script; numbers for what CSPM predefines or the library has, for what several files declare, and for
/// channels and constructors called like a value inside the generated modules, whose names are RoboTool's.
[[nodiscard]] std::vector<cspm::QualifiedNames> new_names_of_theirs(const std::vector<FileBlocks>& files,
                                                                    const NamesForBlocks& of_model,
                                                                    const std::vector<cspm::DeclPtr>& generated,
                                                                    NameManager& names);

/// Predefined and library names that the declarations call and that something declared or bound around the call would
/// be taken for. There are none in what is generated, or it is an internal error.
[[nodiscard]] std::set<std::string> captured(const std::vector<cspm::DeclPtr>& generated);

}  // namespace robochart::csp_emit
