// SPDX-License-Identifier: Apache-2.0
// Converts between paths and file URIs (RFC 3986, RFC 8089).
#pragma once

#include <string>
#include <string_view>

namespace robochart::lsp {

/// Returns a URI such as `file:///a%20b` as a path. URIs with other schemes are returned unchanged.
[[nodiscard]] std::string path_of_uri(std::string_view uri);
[[nodiscard]] std::string uri_of_path(std::string_view path);

}  // namespace robochart::lsp
