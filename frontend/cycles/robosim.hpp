// SPDX-License-Identifier: Apache-2.0
// Translates RoboChart to RoboSim. Writes a RoboSim model that behaves like a RoboChart component that is run in
// cycles, and claims which state that it does (docs/robosim.md, "From RoboChart").
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

/// Writes the component with this full name. If RoboSim has no component with the same behaviour, reports why (RC-Y17)
/// and returns no value.
[[nodiscard]] std::optional<RoboSimFiles> write_robosim(const Model& model, const std::string& component,
                                                        std::uint32_t cycle, diagnostics::Diagnostics&);

}  // namespace robochart::frontend
