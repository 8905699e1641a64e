// What is generated and what users write in CSP blocks is one script. A name that both use for something of their own
// gets a number on one side: a parameter called like a channel or constructor would be a pattern that matches only that
// (checkers.md 3), a function called like one of the library, or like a predefined one, would do the other's work.
#pragma once

#include "checker/cspm/rename.hpp"
#include "csp_emit/names.hpp"

namespace robochart::csp_emit {

/// Names in CSP blocks, by what they can clash with.
struct UserNames {
    std::set<std::string> constructors;  ///< channels and constructors at the top
    std::set<std::string> all;           ///< everything declared at the top
    std::set<std::string> functions;     ///< functions and values among them
};
[[nodiscard]] UserNames user_names(const std::vector<cspm::DeclPtr>& blocks);

/// Functions and values that the declarations define at the top; those of timed sections stand there too.
[[nodiscard]] std::set<std::string> defined_names(const std::vector<cspm::DeclPtr>& decls);

/// New names for what is generated: its bound names that are a user's channel or constructor, the library's functions
/// that a user defines too, and `r__`.
[[nodiscard]] cspm::NewNames new_names_of_ours(const UserNames& theirs, const std::vector<cspm::DeclPtr>& library,
                                               const std::vector<cspm::DeclPtr>& generated, NameManager& names);

/// New names for what is in the users' blocks: what CSPM predefines, and channels and constructors called like a value
/// inside the generated modules, whose names are RoboTool's.
[[nodiscard]] cspm::NewNames new_names_of_theirs(const UserNames& theirs, const std::vector<cspm::DeclPtr>& generated,
                                                 NameManager& names);

}  // namespace robochart::csp_emit
