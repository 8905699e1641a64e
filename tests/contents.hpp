// SPDX-License-Identifier: Apache-2.0
// Reads whole files for tests.
#pragma once

#include <filesystem>
#include <string>

namespace robochart::tests {

/// Returns the bytes of a file, or "" if it cannot be read.
[[nodiscard]] std::string read_contents(const std::filesystem::path& path);

}  // namespace robochart::tests
