// SPDX-License-Identifier: Apache-2.0
// SHA-256 of texts and files, from libsodium. Reports contain these digests, because `sha256sum` prints the same ones.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace robochart::diagnostics {

/// The SHA-256 of bytes that arrive in pieces.
class Sha256 {
public:
    Sha256();
    ~Sha256();
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;

    void add(std::string_view bytes);
    /// 64 hexadecimal digits. May be called once, at the end.
    [[nodiscard]] std::string finish();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The SHA-256 of a text.
[[nodiscard]] std::string sha256(std::string_view text);

}  // namespace robochart::diagnostics
