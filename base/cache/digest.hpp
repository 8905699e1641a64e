// SPDX-License-Identifier: Apache-2.0
// Computes hashes that identify contents: BLAKE2b with 256 bits (RFC 7693), from libsodium.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace robochart::diagnostics {

/// The hash of a content. Equal contents have equal digests. Different contents with equal digests cannot be found in
/// practice.
using Digest = std::array<std::uint8_t, 32>;

/// Computes the digest of several parts. The length of each part is hashed, too: "ab", "c" and "a", "bc" have different
/// digests.
class Hasher {
public:
    Hasher();
    ~Hasher();
    Hasher(const Hasher&) = delete;
    Hasher& operator=(const Hasher&) = delete;

    void add(std::string_view text);
    void add(std::uint64_t number);
    void add(std::span<const std::uint32_t> numbers);
    void add(const Digest& digest);
    /// Returns the digest of all parts that were added. It may be called only once.
    [[nodiscard]] Digest finish();

private:
    void add_bytes(const void* first, std::size_t size);

    struct State;
    std::unique_ptr<State> state_;
};

/// Returns "sha256-...", the hash by which a Content-Security-Policy allows a script or style with this text.
[[nodiscard]] std::string policy_hash(std::string_view text);

}  // namespace robochart::diagnostics
