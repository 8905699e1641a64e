// SPDX-License-Identifier: Apache-2.0
// Lists all headers of cpp_emit/runtime for the conformance check, and the headers that the values of a component need.
#include "cpp_emit/files/shipped_headers.hpp"

#include "cpp_emit/files/files.hpp"

namespace robochart::cpp_emit {

std::vector<OutputFile> shipped_headers() {
    return {{"robochart/composed.hpp", composed_header()}, {"robochart/deployed.hpp", deployed_header()},
            {"robochart/drive_abi.h", drive_header()},     {"robochart/eigen.hpp", eigen_header()},
            {"robochart/explore.hpp", explore_helpers()},  {"robochart/explore_values.hpp", explore_values()},
            {"robochart/explore_abi.h", explore_header()}, {"robochart/finite.hpp", finite_header()},
            {"robochart/layout.hpp", layout_helpers()},    {"robochart/matrix.hpp", matrix_header()},
            {"robochart/probes.hpp", probes_header()},     {"robochart/runtime.hpp", runtime_header()},
            {"robochart/text.hpp", text_header()},         {"robochart/timer.hpp", timer_header()},
            {"robochart/toolkit.hpp", toolkit_header()},   {"robochart/tracked.hpp", tracked_header()},
            {"robochart/trace.hpp", trace_helpers()},      {"robochart/tracked_sequences.hpp", tracked_sequences()},
            {"robochart/views.hpp", views_header()}};
}

std::vector<OutputFile> value_headers(const Component& component) {
    std::vector<OutputFile> result = {{"robochart/composed.hpp", composed_header()}};
    if (component.matrices) result.push_back({"robochart/matrix.hpp", matrix_header()});
    if (component.matrices) result.push_back({"robochart/eigen.hpp", eigen_header()});
    if (component.toolkit) result.push_back({"robochart/toolkit.hpp", toolkit_header()});
    if (component.views) result.push_back({"robochart/views.hpp", views_header()});
    if (component.strings) result.push_back({"robochart/text.hpp", text_header()});
    return result;
}

}  // namespace robochart::cpp_emit
