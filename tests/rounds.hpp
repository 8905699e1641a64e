// How often random tests try.
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

/// `usual`, or a sixth of it under AddressSanitizer, where everything takes several times as long: there the tests look
/// for faults of memory, which any round shows; that results are right is for the other builds to show.
constexpr std::size_t rounds(std::size_t usual) {
    return sanitized ? (usual + 5) / 6 : usual;
}

}  // namespace robochart::tests
