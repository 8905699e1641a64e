// SPDX-License-Identifier: Apache-2.0
// Lists the headers that are delivered with generated code, below robochart/.
#pragma once

#include <vector>

#include "cpp_emit/plan/component.hpp"
#include "cpp_emit/plan/options.hpp"

namespace robochart::cpp_emit {

/// Returns all headers that generated code may include.
[[nodiscard]] std::vector<OutputFile> shipped_headers();
/// Returns those of these headers that the component needs.
[[nodiscard]] std::vector<OutputFile> value_headers(const Component&);

}  // namespace robochart::cpp_emit
