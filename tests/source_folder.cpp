// The only file that is compiled with the path, so that trees at other places share all other objects of a compiler
// cache.
#include "tests/source_folder.hpp"

namespace robochart::tests {

std::filesystem::path source_folder() {
    return ROBOCHART_SOURCE_DIR;
}

}  // namespace robochart::tests
