// SPDX-License-Identifier: Apache-2.0
// Exports L(G) in formats of other tools. They can then repeat the check (docs/conformance.md, "For other tools").
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

/// Explores the code and stores L(G) in the requested format in `result`. If this is impossible, stores the
/// reason.
void export_code(Result& result, const CheckedCode&, const Options&);

}  // namespace robochart::conformance
