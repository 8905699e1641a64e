// SPDX-License-Identifier: Apache-2.0
// Stores source texts and represents places in them. All readers (RoboChart, CSPM, scenarios) use these types, so that
// one renderer can draw all diagnostics.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace robochart::diagnostics {

/// The index of a text in its SourceManager. An index is never reused.
enum class SourceId : std::uint32_t { none = 0xffffffffU };

/// A half-open range of byte offsets [begin, end) in one source text. If the source is `none`, the span is unknown.
struct Span {
    SourceId source = SourceId::none;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;

    friend bool operator==(const Span&, const Span&) = default;
    [[nodiscard]] bool is_known() const { return source != SourceId::none; }
};

/// Returns the smallest span that contains both spans. Either of them may be unknown.
[[nodiscard]] Span join_spans(Span a, Span b);

/// Line and column, counted from 1. Columns count Unicode code points.
struct Position {
    std::uint32_t line = 1;
    std::uint32_t column = 1;
};

/// Owns source texts during a run. References and views that it returns are valid until the text is replaced.
class SourceManager {
public:
    /// The maximal size of a text in bytes. `load_file` rejects larger files.
    static constexpr std::size_t max_bytes = 256U << 20U;

    /// Adds a text with a path for display. The path is not opened.
    SourceId add(std::string path, std::string text);
    /// Reads a file. On failure returns no value and sets `error` to the cause in words (missing, not a regular file,
    /// unreadable, too large). All bytes are accepted; readers must check them.
    std::optional<SourceId> load_file(const std::string& path, std::string& error);
    /// Replaces a text, for editors. Views of the old text become invalid.
    void replace(SourceId id, std::string text);

    [[nodiscard]] std::string_view source_text(SourceId id) const;
    [[nodiscard]] const std::string& path(SourceId id) const;
    [[nodiscard]] std::size_t size() const { return files_.size(); }
    /// Returns the line and the column of a byte offset. An offset after the end of the text counts as its end.
    [[nodiscard]] Position position(SourceId id, std::uint32_t offset) const;
    /// Returns the text of a line (counted from 1) without its line end.
    [[nodiscard]] std::string_view line_text(SourceId id, std::uint32_t line) const;
    /// Returns `path:line` of the beginning of a span, or "" if the span is unknown.
    [[nodiscard]] std::string path_and_line(Span span) const;

private:
    struct File {
        std::string path;
        std::string text;
        std::vector<std::uint32_t> line_starts;
    };
    std::deque<File> files_;
};

}  // namespace robochart::diagnostics
