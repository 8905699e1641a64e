// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/machine/frame_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace robochart::cpp_emit {

namespace {

/// Returns the size of a filler member as C++ text, for members whose sizes only the compiler knows. The size is never
/// zero, because C++ has no empty arrays.
std::string filler_text(const FrameLayout& layout) {
    std::string sum;
    for (const Field& field : layout.fields) sum += (sum.empty() ? "sizeof(" : " + sizeof(") + field.type + ")";
    return fmt::format("{} - ({}) % {}", layout.alignment, sum, layout.alignment);
}

}  // namespace

FrameLayout arrange_fields(std::vector<Field> fields, bool timed) {
    std::ranges::stable_sort(fields, [](const Field& a, const Field& b) { return a.alignment > b.alignment; });
    FrameLayout layout;
    layout.timed = timed;
    for (const Field& field : fields) {
        // Members that are sorted by alignment have no padding between them.
        assert(field.alignment > 0 && field.size % field.alignment == 0);
        layout.size += field.size;
        layout.alignment = std::max(layout.alignment, field.alignment);
        layout.varies = layout.varies || field.varies;
    }
    layout.fields = std::move(fields);
    const std::size_t rest = layout.size % layout.alignment;
    const bool at_compile_time = layout.varies && layout.alignment > 1;
    if (rest == 0 && !at_compile_time) return layout;
    const std::size_t filler = layout.alignment - rest;
    const std::string text = at_compile_time ? filler_text(layout) : std::to_string(filler);
    layout.fields.push_back(
        {"std::uint8_t", fmt::format("filler[{}]", text), "{}", "keeps the bytes canonical", filler, 1});
    layout.size += filler;
    return layout;
}

}  // namespace robochart::cpp_emit
