// Whether the model leaves open which of several values it puts out: then few values do not stand for all
// (docs/conformance.md, "Few values for all").
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "checker/lts/transition_system.hpp"
#include "checker/refine/search/limits.hpp"
#include "conformance/code/interface.hpp"

namespace robochart::conformance {

/// Two outputs of which the model may make either after one and the same trace.
struct OpenChoice {
    std::string one, other;
};

/// The first trace of the normal form after which two writes are possible that differ in represented arguments only.
/// `represented`: for each output, which of its arguments are. Nothing: no trace. Throws diagnostics::LimitReached.
[[nodiscard]] std::optional<OpenChoice> open_choice(lts::TransitionSystem& normal_form, const Alphabet&,
                                                    const std::vector<std::vector<bool>>& represented,
                                                    const refine::Limits&);

}  // namespace robochart::conformance
