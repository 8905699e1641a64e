// Rules of the command itself, and access to the rules of all components (for `explain` and the tests).
#pragma once

#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.hpp"

namespace robochart::app {

namespace rules {
extern const diagnostics::Rule bad_option;    ///< an option's value does not fit the model
extern const diagnostics::Rule no_component;  ///< nothing to generate code for
extern const diagnostics::Rule unwritable;    ///< a file could not be written
extern const diagnostics::Rule no_monitor;    ///< a component without monitor or test suite
}  // namespace rules

/// Every rule of every component, by component, then in table order.
[[nodiscard]] std::vector<const diagnostics::Rule*> all_rules();
/// The rows of a code (a published rule may have several, for different circumstances); ignores case.
[[nodiscard]] std::vector<const diagnostics::Rule*> find_rules(std::string_view code);

}  // namespace robochart::app
