// JSON for programs: nlohmann's ordered_json, whose keys stay in the order in which they are set, and its text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace robochart::diagnostics {

using Json = nlohmann::ordered_json;

/// The value as text: on one line, or with so many blanks a level. Bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string json_text(const Json& value, int indent = -1);
/// Rounded to so many decimal places, as times and rates are written.
[[nodiscard]] double rounded(double value, int places);

}  // namespace robochart::diagnostics
