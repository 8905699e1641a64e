// SPDX-License-Identifier: Apache-2.0
// Caches files with diagrams for servers. A file is read again only if it has changed on disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "frontend/diagrams/stored/aird.hpp"

namespace robochart::diagrams {

/// The files that were requested most recently.
class AirdFiles {
public:
    /// Returns the contents of the file, or null if it does not exist or cannot be read.
    [[nodiscard]] const Aird* read(const std::string& path, diagnostics::Budget* budget);

private:
    struct Entry {
        std::filesystem::file_time_type changed;
        std::uintmax_t size = 0;
        Aird aird;
    };
    static constexpr std::size_t most = 16;
    std::map<std::string, Entry> entries_;  ///< keyed by path
};

}  // namespace robochart::diagrams
