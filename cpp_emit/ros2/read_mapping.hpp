// From the text of a mapping to the mapping.
#pragma once

#include "cpp_emit/ros2/mapping.hpp"
#include "diagnostics/diagnostic.hpp"
#include "diagnostics/source.hpp"

namespace robochart::cpp_emit::ros2 {

/// Reads a mapping and checks everything that needs no model: every name in it is a name of ROS. Wrong text becomes
/// diagnostics.
[[nodiscard]] Mapping read_mapping(const diagnostics::SourceManager&, diagnostics::SourceId, diagnostics::Diagnostics&);

}  // namespace robochart::cpp_emit::ros2
