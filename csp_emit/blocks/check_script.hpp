// The types of an emitted script, with what is wrong said in terms of the CSP blocks that the user wrote.
#pragma once

#include "csp_emit/base/emission.hpp"
#include "diagnostics/diagnostic.hpp"

namespace robochart::csp_emit {

/// Checks the script by FDR's rules (cspm::check_types). A name that is not in scope is reported with what the script
/// calls so; what is wrong with an assertion made for a claim of the model (`system`), with the place of the claim.
void check_script(const Emission&, const ir::System& system, diagnostics::Diagnostics&);

}  // namespace robochart::csp_emit
