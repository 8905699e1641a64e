// SPDX-License-Identifier: Apache-2.0
// Describes events and states: looks up the names of the script in the provenance.
#include "conformance/model/provenance_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace robochart::conformance {

namespace {

std::string with_place(const std::string& text, const ir::Origin& origin, const diagnostics::SourceManager& sources) {
    const std::string place = sources.path_and_line(origin.span);
    return place.empty() ? text : fmt::format("{} ({})", text, place);
}

}  // namespace

/// Returns the names of definitions in "A::S1__(0, 1) ‖ B::S2__": each part up to its parenthesis.
std::vector<std::string> definitions_in(const std::string& description) {
    constexpr std::string_view between = "‖";
    std::vector<std::string> names;
    for (std::size_t begin = 0; begin <= description.size();) {
        const std::size_t end = std::min(description.find(between, begin), description.size());
        const std::string_view part = std::string_view(description).substr(begin, end - begin);
        const std::size_t first = part.find_first_not_of(' ');
        const std::size_t last = part.find_first_of("( ", first == std::string_view::npos ? 0 : first);
        if (first != std::string_view::npos) names.emplace_back(part.substr(first, last - first));
        begin = end + between.size();
    }
    return names;
}

std::vector<std::string> elements_of_state(const std::string& description, const csp_emit::Provenance& provenance,
                                           const diagnostics::SourceManager& sources) {
    std::vector<std::string> elements;
    for (const std::string& name : definitions_in(description)) {
        const auto found = provenance.definitions.find(name);
        if (found == provenance.definitions.end()) continue;
        const std::string text = with_place(found->second.text, found->second.origin, sources);
        if (std::ranges::find(elements, text) == elements.end()) elements.push_back(text);
    }
    return elements;
}

std::string describe_with_place(process::Event event, const Alphabet& alphabet, const csp_emit::Provenance& provenance,
                                const diagnostics::SourceManager& sources) {
    const CycleRole role = alphabet.cycle_role(event);
    const Interface& interface = alphabet.interface();
    std::string name;
    if (role.kind == CycleRole::Kind::write) name = interface.outputs[role.index].name;
    if (role.kind == CycleRole::Kind::read) name = interface.inputs[role.index].name;
    const auto found = provenance.events.find(interface.component + "::" + name);
    const std::string text = alphabet.describe_event(event);
    return found == provenance.events.end() ? text : with_place(text, found->second.origin, sources);
}

}  // namespace robochart::conformance
