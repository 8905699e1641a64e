// SPDX-License-Identifier: Apache-2.0
// See syntax.hpp.
#include "claims/sleec/syntax/syntax.hpp"

#include <array>

namespace robochart::sleec {

const char* dialect_name(Dialect dialect) {
    return dialect == Dialect::legos ? "LEGOS" : "SLEEC-TK";
}

const char* symbol_of(Op op) {
    constexpr std::array<const char*, 16> symbols{"",   "",  "",   "",  "or", "and", "not", "<",
                                                  "<=", ">", ">=", "=", "<>", "+",   "-",   "*"};
    return symbols[static_cast<std::size_t>(op)];
}

bool is_comparison(Op op) {
    return op >= Op::less && op <= Op::unequal;
}

const char* unit_name(Unit unit) {
    constexpr std::array<const char*, 4> names{"seconds", "minutes", "hours", "days"};
    return names[static_cast<std::size_t>(unit)];
}

std::int64_t seconds_of(Unit unit) {
    constexpr std::array<std::int64_t, 4> seconds{1, 60, 3600, 86400};
    return seconds[static_cast<std::size_t>(unit)];
}

}  // namespace robochart::sleec
