// SPDX-License-Identifier: Apache-2.0
// Translates RoboChart to RoboSim. Writes a RoboSim model that behaves like a RoboChart component when the component is
// run in cycles. Also writes claims that state this (docs/robosim.md, "From RoboChart").
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/diagnostics/diagnostic.hpp"
#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// A component in RoboSim.
struct RoboSimFiles {
    std::string model;    ///< text of the `.rst` file
    std::string claims;   ///< text of the `.rsa` file
    std::string one_way;  ///< why the claims do not state that the component refines the model; "": they do
};

/// Writes the component with this full name. Returns no value and reports the cause (RC-Y17) if it has no equal in
/// RoboSim.
[[nodiscard]] std::optional<RoboSimFiles> write_robosim(const Model& model, const std::string& component,
                                                        std::uint32_t cycle, diagnostics::Diagnostics&);

}  // namespace robochart::frontend
