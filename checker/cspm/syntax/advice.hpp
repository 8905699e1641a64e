// What a mistake in a script probably means: by what was expected and what was found (parser.hpp).
#pragma once

#include <span>
#include <string_view>

namespace robochart::cspm {

/// One row; "" stands for anything.
struct Advice {
    std::string_view expected;  ///< as the message says it: "'else'"
    std::string_view found;     ///< the token's text: "<-"
    std::string_view advice;    ///< a sentence without full stop
};

/// The first row that fits; "" if none does.
[[nodiscard]] std::string_view advice_on(std::string_view expected, std::string_view found);
/// All rows, for the tests.
[[nodiscard]] std::span<const Advice> all_advice();

}  // namespace robochart::cspm
