// SPDX-License-Identifier: Apache-2.0
// Constructs that the C++ generator rejects by name. A rejected component gets no code rather than wrong code.
#pragma once

#include <span>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::cpp_emit::rules {

extern const diagnostics::Rule no_component;         // RC-G01
extern const diagnostics::Rule no_body;              // RC-G03
extern const diagnostics::Rule unsupported_type;     // RC-G04
extern const diagnostics::Rule unsupported_expr;     // RC-G05
extern const diagnostics::Rule unsupported_node;     // RC-G07
extern const diagnostics::Rule unsupported_trigger;  // RC-G08
extern const diagnostics::Rule recursion;            // RC-G10
extern const diagnostics::Rule unconnected;          // RC-G11
extern const diagnostics::Rule crossing;             // RC-G12
extern const diagnostics::Rule too_large;            // RC-G13
extern const diagnostics::Rule not_explored;         // RC-G15
extern const diagnostics::Rule no_project;           // RC-G14

[[nodiscard]] std::span<const diagnostics::Rule* const> all();

}  // namespace robochart::cpp_emit::rules
