// SPDX-License-Identifier: Apache-2.0
#include "driver/results/basis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

namespace robochart::driver {

std::string_view name_of(GroundKind kind) {
    constexpr std::array<std::string_view, 10> names{"guard",       "bound",      "noTime",   "timeStops", "ended",
                                                     "neverAtRest", "neverAsked", "constant", "sampling",  "carriers"};
    return names[static_cast<std::size_t>(kind)];
}

void add(Basis& basis, Ground ground) {
    if (std::ranges::find(basis, ground) == basis.end()) basis.push_back(std::move(ground));
}

std::optional<runs::Place> region_of(const diagnostics::SourceManager& sources, diagnostics::Span span) {
    if (!span.is_known()) return std::nullopt;
    const diagnostics::Position begin = sources.position(span.source, span.begin);
    const diagnostics::Position end = sources.position(span.source, span.end);
    return runs::Place{sources.path(span.source), begin.line, begin.column, end.line, end.column};
}

void set_place(const diagnostics::SourceManager& sources, diagnostics::Span span, Ground& ground) {
    ground.place = sources.path_and_line(span);
    ground.region = region_of(sources, span);
}

std::string ground_text(const Ground& ground) {
    return ground.place.empty() ? ground.text : fmt::format("{} ({})", ground.text, ground.place);
}

std::vector<std::string> basis_lines(const Basis& basis, std::size_t most) {
    std::vector<std::string> lines;
    std::map<GroundKind, std::size_t> shown;
    for (std::size_t i = 0; i < basis.size(); ++i) {
        const Ground& ground = basis[i];
        if (++shown[ground.kind] <= most) lines.push_back("rests on: " + ground_text(ground));
        const bool last = i + 1 == basis.size() || basis[i + 1].kind != ground.kind;
        if (last && shown[ground.kind] > most)
            lines.push_back(fmt::format("and on {} more of this kind", shown[ground.kind] - most));
        const bool more = !last && basis[i + 1].remedy == ground.remedy;
        if (!more && !ground.remedy.empty()) lines.push_back(ground.remedy);
    }
    return lines;
}

}  // namespace robochart::driver
