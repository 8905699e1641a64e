// SPDX-License-Identifier: Apache-2.0
// Determines whether the model can choose between several values for an output. In that case, two names may not
// represent all values (docs/conformance.md, "Few values for all").
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "checker/lts/transition_system.hpp"
#include "checker/refine/search/limits.hpp"
#include "conformance/code/interface.hpp"

namespace robochart::conformance {

/// Two outputs that are both possible after the same trace of the model.
struct OpenChoice {
    std::string one, other;
};

/// Explains why the explored values do not represent all values: the model chooses between values.
[[nodiscard]] std::string reason_of(const OpenChoice&);

/// Finds the first trace of the normal form after which two writes are possible that differ only in represented
/// arguments. For each output and each of its arguments, `represented` is true if a few values represent all values of
/// the argument. Returns no value if there is no such trace. Throws diagnostics::LimitReached.
[[nodiscard]] std::optional<OpenChoice> open_choice(lts::TransitionSystem& normal_form, const Alphabet&,
                                                    const std::vector<std::vector<bool>>& represented,
                                                    const refine::Limits&);

}  // namespace robochart::conformance
