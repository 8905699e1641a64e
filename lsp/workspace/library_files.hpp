// The libraries of the language as files that an editor can open.
#pragma once

#include <string>
#include <string_view>

namespace robochart::lsp {

/// The installed file of a library, whose text came with the program under the name `<library>/PACKAGE.rct`: below the
/// folder that the program is installed in, or in the sources that it was built from. "" if there is none, or one with
/// another text.
[[nodiscard]] std::string library_file(std::string_view name, std::string_view text);

}  // namespace robochart::lsp
