// SPDX-License-Identifier: Apache-2.0
// Lists the component's boundary for the exploration interface and logs: the registers and outputs of a cycle, with
// their names in the CSP alphabet (semantics 3.2 "visible alphabet per level"). Private to this component.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cpp_emit/plan/component.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

struct Register {
    std::string name;    ///< "seeRobot.in", "set_EXT_reached"
    std::string member;  ///< member of Inputs
    std::optional<ir::TypeId> type;
};

struct Output {
    std::string name;  ///< "MoveClockwiseCall", "out.out", "set_reached"
    std::string method;
    std::vector<ir::TypeId> types;
};

/// Lists received events, then externally written variables.
[[nodiscard]] std::vector<Register> exploration_registers(const Component&);
/// Lists called operations, then sent events, then written variables.
[[nodiscard]] std::vector<Output> exploration_outputs(const Component&);
/// Returns the types of inputs and outputs that consist only of numbers, or are sequences of numbers, without
/// duplicates. The types of registers come first, then those of outputs, both in order. These are the types of
/// rc_tracking (runtime/explore_abi.h).
[[nodiscard]] std::vector<ir::TypeId> tracked_types(const ir::System&, const Component&);

}  // namespace robochart::cpp_emit
