// SPDX-License-Identifier: Apache-2.0
// Exports L(G) for other tools, so that they can repeat the check (docs/conformance.md, "For other tools").
#pragma once

#include "checker/cspm/syntax/syntax.hpp"
#include "conformance/check/result.hpp"
#include "conformance/code/code_system.hpp"
#include "csp_emit/emit.hpp"

namespace robochart::conformance {

/// The code of one controller and the data of its check.
struct CheckedCode {
    const csp_emit::Emission& script;
    const cspm::ExprPtr& process;  ///< M
    const rc_interface& code;
    const Alphabet& alphabet;
};

/// Explores the code and stores L(G) in the requested format in `result`. If the export is impossible, stores the
/// reason instead.
void export_code(Result& result, const CheckedCode&, const Options&);

}  // namespace robochart::conformance
