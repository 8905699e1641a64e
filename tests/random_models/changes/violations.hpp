// Well-formed models with one rule broken on purpose: what is found must be that rule and nothing else.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/random_models/models/project.hpp"
#include "tests/random_models/models/random.hpp"

namespace robochart::random_models {

/// Where the text of a violation goes: to the end of a component of this kind, chosen at random.
enum class Site { file, machine, operation, platform, controller, module, state };

/// One way to break a rule. In the texts `$state`, `$initial`, `$final`, `$junction` stand for such a node of the
/// component, `$inner` for a state inside one of its composite states, `$parameter` for a parameter of the operation,
/// `$self` for the component's name, `$part` for the name by which a controller knows one of its machines.
struct Violation {
    std::string_view code;  ///< of the rule
    Site site;
    std::string_view member;     ///< put at the end of the component
    std::string_view top = {};   ///< put at the end of the file with the component
    std::string_view part = {};  ///< put at the end of the machine `$part`
};

/// All ways, in a fixed order.
[[nodiscard]] const std::vector<Violation>& violations();

/// The project with the rule broken once; nothing if it has no place for that.
[[nodiscard]] std::optional<Project> violate(const Project& project, const Violation& violation, Random& random);

}  // namespace robochart::random_models
