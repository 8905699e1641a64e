// Which numbers a component only passes on; see boundary.hpp.
#pragma once

#include <vector>

#include "conformance/boundary.hpp"

namespace robochart::conformance {

/// Of these machines and operations together.
[[nodiscard]] PassedOn passed_on(const ir::System&, const std::vector<ir::MachineId>&);

}  // namespace robochart::conformance
