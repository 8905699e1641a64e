// SPDX-License-Identifier: Apache-2.0
// Makes the certificate of code that conforms (docs/certificates.md, "Conformance of code"). Its specification is the
// normal form, and its implementation is the table of the explored code. robochart-replay runs the table again.
#pragma once

#include "checker/cspm/syntax/syntax.hpp"
#include "conformance/check/result.hpp"
#include "conformance/code/interface.hpp"
#include "cpp_emit/plan/options.hpp"
#include "cpp_emit/runtime/explore_abi.h"
#include "csp_emit/base/emission.hpp"

namespace robochart::conformance {

/// Code that conforms, and the data of its check.
struct ConformingCode {
    const csp_emit::Emission& script;
    const cspm::ExprPtr& process;  ///< M
    const Interface& interface;
    const rc_interface& code;
    const cpp_emit::Emission& emission;  ///< the sources from which the code was compiled
};

/// The largest number of rows of a table in a certificate.
inline constexpr std::uint64_t most_rows = 10'000'000;

/// Explores the code again and stores the certificate in `result`. If there is no certificate, stores the reason.
void certify_code(Result& result, const ConformingCode&, const Options&);

}  // namespace robochart::conformance
