// SPDX-License-Identifier: Apache-2.0
// Implements the few functions of the tree itself.
#include "frontend/syntax/ast.hpp"

#include <algorithm>
#include <sstream>

namespace robochart::frontend {

std::string QualifiedName::text() const {
    std::string out;
    for (const std::string& part : parts) out += (out.empty() ? "" : "::") + part;
    return out;
}

bool defines_name(const CspBlock& block, std::string_view name) {
    std::istringstream lines(block.text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
        if (line.compare(begin, name.size(), name) != 0) continue;
        const std::size_t next = line.find_first_not_of(" \t", begin + name.size());
        if (next != std::string::npos && (line[next] == '=' || line[next] == '(')) return true;
    }
    return false;
}

}  // namespace robochart::frontend
