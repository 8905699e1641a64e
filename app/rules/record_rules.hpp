// SPDX-License-Identifier: Apache-2.0
// Adds rule files to the record of a run.
#pragma once

#include "app/command/options.hpp"
#include "driver/rules/rule_claims.hpp"

namespace robochart::app {

/// Adds the rule file and its constants to the record of the run.
void record_rules(const driver::LoadedRules&, const Options&);

}  // namespace robochart::app
