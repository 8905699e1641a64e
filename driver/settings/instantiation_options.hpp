// SPDX-License-Identifier: Apache-2.0
// Reads the constants and ranges of the settings.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "driver/settings/settings.hpp"
#include "semantics/instantiate/given_constants.hpp"
#include "semantics/ir/instantiation.hpp"

namespace robochart::driver {

/// Parses NAME=VALUE pairs. Malformed pairs and duplicate names are reported in `error`.
[[nodiscard]] ir::GivenConstants given_constants(const std::vector<std::string>&, std::string& error);

/// Returns the options for the instantiation. Malformed pairs are reported in `error`.
[[nodiscard]] ir::InstantiationOptions instantiation_options(const InstantiationSettings&, std::string& error);

/// Returns the values of a type as text: "0..4".
[[nodiscard]] std::string range_text(const std::vector<std::int64_t>& carrier);

}  // namespace robochart::driver
