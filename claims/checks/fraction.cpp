// SPDX-License-Identifier: Apache-2.0
// See fraction.hpp.
#include "claims/checks/fraction.hpp"

#include <limits>

namespace robochart::claims {

Fraction Fraction::reduced(Wide above, Wide below) {
    Wide a = above < 0 ? -above : above, b = below;
    while (b != 0) {
        const Wide rest = a % b;
        a = b;
        b = rest;
    }
    if (a != 0) {
        above /= a;
        below /= a;
    }
    constexpr Wide most = std::numeric_limits<std::int64_t>::max();
    if (above > most || above < -most || below > most) throw NotComputable("a number of the condition is too large");
    Fraction result;
    result.above_ = static_cast<std::int64_t>(above);
    result.below_ = static_cast<std::int64_t>(below);
    return result;
}

Fraction Fraction::of_decimal(std::string_view text) {
    Wide above = 0, below = 1;
    bool behind_point = false;
    for (const char c : text) {
        if (c == '.') {
            behind_point = true;
            continue;
        }
        above = above * 10 + (c - '0');
        if (behind_point) below *= 10;
        if (above > (Wide(1) << 100) || below > (Wide(1) << 100))
            throw NotComputable("a number of the condition is too large");
    }
    return reduced(above, below);
}

}  // namespace robochart::claims
