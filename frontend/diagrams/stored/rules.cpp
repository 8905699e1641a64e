// SPDX-License-Identifier: Apache-2.0
#include "frontend/diagrams/stored/rules.hpp"

#include <array>

namespace robochart::diagrams::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule unreadable_diagrams{
    "RC-D01", Severity::note, "the diagrams of {} are not used: {}",
    "RoboTool keeps the diagrams that people draw in a file representations.aird beside the model. It is XML in UTF-8 "
    "without a document type, of at most 64 MiB. Where it cannot be read, diagrams are laid out as without it."};
const Rule other_diagram{
    "RC-D02", Severity::note, "the diagram of {} in {} is not used: of its {} elements {} are in the model",
    "A diagram that RoboTool keeps is used where at least 95 % of its elements are in the model, with the names, or "
    "between the nodes, that they have in the diagram. This one is of another state of the model. RoboTool brings it "
    "up "
    "to date where the model is opened and saved in it."};
const Rule incomplete_diagram{
    "RC-D03", Severity::note, "{} is drawn as in {}, which does not have {}",
    "The component is drawn as a person has in RoboTool. What is not in that diagram has been laid out anew: nodes and "
    "parts stand below the others."};

std::span<const Rule* const> rule_list() {
    static constexpr std::array<const Rule*, 3> rules{&unreadable_diagrams, &other_diagram, &incomplete_diagram};
    return rules;
}

}  // namespace robochart::diagrams::rules
