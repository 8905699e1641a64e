// The component's boundary as the exploration interface and logs see it: registers read in a cycle, outputs made in it,
// under their names in the CSP alphabet (semantics 3.2 "visible alphabet per level"). Private to this component.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cpp_emit/plan/component.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

struct Register {
    std::string name;    ///< "seeRobot.in", "set_EXT_reached"
    std::string member;  ///< of Inputs
    std::optional<ir::TypeId> type;
};

struct Output {
    std::string name;  ///< "MoveClockwiseCall", "out.out", "set_reached"
    std::string method;
    std::vector<ir::TypeId> types;
};

/// Events received, then variables written from outside.
[[nodiscard]] std::vector<Register> registers(const Component&);
/// Operations called, then events sent, then variables written.
[[nodiscard]] std::vector<Output> outputs(const Component&);

}  // namespace robochart::cpp_emit
