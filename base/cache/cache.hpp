// SPDX-License-Identifier: Apache-2.0
// Stores results of earlier runs. The key of a result is a digest of its inputs. Each entry is a file. The files are in
// 16 folders, by the first digit of their names. Each folder may use its share of the total size; its least recently
// used entries are removed first. Several processes may use one cache, because a file is always complete or absent.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/cache/digest.hpp"

namespace robochart::diagnostics {

class Cache {
public:
    /// `program` identifies the program that writes the entries; other programs do not find them. Creates the
    /// folder if it does not exist. Does not use a folder that belongs to another user or that others may write
    /// to.
    Cache(std::string folder, std::string program, std::uint64_t most_bytes);

    /// Returns the entry of this key, if there is one. A damaged entry is removed and not returned.
    [[nodiscard]] std::optional<std::string> find(const Digest& key);
    /// Stores an entry. If this fails, nothing is reported, because the cache only saves time. Does not store an entry
    /// that is larger than a quarter of a folder's share.
    void store_entry(const Digest& key, std::string_view content);

private:
    [[nodiscard]] Digest compute_seal(const Digest& key, std::string_view content) const;
    [[nodiscard]] std::string name_of(const Digest& key) const;
    void trim_folder(const std::string& folder) const;

    std::string folder_;  ///< "" if the cache is not used
    std::string program_;
    std::uint64_t share_;  ///< size limit of one of its folders, in bytes
};

/// Returns the folder for caches: robochart-verify in $XDG_CACHE_HOME or in ~/.cache (XDG Base Directory
/// Specification). Returns "" if the environment defines neither.
[[nodiscard]] std::string cache_folder();

/// Returns a text that differs for every build of the program: the build ID from the linker, or "" if there is none.
[[nodiscard]] std::string program_identity();

}  // namespace robochart::diagnostics
