// Places of findings about components, and about what a model lacks.
#pragma once

#include "app/command/pipeline.hpp"

namespace robochart::app {

/// Where a component is declared.
[[nodiscard]] diagnostics::Span declared_at(const ir::System&, const ir::ComponentRef&);
/// The beginning of the first text of the model: the place of what is missing in the model as a whole.
[[nodiscard]] diagnostics::Span model_place(const Project&);

}  // namespace robochart::app
