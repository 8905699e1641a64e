// SPDX-License-Identifier: Apache-2.0
// Source texts and places in them. All readers (RoboChart, CSPM, scenarios) use these types, so that one renderer can
// draw all diagnostics.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace robochart::diagnostics {

/// Index of a text in its SourceManager. Never reused.
enum class SourceId : std::uint32_t { none = 0xffffffffU };

/// A half-open range of byte offsets [begin, end) in one source text. A `none` span points to no text.
struct Span {
    SourceId source = SourceId::none;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;

    friend bool operator==(const Span&, const Span&) = default;
    [[nodiscard]] bool is_known() const { return source != SourceId::none; }
};

/// The smallest span that contains both; either may be unknown.
[[nodiscard]] Span join_spans(Span a, Span b);

/// Line and column from 1; columns count Unicode code points.
struct Position {
    std::uint32_t line = 1;
    std::uint32_t column = 1;
};

/// Owns source texts during a run. References and views that it returns are valid until the text is replaced.
class SourceManager {
public:
    /// The largest accepted text, in bytes; `load_file` rejects larger files.
    static constexpr std::size_t max_bytes = 256U << 20U;

    /// Adds a text with a path for display; the path is not opened.
    SourceId add(std::string path, std::string text);
    /// Reads a file. On failure returns no value and sets `error` to the cause in words (missing, not a regular file,
    /// unreadable, too large). All bytes are accepted; readers check them.
    std::optional<SourceId> load_file(const std::string& path, std::string& error);
    /// Replaces the text of an id; views of the old text become invalid. For editors.
    void replace(SourceId id, std::string text);

    [[nodiscard]] std::string_view source_text(SourceId id) const;
    [[nodiscard]] const std::string& path(SourceId id) const;
    [[nodiscard]] std::size_t size() const { return files_.size(); }
    /// Line and column of a byte offset (clamped to the text's end).
    [[nodiscard]] Position position(SourceId id, std::uint32_t offset) const;
    /// The text of a line (from 1) without its line end.
    [[nodiscard]] std::string_view line_text(SourceId id, std::uint32_t line) const;
    /// `path:line` of the beginning of a span; "" if it is unknown.
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
