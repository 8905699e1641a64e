// SPDX-License-Identifier: Apache-2.0
// Parses mappings.
#pragma once

#include "base/diagnostics/diagnostic.hpp"
#include "base/diagnostics/source.hpp"
#include "cpp_emit/ros2/mapping.hpp"

namespace robochart::cpp_emit::ros2 {

/// Parses a mapping and performs all checks that do not need the model. For example, every name must be a valid ROS
/// name. Reports errors as diagnostics.
[[nodiscard]] Mapping read_mapping(const diagnostics::SourceManager&, diagnostics::SourceId, diagnostics::Diagnostics&);

}  // namespace robochart::cpp_emit::ros2
