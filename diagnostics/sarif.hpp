// The frame of a SARIF 2.1.0 log of this program, and its parts.
#pragma once

#include <string>
#include <string_view>

#include "diagnostics/json.hpp"
#include "diagnostics/source.hpp"

namespace robochart::diagnostics {

/// A message object.
[[nodiscard]] Json sarif_text(std::string_view message);
/// A physical location: a path, and a region from `begin` to the exclusive `end`, in code points.
[[nodiscard]] Json sarif_place(std::string_view path, Position begin, Position end);
/// One log with one run, as text. `limit`: why not everything was looked at; "" if it was.
[[nodiscard]] std::string sarif_log(const Json& rules, const Json& results, std::string_view version,
                                    std::string_view limit, const Json& properties);

}  // namespace robochart::diagnostics
