// Back to what the parser made (private to the front end).
#pragma once

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// Empties every field that resolution and typing fill, so that both can run again after files were replaced.
void reset(Model& model);
void reset(File& file);

}  // namespace robochart::frontend
