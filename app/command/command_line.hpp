// From the arguments of the command to its options.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/command/options.hpp"
#include "semantics/instantiate/given_constants.hpp"
#include "semantics/ir/instantiation.hpp"

namespace robochart::app {

/// Result of reading the command line: options, or an exit code with a text to print.
struct Parsed {
    std::optional<Options> options;
    Exit exit = Exit::success;
    std::string message;  ///< help, version (to stdout) or a usage error (to stderr)
};

[[nodiscard]] Parsed parse_command_line(int argc, const char* const* argv);

/// Names and values of NAME=VALUE. Malformed ones, and a name that is given twice, give a message in `error`.
[[nodiscard]] ir::GivenConstants given_constants(const std::vector<std::string>&, std::string& error);

/// The instantiation part of the options. Malformed pairs give a message in `error`.
[[nodiscard]] ir::InstantiationOptions instantiation_options(const Options&, std::string& error);

}  // namespace robochart::app
