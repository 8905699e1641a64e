// SPDX-License-Identifier: Apache-2.0
// A hash of content that identifies it: BLAKE2b with 256 bits (RFC 7693), from libsodium.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace robochart::diagnostics {

/// Equal contents have equal digests. Different contents with equal digests cannot be found in practice.
using Digest = std::array<std::uint8_t, 32>;

/// Computes a digest of several parts. The lengths of the parts are included, so that the digest depends on the
/// boundaries.
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
    /// The digest of all parts added. May be called once, at the end.
    [[nodiscard]] Digest finish();

private:
    void add_bytes(const void* first, std::size_t size);

    struct State;
    std::unique_ptr<State> state_;
};

/// "sha256-...": the hash by which a Content-Security-Policy allows a script or style with this text.
[[nodiscard]] std::string policy_hash(std::string_view text);

}  // namespace robochart::diagnostics
