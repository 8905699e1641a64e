// A package of ROS 2 as generated, built against tests/cpp_emit/ros2_stub and driven by a program.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "cpp_emit/ros2/mapping.hpp"
#include "tests/cpp_emit/harness.hpp"

namespace robochart::cpp_emit::ros2 {

/// What was found, one a line: "RC-R04 3:15 'x' is no name of ...", "RC-R10 ..." of the model.
struct Planned {
    Emission emission;
    std::string findings;
};

/// Emits the package of a component with the mapping, a text; "" for none.
[[nodiscard]] Planned emit_package(const ir::System&, const std::string& component, const std::string& mapping,
                                   const ir::InstantiationOptions& = {});

class Package : public ::testing::Test {
protected:
    /// Generates it; findings but notes fail the test.
    void emit(const ir::System&, const std::string& component, const std::string& mapping = "",
              const ir::InstantiationOptions& = {});
    /// CMake, with all warnings as errors.
    void build(const std::string& options = "") const;
    /// Builds it, and runs a program with its node: 0, or the line of the first EXPECT that fails.
    void drive(const std::string& node_header, const std::string& text, bool traced = false) const;

    void write(const std::string& path, const std::string& text) const;
    /// The folder of the stub.
    [[nodiscard]] static std::string stub();

    testing::Folder folder_;
};

}  // namespace robochart::cpp_emit::ros2
