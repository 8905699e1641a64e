// SPDX-License-Identifier: Apache-2.0
// Applies the static rules: converts trees to checked models and properties.
#pragma once

#include <memory>
#include <optional>

#include "base/diagnostics/diagnostic.hpp"
#include "prism/checks/checked.hpp"

namespace robochart::prism {

/// Checks a model. If a rule is violated, reports findings and returns no value.
[[nodiscard]] std::optional<CheckedModel> check_model(const ModelFile& file, diagnostics::Diagnostics& diagnostics);

/// Checks properties over a model. The result contains only the properties without errors.
[[nodiscard]] CheckedProperties check_properties(const CheckedModel& model, const PropertyFile& file,
                                                 diagnostics::Diagnostics& diagnostics);

}  // namespace robochart::prism
