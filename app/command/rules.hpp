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
extern const diagnostics::Rule left_out;      ///< an assertion file with errors, where only the model counts
}  // namespace rules

/// Every rule of every component, by component, then in table order.
[[nodiscard]] std::vector<const diagnostics::Rule*> all_rules();
/// The codes that a word may mean: itself, or those that are the same but for case, hyphens and what stands in front of
/// the last hyphen: `w17` and `RCW17` are RC-W17, `P01` is CSPM-P01, PRISM-P01, RC-P01 and SLEEC-P01. In order, none
/// twice.
[[nodiscard]] std::vector<std::string> codes_meant(std::string_view word);
/// The rows of a code (a published rule may have several, for different circumstances); ignores case.
[[nodiscard]] std::vector<const diagnostics::Rule*> find_rules(std::string_view code);

}  // namespace robochart::app
