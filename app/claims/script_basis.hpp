// SPDX-License-Identifier: Apache-2.0
// What the verdict on an assertion of a script rests on and no search for a violation tells.
#pragma once

#include "checker/cspm/session.hpp"
#include "driver/results/basis.hpp"
#include "driver/settings/search_context.hpp"

namespace robochart::app {

/// In the failures model what a process refuses while it goes on internally is not compared: whether one that an
/// assertion holds of can do so for ever. Nothing is said of processes with too many states, or at a limit.
[[nodiscard]] driver::Basis basis_of(cspm::Session&, const cspm::Decl& assertion, const cspm::AssertionResult&,
                                     const driver::SearchContext&);

}  // namespace robochart::app
