// Files with diagrams for servers: read once, and again where they change on the disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "diagrams/stored/aird.hpp"

namespace robochart::diagrams {

/// The files that were asked for last.
class AirdFiles {
public:
    /// Null where there is none, or none that can be read.
    [[nodiscard]] const Aird* read(const std::string& path, diagnostics::Budget* budget);

private:
    struct Entry {
        std::filesystem::file_time_type changed;
        std::uintmax_t size = 0;
        Aird aird;
    };
    static constexpr std::size_t most = 16;
    std::map<std::string, Entry> entries_;  ///< by their paths
};

}  // namespace robochart::diagrams
