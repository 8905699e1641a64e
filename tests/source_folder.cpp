// SPDX-License-Identifier: Apache-2.0
// Contains the paths of the source tree and of the built command. No other file is compiled with such a path, so builds
// in other folders can share all other objects in the compiler cache.
#include "tests/source_folder.hpp"

namespace robochart::tests {

std::filesystem::path source_folder() {
    return ROBOCHART_SOURCE_DIR;
}

const char* command_path() {
    return ROBOCHART_VERIFY;
}

}  // namespace robochart::tests
