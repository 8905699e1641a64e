// SPDX-License-Identifier: Apache-2.0
// Formats numbers for people.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace robochart::app {

/// Returns the number as "1,234,567".
[[nodiscard]] std::string with_commas(std::uint64_t value);
/// Returns "1 run", "1,024 runs".
[[nodiscard]] std::string count_text(std::uint64_t count, std::string_view noun);

}  // namespace robochart::app
