// SPDX-License-Identifier: Apache-2.0
// See aird_files.hpp.
#include "frontend/diagrams/stored/aird_files.hpp"

#include <fstream>
#include <iterator>
#include <system_error>

namespace robochart::diagrams {

namespace fs = std::filesystem;

const Aird* AirdFiles::read(const std::string& path, diagnostics::Budget* budget) {
    std::error_code error;
    const bool regular = fs::is_regular_file(path, error);
    const fs::file_time_type changed = regular ? fs::last_write_time(path, error) : fs::file_time_type();
    const std::uintmax_t size = regular && !error ? fs::file_size(path, error) : 0;
    if (!regular || error || size > longest_aird) {
        entries_.erase(path);
        return nullptr;
    }
    auto at = entries_.find(path);
    if (at == entries_.end() || at->second.changed != changed || at->second.size != size) {
        std::ifstream in(path, std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(in), {}};
        if (entries_.size() >= most && at == entries_.end()) entries_.clear();
        at = entries_.insert_or_assign(path, Entry{changed, size, read_aird(text, budget)}).first;
    }
    return at->second.aird.error.empty() ? &at->second.aird : nullptr;
}

}  // namespace robochart::diagrams
