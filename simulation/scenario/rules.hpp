// SPDX-License-Identifier: Apache-2.0
// Mistakes in scenarios, and reasons for stopping a simulation.
#pragma once

#include <span>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::simulation::rules {

extern const diagnostics::Rule syntax;         ///< RC-M01
extern const diagnostics::Rule wrong_unit;     ///< RC-M02
extern const diagnostics::Rule out_of_range;   ///< RC-M03
extern const diagnostics::Rule missing;        ///< RC-M04
extern const diagnostics::Rule said_twice;     ///< RC-M05
extern const diagnostics::Rule unknown_part;   ///< RC-M06
extern const diagnostics::Rule unknown_name;   ///< RC-M07
extern const diagnostics::Rule wrong_type;     ///< RC-M08
extern const diagnostics::Rule no_space;       ///< RC-M09
extern const diagnostics::Rule no_controller;  ///< RC-M10
extern const diagnostics::Rule not_compiled;   ///< RC-M11
extern const diagnostics::Rule stopped;        ///< RC-M12
extern const diagnostics::Rule uneven_steps;   ///< RC-M13
extern const diagnostics::Rule not_fed;        ///< RC-M14
extern const diagnostics::Rule not_there;      ///< RC-M15
extern const diagnostics::Rule wrong_instant;  ///< RC-M16
extern const diagnostics::Rule not_in_chain;   ///< RC-M17
extern const diagnostics::Rule excluded;       ///< RC-M18
extern const diagnostics::Rule not_done;       ///< RC-M19

/// All rules, for `explain` and for tests.
[[nodiscard]] std::span<const diagnostics::Rule* const> all_rules();

}  // namespace robochart::simulation::rules
