// SPDX-License-Identifier: Apache-2.0
// Reads logs in MCAP files, the format of rosbag2's recordings (the MCAP specification, version 0 of the format). The
// messages of one channel contain the text of the log (docs/traces.md).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/diagnostics/pollable.hpp"

namespace robochart::conformance {

/// Thrown if an MCAP file cannot be read: its structure is wrong, a chunk cannot be decompressed, or it has no log.
struct McapFault : std::runtime_error {
    McapFault(const std::string& message, std::uint64_t offset) : std::runtime_error(message), at(offset) {}
    std::uint64_t at;  ///< the position of the error, in bytes from the beginning of the file
};

/// Returns whether a file with these first bytes is an MCAP file.
[[nodiscard]] bool is_mcap(std::string_view bytes);

/// Returns whether a file with this path in a folder of logs is a log: its name ends in `.trace` or `.mcap`.
[[nodiscard]] bool is_log_path(const std::string& path);

/// Returns the text of the log in an MCAP file. Throws McapFault.
[[nodiscard]] std::string read_mcap(std::string_view bytes, diagnostics::Pollable&);

/// Opens a log for reading. The log is a text, or is in an MCAP file, which is read into memory. Returns null if the
/// file is not a readable regular file. Throws McapFault; its message then contains the offset.
[[nodiscard]] std::unique_ptr<std::istream> open_log(const std::string& path, diagnostics::Pollable&);

}  // namespace robochart::conformance
