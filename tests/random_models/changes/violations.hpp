// SPDX-License-Identifier: Apache-2.0
// Well-formed models in which one rule is violated on purpose. The front end must report this rule and no other.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/random_models/models/project.hpp"
#include "tests/random_models/models/random.hpp"

namespace robochart::random_models {

/// The component that gets the text of a violation: a random one of this kind. The text goes to its end.
enum class Site { file, machine, operation, platform, controller, module, state };

/// One way to violate a rule. In the texts `$state`, `$initial`, `$final`, `$junction` stand for such a node of the
/// component, `$inner` for a state inside one of its composite states, `$parameter` for a parameter of the operation,
/// `$self` for the component's name, `$part` for a controller's name for one of its machines.
struct Violation {
    std::string_view code;  ///< of the rule
    Site site;
    std::string_view member;     ///< inserted at the end of the component
    std::string_view top = {};   ///< inserted at the end of the component's file
    std::string_view part = {};  ///< inserted at the end of the machine `$part`
};

/// All violations, in a fixed order.
[[nodiscard]] const std::vector<Violation>& violations();

/// The project with one violation of the rule; nullopt if there is no suitable component.
[[nodiscard]] std::optional<Project> violate(const Project& project, const Violation& violation, Random& random);

}  // namespace robochart::random_models
