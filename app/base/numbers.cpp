// SPDX-License-Identifier: Apache-2.0
#include "app/base/numbers.hpp"

#include <fmt/format.h>

namespace robochart::app {

std::string with_commas(std::uint64_t value) {
    std::string digits = fmt::format("{}", value);
    for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, ",");
    return digits;
}

std::string count_text(std::uint64_t count, std::string_view noun) {
    return fmt::format("{} {}{}", with_commas(count), noun, count == 1 ? "" : "s");
}

}  // namespace robochart::app
