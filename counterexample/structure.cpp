// SPDX-License-Identifier: Apache-2.0
// Writes the structure of a process as text, and finds the operators that block events.
#include "counterexample/structure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace robochart::runs {
namespace {

/// How many components are named; the other components are only counted.
constexpr std::size_t most_names = 3;

using Parts = std::vector<const process::Behaviour*>;

/// Returns the parts that exist in the current state.
Parts present_parts(const process::Behaviour& whole) {
    Parts result;
    for (const process::Behaviour& part : whole.parts)
        if (!part.left) result.push_back(&part);
    return result;
}

bool offers_event(const process::Behaviour& part, process::Event event) {
    return std::ranges::find(part.offered, event) != part.offered.end();
}

/// Adds the names of the components of a part that offer the event. If `event` is null, adds the names of all its
/// components.
void component_names(const process::Behaviour& part, const process::Event* event, std::vector<std::string>& names) {
    const Parts parts = present_parts(part);
    if (parts.empty() && (event == nullptr || offers_event(part, *event))) names.push_back(part.state);
    for (const process::Behaviour* inner : parts) component_names(*inner, event, names);
}

std::string list_names(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size() && i < most_names; ++i)
        text += fmt::format("{}`{}`", i == 0 ? "" : ", ", names[i]);
    if (names.size() > most_names) text += fmt::format(" and {} more", names.size() - most_names);
    return text;
}

bool is_synchronising(std::string_view op) {
    return op.starts_with("|||") || op.starts_with("[+") || op.starts_with("/+") ||
           (op.starts_with("[|") && op.ends_with("|]"));
}

/// Returns the reason why the operator above `part` blocks the part's event. Returns "" if the operator passes, renames
/// or hides the event.
std::string blocking_reason(const process::Behaviour& whole, const process::Behaviour& part, process::Event event) {
    if (whole.op == "prioritise") return "something of a higher priority is on offer";
    if (whole.op == "[…||…]") return "the parts that share it do not all offer it";
    if (!is_synchronising(whole.op)) return "";
    std::vector<std::string> others;
    for (const process::Behaviour* other : present_parts(whole))
        if (other != &part && !offers_event(*other, event)) component_names(*other, nullptr, others);
    if (others.empty()) return "";
    if (event == process::tick)
        return fmt::format("all parts terminate together, and {} cannot yet", list_names(others));
    return others.size() == 1
               ? fmt::format("{} has to take part, and does not offer it ({})", list_names(others), whole.op)
               : fmt::format("{} have to take part, and do not offer it ({})", list_names(others), whole.op);
}

void collect_blocked(const process::Behaviour& whole, std::size_t most, std::vector<Blocked>& result) {
    for (const process::Behaviour* part : present_parts(whole)) {
        for (const process::Event event : part->offered) {
            if (result.size() >= most) return;
            if (offers_event(whole, event)) continue;
            const std::string why = blocking_reason(whole, *part, event);
            std::vector<std::string> names;
            if (!why.empty()) component_names(*part, &event, names);
            if (!names.empty()) result.push_back({names.front(), event, why});
        }
        collect_blocked(*part, most, result);
    }
}

/// How many events are listed; the other events are only counted.
constexpr std::size_t most_events = 12;

}  // namespace

std::string part_text(const process::Behaviour& part) {
    return part.op.empty() ? part.name : part.op;
}

std::vector<Blocked> blocked_events(const process::Behaviour& whole, std::size_t most) {
    std::vector<Blocked> result;
    collect_blocked(whole, most, result);
    return result;
}

std::string offers_text(const process::Behaviour& part, const process::EventTable& events) {
    std::vector<std::string> names;
    for (const process::Event event : part.offered)
        if (names.size() < most_events) names.push_back(events.name(event));
    if (part.offered.size() > names.size()) names.push_back(fmt::format("{} more", part.offered.size() - names.size()));
    return fmt::format("offers {{{}}}{}", fmt::join(names, ", "), part.stable ? "" : " and hidden steps");
}

}  // namespace robochart::runs
