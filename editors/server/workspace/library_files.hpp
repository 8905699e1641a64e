// SPDX-License-Identifier: Apache-2.0
// Finds the libraries of the language as files that an editor can open.
#pragma once

#include <string>
#include <string_view>

namespace robochart::lsp {

/// Returns the file of a library whose text is built into the program under the name `<library>/PACKAGE.rct`. The file
/// is searched for below the installation folder and in the source tree. Returns "" if there is no file with exactly
/// this text.
[[nodiscard]] std::string library_file(std::string_view name, std::string_view text);

}  // namespace robochart::lsp
