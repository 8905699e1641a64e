// SPDX-License-Identifier: Apache-2.0
#include "base/cache/cache.hpp"

#include <elf.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <link.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <vector>

#include "base/diagnostics/descriptor.hpp"
#include "base/diagnostics/files.hpp"

namespace robochart::diagnostics {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t folders = 16;
// The largest entry is this fraction of a folder's share. A larger file is not read.
constexpr std::uint64_t largest_part = 4;

/// Returns true if the folder exists or can be created, and only this user can write to it.
bool is_usable_folder(const std::string& folder) {
    std::error_code code;
    fs::create_directories(fs::path(folder).parent_path(), code);
    if (mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) return false;
    struct stat found {};
    return stat(folder.c_str(), &found) == 0 && S_ISDIR(found.st_mode) && found.st_uid == geteuid() &&
           (found.st_mode & (S_IWGRP | S_IWOTH)) == 0;
}

/// Returns the contents of a regular file of at most `most_bytes` bytes. The size is read from the open file, so a file
/// that replaces it meanwhile has no effect.
std::optional<std::string> read_whole(const std::string& path, std::uint64_t most_bytes) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK));
    struct stat found {};
    if (!file.is_open() || fstat(file.get(), &found) != 0 || !S_ISREG(found.st_mode)) return std::nullopt;
    if (static_cast<std::uint64_t>(found.st_size) > most_bytes) return std::nullopt;
    std::string text(static_cast<std::size_t>(found.st_size), '\0');
    std::size_t have = 0;
    while (have < text.size()) {
        const ssize_t got = ::read(file.get(), text.data() + have, text.size() - have);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return std::nullopt;
        have += static_cast<std::size_t>(got);
    }
    futimens(file.get(), nullptr);  // sets the time of the last use to now
    return text;
}

}  // namespace

Cache::Cache(std::string folder, std::string program, std::uint64_t most_bytes)
    : folder_(std::move(folder)), program_(std::move(program)), share_(most_bytes / folders) {
    if (!folder_.empty() && (program_.empty() || !is_usable_folder(folder_))) folder_.clear();
}

/// Returns a digest of key, program and content. It shows that the entry belongs to this key and program, and that it
/// is complete.
Digest Cache::compute_seal(const Digest& key, std::string_view content) const {
    Hasher hasher;
    hasher.add(program_);
    hasher.add(key);
    hasher.add(content);
    return hasher.finish();
}

std::string Cache::name_of(const Digest& key) const {
    Hasher hasher;
    hasher.add(program_);
    hasher.add(key);
    std::string name;
    for (const std::uint8_t byte : hasher.finish()) name += fmt::format("{:02x}", byte);
    return name.insert(1, "/");
}

std::optional<std::string> Cache::find(const Digest& key) {
    if (folder_.empty()) return std::nullopt;
    const std::string path = fmt::format("{}/{}", folder_, name_of(key));
    const std::size_t sealed = Digest().size();
    std::optional<std::string> text = read_whole(path, share_ / largest_part + sealed);
    if (!text) return std::nullopt;
    if (text->size() >= sealed) {
        const Digest expected = compute_seal(key, std::string_view(*text).substr(sealed));
        if (std::memcmp(text->data(), expected.data(), sealed) == 0) return text->substr(sealed);
    }
    unlink(path.c_str());
    return std::nullopt;
}

void Cache::store_entry(const Digest& key, std::string_view content) {
    if (folder_.empty() || content.size() > share_ / largest_part) return;
    const Digest sealed = compute_seal(key, content);
    std::string text(sealed.begin(), sealed.end());
    text += content;
    const std::string name = name_of(key);
    if (write_below(folder_, name, text).empty()) trim_folder(fmt::format("{}/{}", folder_, name.substr(0, 1)));
}

/// Removes the least recently used entries if the size limit is exceeded. Also removes incomplete files of processes
/// that were killed.
void Cache::trim_folder(const std::string& folder) const {
    struct Entry {
        fs::file_time_type used;
        std::uint64_t bytes;
        fs::path path;
    };
    constexpr std::chrono::hours abandoned(1);
    const auto now = fs::file_time_type::clock::now();
    std::vector<Entry> entries;
    std::uint64_t bytes = 0;
    std::error_code code;
    fs::directory_iterator at(folder, code);
    for (; !code && at != fs::directory_iterator(); at.increment(code)) {
        std::error_code gone;  // set if another process has removed the entry
        const Entry entry{at->last_write_time(gone), at->file_size(gone), at->path()};
        if (gone) continue;
        if (entry.path.filename().native().starts_with(".")) {
            if (now - entry.used > abandoned) fs::remove(entry.path, gone);
            continue;
        }
        bytes += entry.bytes;
        entries.push_back(entry);
    }
    if (bytes <= share_) return;
    std::ranges::sort(entries, [](const Entry& a, const Entry& b) { return a.used < b.used; });
    for (const Entry& entry : entries) {
        if (bytes <= share_ / 4 * 3) break;
        fs::remove(entry.path, code);
        bytes -= entry.bytes;
    }
}

std::string cache_folder() {
    const auto named = [](const char* variable) {
        const char* const value = std::getenv(variable);
        return std::string(value == nullptr || *value != '/' ? "" : value);
    };
    const std::string home = named("HOME");
    std::string base = named("XDG_CACHE_HOME");
    if (base.empty() && !home.empty()) base = home + "/.cache";
    return base.empty() ? "" : base + "/robochart-verify";
}

std::string program_identity() {
    std::string identity;
    // The program itself is the first object in the list.
    const auto look = [](dl_phdr_info* info, std::size_t /*size*/, void* result) {
        for (int i = 0; i < info->dlpi_phnum; ++i) {
            const ElfW(Phdr)& header = info->dlpi_phdr[i];
            if (header.p_type != PT_NOTE) continue;
            const char* at = reinterpret_cast<const char*>(info->dlpi_addr + header.p_vaddr);
            const char* const end = at + header.p_memsz;
            while (at + sizeof(ElfW(Nhdr)) <= end) {
                ElfW(Nhdr) note;
                std::memcpy(&note, at, sizeof note);
                const char* const name = at + sizeof note;
                const char* const content = name + (std::size_t{note.n_namesz} + 3) / 4 * 4;
                if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 && std::memcmp(name, "GNU", 4) == 0)
                    static_cast<std::string*>(result)->assign(content, note.n_descsz);
                at = content + (std::size_t{note.n_descsz} + 3) / 4 * 4;
            }
        }
        return 1;
    };
    dl_iterate_phdr(look, &identity);
    return identity;
}

}  // namespace robochart::diagnostics
