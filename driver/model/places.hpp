// SPDX-License-Identifier: Apache-2.0
// Determines the places of findings about components, and about elements that are missing in a model.
#pragma once

#include "driver/model/pipeline.hpp"

namespace robochart::driver {

/// Returns the place where a component is declared.
[[nodiscard]] diagnostics::Span declared_at(const ir::System&, const ir::ComponentRef&);
/// Returns the beginning of the model's first text, which is the place of findings about the model as a whole.
[[nodiscard]] diagnostics::Span model_place(const Project&);

}  // namespace robochart::driver
