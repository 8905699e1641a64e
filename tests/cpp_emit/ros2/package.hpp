// SPDX-License-Identifier: Apache-2.0
// Builds a generated ROS 2 package with tests/cpp_emit/ros2_stub, and runs it with a program.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "cpp_emit/ros2/mapping.hpp"
#include "tests/cpp_emit/harness.hpp"

namespace robochart::cpp_emit::ros2 {

/// A generated package with its findings, one per line: "RC-R04 3:15 'x' is not a valid name of ...", or "RC-R10 ..."
/// for the model.
struct Planned {
    Emission emission;
    std::string findings;
};

/// Generates the package of a component with the text of a mapping, or without a mapping if the text is "".
[[nodiscard]] Planned emit_package(const ir::System&, const std::string& component, const std::string& mapping,
                                   const ir::InstantiationOptions& = {}, const Options& = {});

class Package : public ::testing::Test {
protected:
    /// Generates the package. Findings other than notes fail the test.
    void emit(const ir::System&, const std::string& component, const std::string& mapping = "",
              const ir::InstantiationOptions& = {}, const Options& = {});
    /// Builds the package with CMake, with all warnings as errors.
    void build(const std::string& options = "") const;
    /// Compiles the node and a program as one source, and runs it. The program returns 0, or the line of the first
    /// EXPECT that fails.
    void drive(const std::string& node_header, const std::string& text, bool traced = false) const;

    void write(const std::string& path, const std::string& text) const;
    /// Returns the folder of the stub.
    [[nodiscard]] static std::string stub();

    testing::Folder folder_;
};

}  // namespace robochart::cpp_emit::ros2
