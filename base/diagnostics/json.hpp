// SPDX-License-Identifier: Apache-2.0
// Writes JSON for programs. It uses nlohmann's ordered_json, which preserves the order of keys.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace robochart::diagnostics {

using Json = nlohmann::ordered_json;

/// Returns the value as text: on one line, or with `indent` blanks per level. Bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string json_text(const Json& value, int indent = -1);
/// Returns a value rounded to `places` decimal places, for times and rates.
[[nodiscard]] double round_to_places(double value, int places);

}  // namespace robochart::diagnostics
