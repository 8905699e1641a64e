// SPDX-License-Identifier: Apache-2.0
// Records files of rules in the record of a run.
#pragma once

#include "app/command/options.hpp"
#include "driver/rules/rule_claims.hpp"

namespace robochart::app {

/// Records the file and its constants.
void record_rules(const driver::LoadedRules&, const Options&);

}  // namespace robochart::app
