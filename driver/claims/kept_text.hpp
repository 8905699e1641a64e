// SPDX-License-Identifier: Apache-2.0
// Explains why data keep their carriers (docs/data.md, "Data that keep their carriers").
#pragma once

#include "base/diagnostics/source.hpp"
#include "driver/results/results.hpp"
#include "semantics/data/kept_data.hpp"

namespace robochart::driver {

/// Describes the data and the reason why these data keep their carriers. The reason contains the expression as written
/// in the model.
[[nodiscard]] KeptDataReport described(const diagnostics::SourceManager& sources, const ir::KeptData& data);

}  // namespace robochart::driver
