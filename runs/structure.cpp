// See structure.hpp.
#include "runs/structure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace robochart::runs {
namespace {

/// More events than this are only counted.
constexpr std::size_t most_events = 12;

}  // namespace

std::string part_text(const process::Behaviour& part) {
    return part.op.empty() ? part.name : part.op;
}

std::string offers_text(const process::Behaviour& part, const process::EventTable& events) {
    std::vector<std::string> names;
    for (const process::Event event : part.offered)
        if (names.size() < most_events) names.push_back(events.name(event));
    if (part.offered.size() > names.size()) names.push_back(fmt::format("{} more", part.offered.size() - names.size()));
    return fmt::format("offers {{{}}}{}", fmt::join(names, ", "), part.stable ? "" : " and hidden steps");
}

}  // namespace robochart::runs
