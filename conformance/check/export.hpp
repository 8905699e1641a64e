// L(G) for other tools, so that they can repeat what was checked here (docs/conformance.md, "For other tools").
#pragma once

#include "checker/cspm/syntax/syntax.hpp"
#include "conformance/check/result.hpp"
#include "conformance/code/code_system.hpp"
#include "csp_emit/emit.hpp"

namespace robochart::conformance {

/// What a check of one controller has at hand.
struct CheckedCode {
    const csp_emit::Emission& script;
    const cspm::ExprPtr& process;  ///< M
    const rc_interface& code;
    const Alphabet& alphabet;
};

/// Explores the code and writes it in the format asked for into `result`; or why that cannot be had.
void export_code(Result& result, const CheckedCode&, const Options&);

}  // namespace robochart::conformance
