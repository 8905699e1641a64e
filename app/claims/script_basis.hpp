// SPDX-License-Identifier: Apache-2.0
// Finds the basis of a verdict on an assertion of a script. The search for a violation does not find it.
#pragma once

#include "checker/cspm/session.hpp"
#include "driver/results/basis.hpp"
#include "driver/settings/search_context.hpp"

namespace robochart::app {

/// The failures model does not compare the refusals of a process that diverges. If an assertion in this model holds,
/// the basis has an entry if its process can diverge. It is empty if the process has too many states, or if a limit is
/// reached.
[[nodiscard]] driver::Basis basis_of(cspm::Session&, const cspm::Decl& assertion, const cspm::AssertionResult&,
                                     const driver::SearchContext&);

}  // namespace robochart::app
