// SPDX-License-Identifier: Apache-2.0
// Checks the types of an emitted script and reports errors in terms of the CSP blocks that the user wrote.
#pragma once

#include "base/diagnostics/diagnostic.hpp"
#include "csp_emit/base/emission.hpp"

namespace robochart::csp_emit {

/// Checks the script by FDR's rules (cspm::check_types). For a name that is not in scope, the finding suggests names of
/// the script. An error in an assertion generated for a claim of the model (`system`) is reported at the place of the
/// claim.
void check_script(const Emission&, const ir::System& system, diagnostics::Diagnostics&);

}  // namespace robochart::csp_emit
