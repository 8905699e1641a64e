// SPDX-License-Identifier: Apache-2.0
// Tests tables of positions: they give the same answers as the conversion of single offsets, and need little work for
// each offset of a long line.
#include "editors/server/protocol/positions.hpp"

#include <gtest/gtest.h>

#include "base/diagnostics/splitmix64.hpp"
#include "tests/rounds.hpp"

namespace robochart::lsp {
namespace {

/// Returns text with characters of all lengths, invalid bytes, and line ends of all kinds.
std::string any_text(std::uint64_t& state, std::size_t pieces, bool one_line) {
    const std::string_view kinds[] = {"a",    "\xc3\xbc", "\xe2\x82\xac", "\xf0\x9f\xa4\x96", "\xff", "\xe2\x82", "\n",
                                      "\r\n", "\r"};
    std::string text;
    for (std::size_t i = 0; i < pieces; ++i) text += kinds[diagnostics::splitmix64(state) % (one_line ? 6 : 9)];
    return text;
}

TEST(PositionTables, AgreeWithSinglePositions) {
    for (std::uint64_t seed = 1; seed <= tests::rounds(40); ++seed) {
        std::uint64_t state = seed;
        SourceManager sources;
        const std::string text = any_text(state, diagnostics::splitmix64(state) % 3000, seed % 2 == 0);
        const SourceId id = sources.add("a.rct", text);
        for (const Encoding encoding : {Encoding::utf8, Encoding::utf16, Encoding::utf32}) {
            const PositionTable table(sources, id, encoding);
            for (int i = 0; i < 200; ++i) {
                const auto offset = static_cast<std::uint32_t>(diagnostics::splitmix64(state) % (text.size() + 2));
                const Json single = lsp_position(sources, id, offset, encoding);
                EXPECT_EQ(json_text(table.lsp_position(offset)), json_text(single)) << seed << " at " << offset;
                EXPECT_EQ(table.line(offset), sources.position(id, offset).line - 1) << seed << " at " << offset;
            }
        }
    }
}

// The work for one offset does not grow with the length of its line.
TEST(PositionTables, ReadFewBytesForAnOffsetInALongLine) {
    std::uint64_t state = 1;
    SourceManager sources;
    const std::string text = any_text(state, 1U << 18U, true);
    const PositionTable table(sources, sources.add("a.rct", text), Encoding::utf16);
    constexpr std::uint64_t offsets = 10'000;
    for (std::uint64_t i = 0; i < offsets; ++i)
        (void)table.lsp_position(static_cast<std::uint32_t>(text.size() * i / offsets));
    EXPECT_LT(table.bytes_read(), offsets * 2048);
}

}  // namespace
}  // namespace robochart::lsp
