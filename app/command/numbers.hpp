// Numbers as people read them.
#pragma once

#include <cstdint>
#include <string>

namespace robochart::app {

/// 1,234,567.
[[nodiscard]] std::string with_commas(std::uint64_t value);

}  // namespace robochart::app
