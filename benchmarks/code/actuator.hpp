// SPDX-License-Identifier: Apache-2.0
// Defines the register that every back end of the code benchmark writes. With CHECK, all stores are hashed in order.
#pragma once

#include <cstdint>

#ifdef CHECK
extern std::uint64_t reported;
inline void act(std::uint32_t value) {
    reported = (reported ^ value) * 1099511628211ULL;
}
#else
extern volatile std::uint32_t actuator;
inline void act(std::uint32_t value) {
    actuator = value;
}
#endif
