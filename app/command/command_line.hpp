// SPDX-License-Identifier: Apache-2.0
// Converts the arguments of the command to options.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/command/options.hpp"

namespace robochart::app {

/// The result of parsing the command line: options, or an exit code with a text to print.
struct Parsed {
    std::optional<Options> options;
    Exit exit = Exit::success;
    std::string message;  ///< help or version (printed to stdout), or a usage error (to stderr)
};

[[nodiscard]] Parsed parse_command_line(int argc, const char* const* argv);

}  // namespace robochart::app
