// A short name for content, by which equal content is found again: BLAKE2b with 256 bits (RFC 7693), as libsodium has
// it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace robochart::diagnostics {

/// Equal for equal content, and for no other content that anybody can find.
using Digest = std::array<std::uint8_t, 32>;

/// Makes a digest of several parts. Each part counts with its length, so that parts cannot run together.
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
    /// Of all parts added. To be called once, at the end.
    [[nodiscard]] Digest finish();

private:
    void bytes(const void* first, std::size_t size);

    struct State;
    std::unique_ptr<State> state_;
};

/// "sha256-...": how a Content-Security-Policy names a script or style with this text.
[[nodiscard]] std::string policy_hash(std::string_view text);

}  // namespace robochart::diagnostics
