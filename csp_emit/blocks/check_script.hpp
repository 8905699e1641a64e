// SPDX-License-Identifier: Apache-2.0
// Checks the types of an emitted script and reports errors in terms of the CSP blocks that the user wrote.
#pragma once

#include "base/diagnostics/diagnostic.hpp"
#include "csp_emit/base/emission.hpp"

namespace robochart::csp_emit {

/// Checks the script by FDR's rules (cspm::check_types). Suggests names of the script for a name that is not in
/// scope. If an assertion was generated for a claim of the model (`system`), its errors are reported at the
/// claim.
void check_script(const Emission&, const ir::System& system, diagnostics::Diagnostics&);

}  // namespace robochart::csp_emit
