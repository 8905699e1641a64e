// SPDX-License-Identifier: Apache-2.0
// Applies the static rules: converts trees to checked models and properties.
#pragma once

#include <memory>
#include <optional>

#include "base/diagnostics/diagnostic.hpp"
#include "prism/checks/checked.hpp"

namespace robochart::prism {

/// Returns no value, and reports findings, if a rule is violated.
[[nodiscard]] std::optional<CheckedModel> check_model(const ModelFile& file, diagnostics::Diagnostics& diagnostics);

/// Checks properties over a model. The result contains the properties without errors, even if there are findings.
[[nodiscard]] CheckedProperties check_properties(const CheckedModel& model, const PropertyFile& file,
                                                 diagnostics::Diagnostics& diagnostics);

}  // namespace robochart::prism
