// SPDX-License-Identifier: Apache-2.0
// Finds the basis of a verdict on an assertion of a script, which the search for a violation does not compute.
#pragma once

#include "checker/cspm/session.hpp"
#include "driver/results/basis.hpp"
#include "driver/settings/search_context.hpp"

namespace robochart::app {

/// Returns the basis of the verdict. The failures model does not compare the refusals of a process that diverges. So if
/// an assertion in this model holds and its process can diverge, the basis has an entry. The basis is empty if the
/// process has too many states, or if a limit is reached.
[[nodiscard]] driver::Basis basis_of(cspm::Session&, const cspm::Decl& assertion, const cspm::AssertionResult&,
                                     const driver::SearchContext&);

}  // namespace robochart::app
