// SPDX-License-Identifier: Apache-2.0
// A generated ROS 2 package, built with tests/cpp_emit/ros2_stub and driven by a program.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "cpp_emit/ros2/mapping.hpp"
#include "tests/cpp_emit/harness.hpp"

namespace robochart::cpp_emit::ros2 {

/// The findings, one per line: "RC-R04 3:15 'x' is not a valid name of ...", "RC-R10 ..." for the model.
struct Planned {
    Emission emission;
    std::string findings;
};

/// Generates the package of a component with the text of a mapping; "" means no mapping.
[[nodiscard]] Planned emit_package(const ir::System&, const std::string& component, const std::string& mapping,
                                   const ir::InstantiationOptions& = {}, const Options& = {});

class Package : public ::testing::Test {
protected:
    /// Generates the package; findings other than notes fail the test.
    void emit(const ir::System&, const std::string& component, const std::string& mapping = "",
              const ir::InstantiationOptions& = {}, const Options& = {});
    /// Builds the package with CMake, with all warnings as errors.
    void build(const std::string& options = "") const;
    /// Compiles the node with a program as one source, and runs it. The program returns 0, or the line of the first
    /// EXPECT that fails.
    void drive(const std::string& node_header, const std::string& text, bool traced = false) const;

    void write(const std::string& path, const std::string& text) const;
    /// The folder of the stub.
    [[nodiscard]] static std::string stub();

    testing::Folder folder_;
};

}  // namespace robochart::cpp_emit::ros2
