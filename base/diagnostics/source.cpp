// SPDX-License-Identifier: Apache-2.0
// Stores source texts, reads files, and converts byte offsets to lines and columns.
#include "base/diagnostics/source.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "base/diagnostics/descriptor.hpp"
#include "base/diagnostics/utf8.hpp"

namespace robochart::diagnostics {

namespace {

/// Returns the offsets at which lines begin. A line ends with LF, CR LF or a lone CR.
std::vector<std::uint32_t> find_line_starts(std::string_view text) {
    std::vector<std::uint32_t> starts{0};
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool lone_cr = text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n');
        if (text[i] == '\n' || lone_cr) starts.push_back(static_cast<std::uint32_t>(i + 1));
    }
    return starts;
}

std::string too_large(std::uintmax_t bytes) {
    return fmt::format("too large: {} bytes, at most {} are read", bytes, SourceManager::max_bytes);
}

/// Returns the reason why an open file is rejected, or "" if it can be read. A file that is not regular may have no
/// end, or reading it may block forever.
std::string rejection_reason(const struct stat& status) {
    if (S_ISDIR(status.st_mode)) return "is a folder, not a file";
    if (S_ISFIFO(status.st_mode)) return "is a pipe, not a regular file";
    if (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)) return "is a device, not a regular file";
    if (!S_ISREG(status.st_mode)) return "is not a regular file";
    const auto size = static_cast<std::uintmax_t>(status.st_size);
    return size > SourceManager::max_bytes ? too_large(size) : "";
}

/// Returns the system's message about a file that cannot be opened.
std::string cause_of_failure() {
    if (errno == ENOENT) return "no such file";
    if (errno == ENXIO) return "is a socket, or a pipe without a writer, not a regular file";
    return std::strerror(errno);
}

}  // namespace

Span join_spans(Span a, Span b) {
    if (!a.is_known()) return b;
    if (!b.is_known() || a.source != b.source) return a;
    return {a.source, std::min(a.begin, b.begin), std::max(a.end, b.end)};
}

/// Adds a text. A byte order mark at its beginning is removed, so that readers need not handle it.
SourceId SourceManager::add(std::string path, std::string text) {
    files_.push_back({std::move(path), {}, {}});
    const auto id = static_cast<SourceId>(files_.size() - 1);
    replace(id, std::move(text));
    return id;
}

std::optional<SourceId> SourceManager::load_file(const std::string& path, std::string& error) {
    // The file is opened without waiting, because opening a pipe would wait for a writer.
    const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    struct stat status {};
    if (file.get() < 0 || fstat(file.get(), &status) != 0) {
        error = cause_of_failure();
        return std::nullopt;
    }
    error = rejection_reason(status);
    if (!error.empty()) return std::nullopt;
    std::string text;
    std::vector<char> buffer(1U << 16U);
    for (;;) {
        const ssize_t count = read(file.get(), buffer.data(), buffer.size());
        if (count == 0) break;
        if (count < 0 && errno == EINTR) continue;
        if (count < 0)
            error = std::strerror(errno);
        else
            text.append(buffer.data(), static_cast<std::size_t>(count));
        // This happens if the file has grown, or if its file system reports no sizes.
        if (text.size() > max_bytes) error = too_large(text.size());
        if (!error.empty()) return std::nullopt;
    }
    return add(path, std::move(text));
}

void SourceManager::replace(SourceId id, std::string text) {
    File& file = files_.at(static_cast<std::size_t>(id));
    if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
    file.line_starts = find_line_starts(text);
    file.text = std::move(text);
}

std::string_view SourceManager::source_text(SourceId id) const {
    return files_.at(static_cast<std::size_t>(id)).text;
}

const std::string& SourceManager::path(SourceId id) const {
    return files_.at(static_cast<std::size_t>(id)).path;
}

Position SourceManager::position(SourceId id, std::uint32_t offset) const {
    const File& file = files_.at(static_cast<std::size_t>(id));
    const auto clamped = std::min<std::size_t>(offset, file.text.size());
    const auto after = std::ranges::upper_bound(file.line_starts, clamped);
    const auto line = static_cast<std::uint32_t>(after - file.line_starts.begin());
    const std::string_view before =
        std::string_view(file.text).substr(file.line_starts[line - 1], clamped - file.line_starts[line - 1]);
    const auto continuations = std::ranges::count_if(before, is_continuation);
    return {line, static_cast<std::uint32_t>(before.size() - static_cast<std::size_t>(continuations)) + 1};
}

std::string_view SourceManager::line_text(SourceId id, std::uint32_t line) const {
    const File& file = files_.at(static_cast<std::size_t>(id));
    if (line == 0 || line > file.line_starts.size()) return {};
    const std::size_t begin = file.line_starts[line - 1];
    const std::size_t end = line < file.line_starts.size() ? file.line_starts[line] : file.text.size();
    std::string_view text = std::string_view(file.text).substr(begin, end - begin);
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
    return text;
}

std::string SourceManager::path_and_line(Span span) const {
    if (!span.is_known()) return {};
    return fmt::format("{}:{}", path(span.source), position(span.source, span.begin).line);
}

}  // namespace robochart::diagnostics
