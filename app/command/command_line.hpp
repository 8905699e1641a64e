// SPDX-License-Identifier: Apache-2.0
// Converts the arguments of the command to options.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/command/options.hpp"
#include "semantics/instantiate/given_constants.hpp"
#include "semantics/ir/instantiation.hpp"

namespace robochart::app {

/// The result of parsing the command line: options, or an exit code with a text to print.
struct Parsed {
    std::optional<Options> options;
    Exit exit = Exit::success;
    std::string message;  ///< help or version (for stdout), or a usage error (for stderr)
};

[[nodiscard]] Parsed parse_command_line(int argc, const char* const* argv);

/// Parses NAME=VALUE pairs. Malformed pairs and duplicate names are reported in `error`.
[[nodiscard]] ir::GivenConstants given_constants(const std::vector<std::string>&, std::string& error);

/// The options for the instantiation. Malformed pairs are reported in `error`.
[[nodiscard]] ir::InstantiationOptions instantiation_options(const Options&, std::string& error);

}  // namespace robochart::app
