// SPDX-License-Identifier: Apache-2.0
#include "checker/storage/storage_error.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

#include "base/diagnostics/escape.hpp"

namespace robochart::storage {

void cannot_open(const std::string& path, int error) {
    const std::string why =
        fmt::format("{}: cannot be read: {}", diagnostics::escape_for_display(path), std::strerror(error));
    if (error == EMFILE || error == ENFILE) throw diagnostics::LimitReached(why);
    throw BadFile(why);
}

}  // namespace robochart::storage
