// SPDX-License-Identifier: Apache-2.0
// Whether the model chooses which of several values it outputs; then few values do not represent all
// (docs/conformance.md, "Few values for all").
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "checker/lts/transition_system.hpp"
#include "checker/refine/search/limits.hpp"
#include "conformance/code/interface.hpp"

namespace robochart::conformance {

/// Two outputs, either of which the model may make after the same trace.
struct OpenChoice {
    std::string one, other;
};

/// The first trace of the normal form after which two writes are possible that differ only in represented arguments.
/// `represented`: for each output, which of its arguments are. No value if there is no such trace. Throws
/// diagnostics::LimitReached.
[[nodiscard]] std::optional<OpenChoice> open_choice(lts::TransitionSystem& normal_form, const Alphabet&,
                                                    const std::vector<std::vector<bool>>& represented,
                                                    const refine::Limits&);

}  // namespace robochart::conformance
