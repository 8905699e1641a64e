// SPDX-License-Identifier: Apache-2.0
#include "tests/contents.hpp"

#include <fstream>
#include <iterator>

namespace robochart::tests {

std::string read_contents(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace robochart::tests
