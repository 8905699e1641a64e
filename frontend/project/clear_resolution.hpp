// SPDX-License-Identifier: Apache-2.0
// Resets a tree to what the parser produced (private to the front end).
#pragma once

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// Clears every field that resolution and typing fill, so that both can run again after files have been replaced.
void reset(Model& model);
void reset(File& file);

}  // namespace robochart::frontend
