// SPDX-License-Identifier: Apache-2.0
// Cuts off the states of a model that are only reachable after one of its values has left its carrier.
#pragma once

#include <string>
#include <unordered_set>

#include "checker/lts/transition_system.hpp"

namespace robochart::conformance {

/// A transition system that hides errors of carriers. If a value leaves its carrier while the steps of a state are
/// evaluated, these steps are unknown. Here, such a state can only let time pass, forever. So a search for the steps
/// that the model can perform before time passes finds no problem in it.
class CarrierLimited final : public lts::TransitionSystem {
public:
    /// The system must outlive the object. `tock` is the event of the system that lets time pass.
    CarrierLimited(lts::TransitionSystem& model, lts::Event tock) : model_(model), tock_(tock) {}

    /// Returns true if the steps of this state turned out to be unknown when its successors were computed.
    [[nodiscard]] bool is_unknown(lts::StateView state) const { return unknown_.contains(key_of(state)); }

    [[nodiscard]] std::size_t width() const override { return model_.width(); }
    void initial(std::span<lts::Word> state) override { model_.initial(state); }
    /// If the evaluation fails because a value leaves its carrier, hides the error. Passes on all other errors.
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
