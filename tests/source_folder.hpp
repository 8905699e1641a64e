// Where the sources lie that tests read: models, fixtures, pages.
#pragma once

#include <filesystem>

namespace robochart::tests {

/// The top of the source tree, absolute.
[[nodiscard]] std::filesystem::path source_folder();

}  // namespace robochart::tests
