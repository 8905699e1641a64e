// SPDX-License-Identifier: Apache-2.0
// The limits of one check.
#pragma once

#include <string>

#include "app/command/options.hpp"
#include "checker/refine/search/limits.hpp"

namespace robochart::app {

/// The limits of one check: those of the run and its own. Progress is reported as the options require, under the name
/// `subject`.
[[nodiscard]] refine::Limits limits_of_check(const Options&, const std::string& subject = "");

}  // namespace robochart::app
