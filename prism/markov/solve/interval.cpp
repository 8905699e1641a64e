// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/solve/interval.hpp"

#include <cfenv>
#include <stdexcept>

namespace robochart::markov {
namespace {

/// Returns whether the processor rounds upward: only then is 1 + 2^-60 above 1. Likewise for 1/3 + 1/3 + 1/3 - 1.
bool rounds_upward() {
    volatile double one = 1;
    volatile double tiny = 0x1p-60;
    volatile double three = 3;
    const volatile double up = one + tiny;
    const volatile double third = one / three;
    const volatile double negated_third = -one / three;
    return up > one && third + negated_third > 0;
}

}  // namespace

RoundUpward::RoundUpward() : before_(std::fegetround()) {
    if (std::fesetround(FE_UPWARD) == 0 && rounds_upward()) return;
    std::fesetround(before_);
    throw std::runtime_error("this system does not round upward, so no result could be trusted");
}

RoundUpward::~RoundUpward() {
    std::fesetround(before_);
}

}  // namespace robochart::markov
