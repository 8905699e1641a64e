// SPDX-License-Identifier: Apache-2.0
// See structure_text.hpp.
#include "app/report/structure_text.hpp"

#include <fmt/format.h>

#include "counterexample/structure.hpp"

namespace robochart::app {
namespace {

void write(const process::Behaviour& part, std::size_t indent, const process::EventTable& events, std::string& out) {
    out += fmt::format("{:{}}{}", "", indent, runs::part_text(part));
    if (part.parts.empty()) out += "  " + runs::offers_text(part, events);
    out += '\n';
    for (const process::Behaviour& child : part.parts) write(child, indent + 2, events, out);
}

}  // namespace

std::string structure_text(const std::optional<process::Behaviour>& whole, const process::EventTable& events) {
    if (!whole) return "  the structure cannot be evaluated here\n";
    std::string out;
    write(*whole, 2, events, out);
    return out;
}

}  // namespace robochart::app
