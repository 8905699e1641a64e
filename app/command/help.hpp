// SPDX-License-Identifier: Apache-2.0
// Generates the help, the man page and the completions for shells from the tables of option_table.hpp.
#pragma once

#include <string>

#include "app/command/option_table.hpp"

namespace robochart::app {

/// Returns the help of the program.
[[nodiscard]] std::string program_help();
/// Returns the help of a verb.
[[nodiscard]] std::string verb_help(const VerbRow&);
/// Returns the help of `emit`, which lists the verbs that may follow the word `emit`.
[[nodiscard]] std::string emit_help();
/// Returns "usage: robochart-verify check [OPTIONS] MODEL...".
[[nodiscard]] std::string usage_line(const VerbRow&);

/// Returns the manual page for section 1 in the macros of man(7).
[[nodiscard]] std::string manual_page();
[[nodiscard]] std::string bash_completion();
[[nodiscard]] std::string zsh_completion();
[[nodiscard]] std::string fish_completion();

}  // namespace robochart::app
