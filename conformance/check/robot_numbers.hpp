// SPDX-License-Identifier: Apache-2.0
// Tests code that conforms for all ideal numbers with the numbers of the robot: `double`, and integers of 64 bits
// (docs/conformance.md, "Numbers on the robot").
#pragma once

#include "base/diagnostics/pollable.hpp"
#include "base/diagnostics/source.hpp"
#include "conformance/check/result.hpp"
#include "conformance/code/deployed_code.hpp"
#include "conformance/code/interface.hpp"
#include "semantics/data/value_model.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// Code with tracked numbers that has been explored with the values of a value model, and the interface of the code.
struct ExploredValuesOfCode {
    const ir::System& system;  ///< the model
    const ir::ValueModel& values;
    const rc_interface& code;
    const std::vector<ir::TypeId>& types;  ///< the tracked types of the code
    const OutputTypes& output_types;
    const Interface& interface;  ///< the interface of the value model
    const diagnostics::SourceManager& sources;
};

/// Tests the code, and adds the test to a result for all values with the outcome `conforms`. If the code behaves
/// differently from the model and Options::rounding_allowed is false, changes the outcome to `rounds`.
void test_on_robot(Result& result, const ExploredValuesOfCode& explored, bool rounding_allowed,
                   diagnostics::Pollable& budget);

}  // namespace robochart::conformance
