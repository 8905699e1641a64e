// The static rules, applied: trees to checked models and properties.
#pragma once

#include <memory>
#include <optional>

#include "checker/prism/checks/checked.hpp"
#include "diagnostics/diagnostic.hpp"

namespace robochart::prism {

/// Nothing, with findings, where a rule is broken.
[[nodiscard]] std::optional<CheckedModel> check_model(const ModelFile& file, diagnostics::Diagnostics& diagnostics);

/// Properties over a model. What is in order is there, whatever the findings.
[[nodiscard]] CheckedProperties check_properties(const CheckedModel& model, const PropertyFile& file,
                                                 diagnostics::Diagnostics& diagnostics);

}  // namespace robochart::prism
