// Source texts: storage, reading files, and turning byte offsets into lines and columns.
#include "diagnostics/source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace robochart::diagnostics {

namespace {

/// Offsets at which lines begin. A line ends with LF, CR LF or a lone CR.
std::vector<std::uint32_t> find_line_starts(std::string_view text) {
    std::vector<std::uint32_t> starts{0};
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool lone_cr = text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n');
        if (text[i] == '\n' || lone_cr) starts.push_back(static_cast<std::uint32_t>(i + 1));
    }
    return starts;
}

bool is_continuation(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// Why a path can't be read as a file; empty if nothing speaks against it.
std::string refuse(const std::filesystem::path& path) {
    std::error_code code;
    const auto status = std::filesystem::status(path, code);
    if (status.type() == std::filesystem::file_type::not_found) return "no such file";
    if (status.type() == std::filesystem::file_type::directory) return "is a folder, not a file";
    if (code) return code.message();
    if (status.type() != std::filesystem::file_type::regular) return {};
    const auto size = std::filesystem::file_size(path, code);
    if (!code && size > SourceManager::max_bytes)
        return fmt::format("too large: {} bytes, at most {} are read", size, SourceManager::max_bytes);
    return {};
}

}  // namespace

Span join(Span a, Span b) {
    if (!a.known()) return b;
    if (!b.known() || a.source != b.source) return a;
    return {a.source, std::min(a.begin, b.begin), std::max(a.end, b.end)};
}

SourceId SourceManager::add(std::string path, std::string text) {
    auto starts = find_line_starts(text);
    files_.push_back({std::move(path), std::move(text), std::move(starts)});
    return static_cast<SourceId>(files_.size() - 1);
}

std::optional<SourceId> SourceManager::load(const std::string& path, std::string& error) {
    error = refuse(path);
    if (!error.empty()) return std::nullopt;
    errno = 0;
    std::ifstream in(path, std::ios::binary);
    if (!in) {
        error = errno != 0 ? std::strerror(errno) : "cannot be opened";
        return std::nullopt;
    }
    // Read in pieces, so that an endless special file is refused too.
    std::string text;
    std::vector<char> buffer(1U << 16U);
    while (in.read(buffer.data(), static_cast<std::streamsize>(buffer.size())), in.gcount() > 0) {
        text.append(buffer.data(), static_cast<std::size_t>(in.gcount()));
        if (text.size() > max_bytes) {
            error = fmt::format("too large: at most {} bytes are read", max_bytes);
            return std::nullopt;
        }
    }
    if (in.bad()) {
        error = "cannot be read";
        return std::nullopt;
    }
    return add(path, std::move(text));
}

void SourceManager::replace(SourceId id, std::string text) {
    File& file = files_.at(static_cast<std::size_t>(id));
    file.line_starts = find_line_starts(text);
    file.text = std::move(text);
}

std::string_view SourceManager::text(SourceId id) const {
    return files_.at(static_cast<std::size_t>(id)).text;
}

const std::string& SourceManager::path(SourceId id) const {
    return files_.at(static_cast<std::size_t>(id)).path;
}

Position SourceManager::position(SourceId id, std::uint32_t offset) const {
    const File& file = files_.at(static_cast<std::size_t>(id));
    const auto clamped = std::min<std::size_t>(offset, file.text.size());
    const auto after = std::upper_bound(file.line_starts.begin(), file.line_starts.end(), clamped);
    const auto line = static_cast<std::uint32_t>(after - file.line_starts.begin());
    const std::string_view before =
        std::string_view(file.text).substr(file.line_starts[line - 1], clamped - file.line_starts[line - 1]);
    const auto continuations = std::count_if(before.begin(), before.end(), is_continuation);
    return {line, static_cast<std::uint32_t>(before.size() - static_cast<std::size_t>(continuations)) + 1};
}

std::string_view SourceManager::line(SourceId id, std::uint32_t line) const {
    const File& file = files_.at(static_cast<std::size_t>(id));
    if (line == 0 || line > file.line_starts.size()) return {};
    const std::size_t begin = file.line_starts[line - 1];
    const std::size_t end = line < file.line_starts.size() ? file.line_starts[line] : file.text.size();
    std::string_view text = std::string_view(file.text).substr(begin, end - begin);
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
    return text;
}

std::string SourceManager::place(Span span) const {
    if (!span.known()) return {};
    return fmt::format("{}:{}", path(span.source), position(span.source, span.begin).line);
}

}  // namespace robochart::diagnostics
