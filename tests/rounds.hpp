// SPDX-License-Identifier: Apache-2.0
// Sets the number of rounds of random tests and the sizes of extreme inputs.
#pragma once

#include <cstddef>
#include <cstdlib>

namespace robochart::tests {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif
#else
inline constexpr bool sanitized = false;
#endif

/// Returns `usual`, or a sixth of it under AddressSanitizer, where the work takes several times as long.
constexpr std::size_t size_of_input(std::size_t usual) {
    return sanitized ? (usual + 5) / 6 : usual;
}

/// Returns the distance between the positions that a test tries: `usual`, or six times as much under AddressSanitizer.
constexpr std::size_t distance_of_places(std::size_t usual) {
    return sanitized ? 6 * usual : usual;
}

/// Returns how many of `all` rounds to run: a third, or a sixth under AddressSanitizer, where the tests look for memory
/// errors and a few rounds suffice to find them. Returns `all` if the environment has ROBOCHART_ALL_ROUNDS, which
/// `tests/long.sh rounds` sets.
inline std::size_t rounds(std::size_t all) {
    if (std::getenv("ROBOCHART_ALL_ROUNDS") != nullptr) return all;
    const std::size_t parts = sanitized ? 6 : 3;
    return (all + parts - 1) / parts;
}

}  // namespace robochart::tests
