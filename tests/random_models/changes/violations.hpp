// SPDX-License-Identifier: Apache-2.0
// Makes well-formed models in which one rule is violated on purpose. The front end must report this rule and no other.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/random_models/models/project.hpp"
#include "tests/random_models/models/random.hpp"

namespace robochart::random_models {

/// The kind of component that gets the text of a violation, which goes to the end of a random component of this kind.
enum class Site { file, machine, operation, platform, controller, module, state };

/// One way to violate a rule. In the texts, `$state`, `$initial`, `$final` and `$junction` stand for such a node of the
/// component, and `$inner` stands for a state inside one of its composite states. `$parameter` stands for a parameter
/// of the operation, `$self` for the component's name, and `$part` for a controller's name for one of its machines.
struct Violation {
    std::string_view code;  ///< of the rule
    Site site;
    std::string_view member;     ///< inserted at the end of the component
    std::string_view top = {};   ///< inserted at the end of the component's file
    std::string_view part = {};  ///< inserted at the end of the machine `$part`
};

/// Returns all violations, in a fixed order.
[[nodiscard]] const std::vector<Violation>& violations();

/// Returns the project with one violation of the rule, or nullopt if there is no suitable component.
[[nodiscard]] std::optional<Project> violate(const Project& project, const Violation& violation, Random& random);

}  // namespace robochart::random_models
