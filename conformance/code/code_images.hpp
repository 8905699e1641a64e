// SPDX-License-Identifier: Apache-2.0
// Numbers the states of compiled code, which are byte images.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "cpp_emit/runtime/explore_abi.h"

namespace robochart::conformance {

/// The maximal length of a state's text. Longer texts are truncated; the text of a state of 64 KiB is shorter than
/// this.
inline constexpr std::size_t longest_state_text = 1U << 20U;

/// Returns a state as the code's function prints it.
[[nodiscard]] std::string state_text(void (*print)(const void*, char*, std::size_t), const void* state);

class CodeImages {
public:
    using Bytes = std::vector<unsigned char>;

    explicit CodeImages(const rc_interface& code);

    /// Returns the number of the image before the first cycle.
    [[nodiscard]] std::uint32_t reset() const { return reset_; }
    /// Returns whether `initial` writes the whole state, for any previous contents of the memory.
    [[nodiscard]] bool reset_writes_all() const { return reset_writes_all_; }
    std::uint32_t intern(const Bytes&);
    [[nodiscard]] Bytes bytes(std::uint32_t image) const;
    [[nodiscard]] bool has_bytes(std::uint32_t image, const Bytes&) const;
    [[nodiscard]] std::string print(std::uint32_t image) const;
    [[nodiscard]] std::uint64_t size() const { return count_; }
    /// Returns whether two images with different bytes have the same text. If so, the state is not canonical, and the
    /// reported numbers of states are larger than necessary.
    [[nodiscard]] bool alias_found() const { return alias_found_; }

private:
    [[nodiscard]] Bytes fresh_state(unsigned char fill) const;

    const rc_interface* code_;
    std::uint64_t count_ = 0;
    Bytes images_;
    std::string key_;  ///< of the image that is looked up; a member, so that it is allocated once
    std::unordered_map<std::string, std::uint32_t> ids_;  ///< never iterated, like the map below
    std::unordered_map<std::string, std::uint32_t> printed_;
    std::uint32_t reset_ = 0;
    bool reset_writes_all_ = true;
    bool alias_found_ = false;
};

}  // namespace robochart::conformance
