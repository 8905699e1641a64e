// SPDX-License-Identifier: Apache-2.0
// Emits modules (semantics 3.9): controllers in parallel, with the robotic platform as their environment.
#pragma once

#include <set>
#include <string>

#include "csp_emit/compose/composition.hpp"

namespace robochart::csp_emit {

struct ModuleContext {
    const Project* project = nullptr;
    const ir::Module* module = nullptr;
    std::string path;
    NameManager names;
    const std::set<std::string>* given = nullptr;  ///< constants that CSP blocks define; null if none
};

[[nodiscard]] ComponentEmission emit_module(const ModuleContext&, Emitted&);

}  // namespace robochart::csp_emit
