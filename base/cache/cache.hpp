// SPDX-License-Identifier: Apache-2.0
// Stores results of earlier runs. The key of a result is a digest of its inputs. There is one file per entry, in 16
// folders by the first digit of the file's name. Each folder is limited to its share of the total size; the least
// recently used entries are removed first. Several processes may use one cache, because a file is always complete or
// absent.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/cache/digest.hpp"

namespace robochart::diagnostics {

class Cache {
public:
    /// `program` identifies the program that makes the entries; a program does not find the entries of other programs.
    /// The folder is created if it does not exist. The folder is not used if it belongs to another user or if others
    /// may write to it.
    Cache(std::string folder, std::string program, std::uint64_t most_bytes);

    /// The entry of this key. A damaged entry is removed and not returned.
    [[nodiscard]] std::optional<std::string> find(const Digest& key);
    /// Stores an entry. If the entry cannot be written, this is not an error, because the cache only saves time. An
    /// entry larger than a quarter of a folder's share is not stored.
    void store_entry(const Digest& key, std::string_view content);

private:
    [[nodiscard]] Digest compute_seal(const Digest& key, std::string_view content) const;
    [[nodiscard]] std::string name_of(const Digest& key) const;
    void trim_folder(const std::string& folder) const;

    std::string folder_;  ///< "": the cache is not used
    std::string program_;
    std::uint64_t share_;  ///< size limit of one of its folders, in bytes
};

/// The folder for caches: robochart-verify in $XDG_CACHE_HOME or in ~/.cache (XDG Base Directory Specification); "" if
/// the environment defines neither.
[[nodiscard]] std::string cache_folder();

/// A text that differs for every build of the program: the build ID given by the linker; "" if there is none.
[[nodiscard]] std::string program_identity();

}  // namespace robochart::diagnostics
