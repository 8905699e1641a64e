// SPDX-License-Identifier: Apache-2.0
// The number of rounds of random tests.
#pragma once

#include <cstddef>

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

/// `usual`, or a sixth of it under AddressSanitizer, where each round takes several times as long. There the tests look
/// for memory errors, which a few rounds show; other builds check the results.
constexpr std::size_t rounds(std::size_t usual) {
    return sanitized ? (usual + 5) / 6 : usual;
}

}  // namespace robochart::tests
