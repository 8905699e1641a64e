// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/machine/frame_layout.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace robochart::cpp_emit {

FrameLayout arrange(std::vector<Field> fields, bool timed) {
    std::stable_sort(fields.begin(), fields.end(),
                     [](const Field& a, const Field& b) { return a.alignment > b.alignment; });
    FrameLayout layout;
    layout.timed = timed;
    for (const Field& field : fields) {
        layout.size += field.size;
        layout.alignment = std::max(layout.alignment, field.alignment);
    }
    if (const std::size_t rest = layout.size % layout.alignment; rest != 0) {
        const std::size_t filler = layout.alignment - rest;
        fields.push_back(
            {"std::uint8_t", fmt::format("filler[{}]", filler), "{}", "keeps the bytes canonical", filler, 1});
        layout.size += filler;
    }
    layout.fields = std::move(fields);
    return layout;
}

}  // namespace robochart::cpp_emit
