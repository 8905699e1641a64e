// SPDX-License-Identifier: Apache-2.0
#include "frontend/diagrams/stored/rules.hpp"

#include <array>

namespace robochart::diagrams::rules {

using diagnostics::Rule;
using diagnostics::Severity;

const Rule unreadable_diagrams{"RC-D01", Severity::note, "the diagrams of {} are not used: {}",
                               "RoboTool stores the diagrams that people draw in a file representations.aird in the "
                               "folder of the model. The file must be XML in UTF-8 without a document type, and have "
                               "at most 64 MiB. If it cannot be read, the diagrams are laid out automatically."};
const Rule other_diagram{"RC-D02", Severity::note,
                         "the diagram of {0} in {1} is not used: only {3} of its {2} elements are in the model",
                         "A diagram from RoboTool is used if at least 95 % of its elements are in the model, with the "
                         "same names or between the same nodes. This diagram belongs to another version of the model. "
                         "To update the diagram, open and save the model in RoboTool."};
const Rule incomplete_diagram{"RC-D03", Severity::note, "{} is drawn as in {}, which does not have {}",
                              "The component is drawn with the layout from RoboTool. Elements that the stored diagram "
                              "does not have are laid out automatically: nodes and parts are placed below the others."};

std::span<const Rule* const> rule_list() {
    static constexpr std::array<const Rule*, 3> rules{&unreadable_diagrams, &other_diagram, &incomplete_diagram};
    return rules;
}

}  // namespace robochart::diagrams::rules
