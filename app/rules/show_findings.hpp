// SPDX-License-Identifier: Apache-2.0
// Prints findings about SLEEC rule files.
#pragma once

#include "app/command/options.hpp"
#include "driver/rules/rule_claims.hpp"

namespace robochart::app {

/// Prints the findings of a rule file to standard error.
void show_rule_findings(const driver::LoadedRules& loaded, const Options& options);

}  // namespace robochart::app
