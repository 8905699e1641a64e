// SPDX-License-Identifier: Apache-2.0
// Tests MCAP files with any content. The reader finds an error at a byte of the file, or a log that is in the file.
#include <fmt/format.h>

#include <algorithm>

#include "conformance/traces/mcap.hpp"
#include "tests/fuzz/targets/targets.hpp"

namespace robochart::fuzz {

std::string run_mcap(std::string_view bytes) {
    try {
        const std::string text = conformance::read_mcap(bytes, diagnostics::unlimited);
        for (const char* const compression : {"zstd", "lz4"})
            if (bytes.find(compression) != std::string_view::npos) return {};  // the log may be compressed
        // Each message needs 31 bytes in the file, and adds at most a line break.
        if (text.size() > bytes.size()) return fmt::format("{} bytes give a log of {}", bytes.size(), text.size());
        std::string_view rest = text;
        while (!rest.empty()) {
            const std::string_view line = rest.substr(0, rest.find('\n'));
            if (bytes.find(line) == std::string_view::npos) return "a line of the log is not in the file";
            rest.remove_prefix(std::min(rest.size(), line.size() + 1));
        }
    } catch (const conformance::McapFault& fault) {
        if (fault.at > bytes.size()) return fmt::format("an error at byte {} of {}", fault.at, bytes.size());
        if (std::string_view(fault.what()).empty()) return "an error without a message";
    }
    return {};
}

}  // namespace robochart::fuzz
