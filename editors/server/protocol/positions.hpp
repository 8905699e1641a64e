// SPDX-License-Identifier: Apache-2.0
// Converts offsets to positions of LSP 3.17 (Position), and back. Lines and columns are numbered from 0, and columns
// are measured in code units of the negotiated encoding.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "base/diagnostics/source.hpp"
#include "editors/server/protocol/json.hpp"

namespace robochart::lsp {

using diagnostics::SourceId;
using diagnostics::SourceManager;
using diagnostics::Span;

/// The unit of a column.
enum class Encoding { utf8, utf16, utf32 };

/// Returns `{line, character}` of a byte offset.
[[nodiscard]] Json lsp_position(const SourceManager&, SourceId, std::uint32_t offset, Encoding);
/// Returns `{start, end}` of a span.
[[nodiscard]] Json lsp_range(const SourceManager&, Span, Encoding);
/// Computes the positions of many offsets of one text. The text is read once, so an offset far into a long line costs
/// no more than others. The text must outlive the table.
class PositionTable {
public:
    PositionTable(const SourceManager&, SourceId, Encoding);

    /// Returns the line of a byte offset, from 0.
    [[nodiscard]] std::uint32_t line(std::uint32_t offset) const;
    /// Like the functions above, which are called for a span of another text.
    [[nodiscard]] Json lsp_position(std::uint32_t offset) const;
    [[nodiscard]] Json lsp_range(Span) const;
    /// The number of bytes that `position` has read so far, for tests.
    [[nodiscard]] std::uint64_t bytes_read() const { return bytes_read_; }

private:
    struct Line {
        std::uint32_t begin = 0, end = 0;  ///< bounds of the line, without its line end
    };
    /// A character and the number of code units before it. There is about one mark per 1,000 bytes.
    struct Mark {
        std::uint32_t offset = 0;
        std::uint32_t units = 0;
    };
    [[nodiscard]] std::uint32_t units_before(std::uint32_t offset) const;

    const SourceManager& sources_;
    SourceId source_;
    Encoding encoding_;
    std::string_view text_;
    std::vector<Line> lines_;
    std::vector<Mark> marks_;
    mutable std::uint64_t bytes_read_ = 0;
};

/// Returns the byte offset of `{line, character}`. A position beyond the end of a line or of the text means this end.
[[nodiscard]] std::uint32_t offset_of(const SourceManager&, SourceId, View position, Encoding);
/// Returns the span of `{start, end}`; the ends may be in either order.
[[nodiscard]] Span span_of(const SourceManager&, SourceId, View range, Encoding);

}  // namespace robochart::lsp
