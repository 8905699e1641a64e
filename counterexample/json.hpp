// SPDX-License-Identifier: Apache-2.0
// Writes runs as JSON with the schema "robochart-verify/run/1" (docs/cli.md).
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "counterexample/run.hpp"

namespace robochart::runs {

[[nodiscard]] nlohmann::ordered_json run_json(const Run&);

}  // namespace robochart::runs
