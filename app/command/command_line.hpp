// From the arguments of the command to its options.
#pragma once

#include <optional>
#include <string>

#include "app/command/options.hpp"
#include "semantics/ir/instantiation.hpp"

namespace robochart::app {

/// Result of reading the command line: options, or an exit code with a text to print.
struct Parsed {
    std::optional<Options> options;
    Exit exit = Exit::success;
    std::string message;  ///< help, version (to stdout) or a usage error (to stderr)
};

[[nodiscard]] Parsed parse_command_line(int argc, const char* const* argv);

/// The instantiation part of the options. Malformed pairs give a message in `error`.
[[nodiscard]] ir::InstantiationOptions instantiation_options(const Options&, std::string& error);

}  // namespace robochart::app
