// SPDX-License-Identifier: Apache-2.0
// Reads and writes files. Below the root, every step goes from an open folder to a name in it (openat, mkdirat,
// renameat with O_NOFOLLOW). So a link that is inserted between a check and the use of the checked path is not
// followed.
#include "base/diagnostics/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <utility>

#include "base/diagnostics/descriptor.hpp"

namespace robochart::diagnostics {

namespace {

namespace fs = std::filesystem;

std::string failure_message(const std::string& path, const std::string& cause) {
    return fmt::format("cannot write {}: {}", path, cause);
}
std::string failure_message(const std::string& path) {
    return failure_message(path, std::strerror(errno));
}

constexpr std::string_view unfinished = ".robochart-";

std::string random_name() {
    std::uint64_t number = 0;
    if (getrandom(&number, sizeof number, 0) != sizeof number) return "";
    return fmt::format("{}{:016x}", unfinished, number);
}

bool leads_below(const fs::path& relative) {
    if (relative.empty() || relative.is_absolute() || !relative.has_filename()) return false;
    for (const fs::path& part : relative)
        if (part == ".." || part == "." || part.native().find('\0') != std::string::npos) return false;
    return true;
}

/// Opens a subfolder of an open folder. Creates the subfolder if it does not exist.
Descriptor folder_in(const Descriptor& above, const std::string& name) {
    if (mkdirat(above.get(), name.c_str(), 0777) != 0 && errno != EEXIST) return Descriptor();
    return Descriptor(openat(above.get(), name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
}

/// Opens the folder of the new file. Sets `error` on failure.
Descriptor folder_of(const std::string& root, const fs::path& relative, std::string& error) {
    if (!leads_below(relative)) {
        error = fmt::format("refusing to write outside {}: {}", root, relative.string());
        return Descriptor();
    }
    std::error_code code;
    fs::create_directories(root, code);
    Descriptor folder(::open(root.empty() ? "." : root.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!folder.is_open()) {
        error = fmt::format("cannot create the folder {}: {}", root, code ? code.message() : std::strerror(errno));
        return folder;
    }
    fs::path at = root;
    for (const fs::path& part : relative.parent_path()) {
        at /= part;
        Descriptor next = folder_in(folder, part.string());
        if (!next.is_open()) {
            const bool link = errno == ELOOP || (errno == ENOTDIR && fs::is_symlink(at, code));
            error = link ? fmt::format("refusing to write below {}: it is a symbolic link", at.string())
                         : fmt::format("cannot create the folder {}: {}", at.string(), std::strerror(errno));
            return next;
        }
        folder = std::move(next);
    }
    return folder;
}

bool write_whole(int file, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = write(file, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

/// Creates a file in an open folder and sets its name. On failure, the result is not open and errno is set.
Descriptor new_file(const Descriptor& folder, mode_t mode, std::string& name) {
    for (int attempt = 0; attempt < 100; ++attempt) {
        name = random_name();
        if (name.empty()) break;
        Descriptor file(openat(folder.get(), name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode));
        if (file.is_open() || errno != EEXIST) return file;
    }
    return Descriptor();
}

/// Writes the file and moves it to its place. `before` is the file that it replaces, whose properties are preserved, or
/// null for a new file.
std::string write_and_rename(const Descriptor& folder, const fs::path& path, std::string_view text,
                             const struct stat* before, Budget* budget) {
    std::string name;
    Descriptor file = new_file(folder, before != nullptr ? 0600 : 0666, name);
    if (!file.is_open()) return failure_message(path.string());
    const fs::path parent = path.parent_path();
    const Budget::Held held(budget, (parent / name).string());
    bool good = write_whole(file.get(), text);
    if (good && before != nullptr) {
        // The owner is preserved if the system permits it; the mode is always preserved.
        (void)!fchown(file.get(), before->st_uid, before->st_gid);
        good = fchmod(file.get(), before->st_mode & 07777U) == 0 && fsync(file.get()) == 0;
    }
    good = good && file.close() && renameat(folder.get(), name.c_str(), folder.get(), path.filename().c_str()) == 0;
    if (good) return "";
    std::string error = failure_message(path.string());
    unlinkat(folder.get(), name.c_str(), 0);
    return error;
}

}  // namespace

bool is_unfinished(const std::string& name) {
    return name.size() == unfinished.size() + 16 && name.starts_with(unfinished) &&
           name.find_first_not_of("0123456789abcdef", unfinished.size()) == std::string::npos;
}

std::string write_below(const std::string& root, const std::string& relative, std::string_view text, Budget* budget) {
    std::string error;
    const Descriptor folder = folder_of(root, relative, error);
    return folder.is_open() ? write_and_rename(folder, fs::path(root) / relative, text, nullptr, budget) : error;
}

std::string replace_file(const std::string& named, std::string_view text, Budget* budget) {
    std::error_code code;
    const bool there = fs::symlink_status(named, code).type() != fs::file_type::not_found;
    const fs::path path = there ? fs::canonical(named, code) : fs::absolute(named, code);
    if (code) return failure_message(named, code.message());
    const fs::path parent = path.parent_path();
    if (!there) fs::create_directories(parent, code);
    const Descriptor folder(::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!folder.is_open()) return failure_message(named);
    if (!there) return write_and_rename(folder, path, text, nullptr, budget);
    struct stat before {};
    if (fstatat(folder.get(), path.filename().c_str(), &before, AT_SYMLINK_NOFOLLOW) != 0)
        return failure_message(named);
    if (!S_ISREG(before.st_mode)) return failure_message(named, "it is not a regular file");
    if (faccessat(folder.get(), path.filename().c_str(), W_OK, AT_EACCESS) != 0) return failure_message(named);
    const std::string error = write_and_rename(folder, path, text, &before, budget);
    if (error.empty()) (void)fsync(folder.get());
    return error;
}

namespace {

/// Shortens `./a.rct` to `a.rct`, for files below the folder `.`.
std::string shown_path(std::string path) {
    while (path.size() > 2 && path.starts_with("./")) {
        const std::size_t name = path.find_first_not_of('/', 1);
        if (name == std::string::npos) break;
        path.erase(0, name);
    }
    return path;
}

void gather_files(const fs::path& folder, bool deep, FilesBelow& result) {
    std::error_code code;
    fs::directory_iterator at(folder, code);
    for (; !code && at != fs::directory_iterator(); at.increment(code)) {
        if (at->path().filename().string().starts_with(".")) continue;
        std::error_code status;
        if (!at->is_directory(status))
            result.files.push_back(shown_path(at->path().string()));
        else if (deep && !at->is_symlink(status))
            gather_files(at->path(), deep, result);
    }
    if (code) result.unreadable.emplace_back(folder.string(), code.message());
}

}  // namespace

FilesBelow files_below(const std::string& folder, bool deep) {
    FilesBelow result;
    gather_files(folder, deep, result);
    std::ranges::sort(result.files,
                      [](const std::string& a, const std::string& b) { return fs::path(a) < fs::path(b); });
    return result;
}

std::string standard_input(std::size_t most, std::string& error) {
    std::string text;
    std::array<char, 1U << 16U> buffer{};
    ssize_t got = 1;
    while (got != 0 && text.size() <= most) {
        got = ::read(STDIN_FILENO, buffer.data(), buffer.size());
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) {
            error = std::strerror(errno);
            return {};
        }
        text.append(buffer.data(), static_cast<std::size_t>(got));
    }
    if (text.size() > most) error = "too large";
    return text;
}

namespace {

std::string made_folder(const std::string& parent, std::string& error) {
    std::error_code code;
    const fs::path in = parent.empty() ? fs::temp_directory_path(code) : fs::path(parent);
    std::string name = (in / "robochart-XXXXXX").string();
    if (!code && mkdtemp(name.data()) != nullptr) return name;
    error = fmt::format("cannot make a folder in {}: {}", in.empty() ? parent : in.string(),
                        code ? code.message() : std::strerror(errno));
    return "";
}

}  // namespace

TemporaryFolder::TemporaryFolder(const std::string& parent, std::string& error, Budget* budget)
    : path_(made_folder(parent, error)), held_(path_.empty() ? nullptr : budget, path_) {}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
}

GrowingFile::GrowingFile(std::string root, std::string relative, Budget* budget)
    : root_(std::move(root)), relative_(std::move(relative)), budget_(budget) {}

GrowingFile::~GrowingFile() {
    if (!temporary_.empty()) unlink(temporary_.c_str());
}

std::string GrowingFile::append(std::string_view text) {
    if (!error_.empty()) return error_;
    const std::string path = (fs::path(root_) / relative_).string();
    Descriptor file;
    if (temporary_.empty()) {
        const Descriptor folder = folder_of(root_, relative_, error_);
        if (!folder.is_open()) return error_;
        std::string name;
        file = new_file(folder, 0666, name);
        if (!file.is_open()) return error_ = failure_message(path);
        temporary_ = (fs::path(path).parent_path() / name).string();
        held_ = std::make_unique<Budget::Held>(budget_, temporary_);
    } else {
        file = Descriptor(::open(temporary_.c_str(), O_WRONLY | O_APPEND | O_NOFOLLOW | O_CLOEXEC));
    }
    if (!file.is_open() || !write_whole(file.get(), text) || !file.close()) error_ = failure_message(path);
    return error_;
}

std::string GrowingFile::finish() {
    if (!error_.empty() || temporary_.empty()) return error_;
    const std::string path = (fs::path(root_) / relative_).string();
    if (rename(temporary_.c_str(), path.c_str()) != 0) return error_ = failure_message(path);
    temporary_.clear();
    held_.reset();
    return "";
}

}  // namespace robochart::diagnostics
