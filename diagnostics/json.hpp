// A string as JSON; all the writing of JSON that diagnostics need.
#pragma once

#include <string>
#include <string_view>

namespace robochart::diagnostics {

/// The text as a JSON string literal, quotes included (RFC 8259, 7). Bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string json_string(std::string_view text);

}  // namespace robochart::diagnostics
