// See structure_text.hpp.
#include "app/report/structure_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace robochart::app {
namespace {

/// More events than this are only counted.
constexpr std::size_t most_events = 12;

void write(const process::Behaviour& part, std::size_t indent, const process::EventTable& events, std::string& out) {
    out += fmt::format("{:{}}{}", "", indent, part.op.empty() ? part.name : part.op);
    if (part.parts.empty()) {
        std::vector<std::string> names;
        for (const process::Event event : part.offered)
            if (names.size() < most_events) names.push_back(events.name(event));
        if (part.offered.size() > names.size())
            names.push_back(fmt::format("{} more", part.offered.size() - names.size()));
        out += fmt::format("  offers {{{}}}{}", fmt::join(names, ", "), part.stable ? "" : " and hidden steps");
    }
    out += '\n';
    for (const process::Behaviour& each : part.parts) write(each, indent + 2, events, out);
}

}  // namespace

std::string structure_text(const std::optional<process::Behaviour>& whole, const process::EventTable& events) {
    if (!whole) return "  the structure cannot be evaluated here\n";
    std::string out;
    write(*whole, 2, events, out);
    return out;
}

}  // namespace robochart::app
