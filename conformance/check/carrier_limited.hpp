// SPDX-License-Identifier: Apache-2.0
// Limits a model to the states that are reachable before one of its values leaves its carrier.
#pragma once

#include <string>
#include <unordered_set>

#include "checker/lts/transition_system.hpp"

namespace robochart::conformance {

/// A transition system that hides errors of carriers. If a value leaves its carrier during the evaluation of a state's
/// steps, these steps are unknown. In this system, such a state only lets time pass, forever. So a search for the steps
/// that the model can perform before time passes reports no problem in such a state.
class CarrierLimited final : public lts::TransitionSystem {
public:
    /// The system must outlive the object. `tock` is the system's event for the passing of time.
    CarrierLimited(lts::TransitionSystem& model, lts::Event tock) : model_(model), tock_(tock) {}

    /// Returns whether the steps of a state were unknown when the successors of the state were computed.
    [[nodiscard]] bool is_unknown(lts::StateView state) const { return unknown_.contains(key_of(state)); }

    [[nodiscard]] std::size_t width() const override { return model_.width(); }
    void initial(std::span<lts::Word> state) override { model_.initial(state); }
    /// Throws the evaluation error again, unless the cause of the error is a value that leaves its carrier.
    void successors(lts::StateView state, lts::SuccessorSink& sink) override;
    [[nodiscard]] const lts::EventTable& events() const override { return model_.events(); }
    void set_budget(diagnostics::Pollable& budget) override { model_.set_budget(budget); }
    [[nodiscard]] bool states_are_terms() const override { return model_.states_are_terms(); }
    [[nodiscard]] std::string describe(lts::StateView state) const override { return model_.describe(state); }

private:
    [[nodiscard]] static std::string key_of(lts::StateView state) {
        return {reinterpret_cast<const char*>(state.data()), state.size_bytes()};
    }

    lts::TransitionSystem& model_;
    lts::Event tock_;
    std::unordered_set<std::string> unknown_;  ///< never iterated
};

}  // namespace robochart::conformance
