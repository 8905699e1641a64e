// A model whose bounds count some choices only, with the count as a part of its states: each state once for every count
// up to a bound. Then questions within the bound are questions without one.
#pragma once

#include "checker/markov/model/model.hpp"
#include "diagnostics/budget.hpp"

namespace robochart::markov {

/// State s at count c is c * states + s; the last state, beyond all counts, loops.
struct Layers {
    Model model;
    std::size_t states = 0;  ///< of a layer
    std::uint64_t last = 0;  ///< the greatest count
    [[nodiscard]] State at(State state, std::uint64_t count) const {
        return static_cast<State>(count * states + state);
    }
    [[nodiscard]] State beyond() const { return static_cast<State>((last + 1) * states); }
};

/// Counts from 0 to `last`. A counted choice at the last count leads beyond, or with `stays` back into the last layer,
/// in which then so many or more have been counted. Throws LimitReached where there are too many states.
[[nodiscard]] Layers layers(const Model& model, std::uint64_t last, bool stays, diagnostics::Budget* budget);

/// Rewards of the model, in every layer; beyond there is none.
[[nodiscard]] Rewards in_layers(const Layers& layers, const Rewards& rewards);

}  // namespace robochart::markov
