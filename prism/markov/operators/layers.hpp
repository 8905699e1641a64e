// SPDX-License-Identifier: Apache-2.0
// Unfolds a model in which step bounds count only some choices. The count becomes part of the states: each state occurs
// once for every count up to a bound. So properties with a bound become properties without a bound.
#pragma once

#include "base/diagnostics/budget.hpp"
#include "prism/markov/model/model.hpp"

namespace robochart::markov {

/// State s at count c has number c * states + s. The last state represents all greater counts and has a loop.
struct Layers {
    Model model;
    std::size_t states = 0;  ///< states in a layer
    std::uint64_t last = 0;  ///< the greatest count
    [[nodiscard]] State state_in_layer(State state, std::uint64_t count) const {
        return static_cast<State>(count * states + state);
    }
    [[nodiscard]] State first_state_beyond() const { return static_cast<State>((last + 1) * states); }
};

/// Unfolds the counts from 0 to `last`. A counted choice at the last count leads to the last state. With `stays`, it
/// leads back into the last layer instead, which then represents all counts from `last` on. Throws LimitReached if
/// there are too many states.
[[nodiscard]] Layers layers(const Model& model, std::uint64_t last, bool stays, diagnostics::Budget* budget);

/// Returns the rewards of the model in every layer. The last state has none.
[[nodiscard]] Rewards in_layers(const Layers& layers, const Rewards& rewards);

}  // namespace robochart::markov
