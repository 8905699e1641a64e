// SPDX-License-Identifier: Apache-2.0
// Computes SHA-256 of texts and files with libsodium. Reports contain these digests, because `sha256sum` prints the
// same digests.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace robochart::diagnostics {

/// Computes the SHA-256 of bytes that arrive in pieces.
class Sha256 {
public:
    Sha256();
    ~Sha256();
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;

    void add(std::string_view bytes);
    /// Returns the digest as 64 hexadecimal digits. It may be called only once.
    [[nodiscard]] std::string finish();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Returns the SHA-256 of a text.
[[nodiscard]] std::string sha256(std::string_view text);

}  // namespace robochart::diagnostics
