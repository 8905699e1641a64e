// SPDX-License-Identifier: Apache-2.0
// Contains the path of the source tree. No other file is compiled with this path, so builds in other folders can share
// all other objects in the compiler cache.
#include "tests/source_folder.hpp"

namespace robochart::tests {

std::filesystem::path source_folder() {
    return ROBOCHART_SOURCE_DIR;
}

}  // namespace robochart::tests
