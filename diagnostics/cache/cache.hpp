// What earlier runs have worked out, found again by the content that it was worked out from. A file for each entry, in
// 16 folders by the first digit of its name; each folder is kept below its share of the whole, the entries unused for
// longest leave first. Several processes may use one folder: a file is there as a whole or not at all.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "diagnostics/cache/digest.hpp"

namespace robochart::diagnostics {

class Cache {
public:
    /// `program`: which program it is that makes the entries; one does not find what another has kept. The folder is
    /// made if it is not there. One that belongs to somebody else, or that others may write to, is not used.
    Cache(std::string folder, std::string program, std::uint64_t most_bytes);

    /// The entry of this key. What is damaged is removed and not found.
    [[nodiscard]] std::optional<std::string> find(const Digest& key);
    /// Keeps an entry, if it can be written; the cache is a help, so it is no error where it cannot. An entry of more
    /// than a quarter of a folder's share is not kept.
    void keep(const Digest& key, std::string_view content);

private:
    [[nodiscard]] Digest seal(const Digest& key, std::string_view content) const;
    [[nodiscard]] std::string name_of(const Digest& key) const;
    void trim(const std::string& folder) const;

    std::string folder_;  ///< "": nothing is found or kept
    std::string program_;
    std::uint64_t share_;  ///< bytes of one of its folders
};

/// The folder for caches: robochart-verify in $XDG_CACHE_HOME or in ~/.cache (XDG Base Directory Specification); ""
/// where the environment names none.
[[nodiscard]] std::string cache_folder();

/// What tells this program from every other that was built: the build ID that the linker gave it; "" where it has none.
[[nodiscard]] std::string program_identity();

}  // namespace robochart::diagnostics
