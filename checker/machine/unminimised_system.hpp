// SPDX-License-Identifier: Apache-2.0
// Runs a compiled process whose components are not minimised. This system is used to display runs: minimisation merges
// states that differ only in the names of hidden events, so a run of minimised components may show a hidden step with a
// name that belongs to another state.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "checker/machine/supercombinator_system.hpp"

namespace robochart::machine {

/// Maps the states of a component to the states of its minimised form.
class StateMap {
public:
    /// Removes the events that `minimised` does not have, minimises the result, and maps the states of the
    /// component to those of the minimised result. Returns no value if this result is not `minimised`. Polls the
    /// budget.
    static std::optional<StateMap> make(const Component& component, const Component& minimised,
                                        diagnostics::Pollable& budget);
    /// Returns the state of the smaller component. `state` must be "off", or reachable without the removed
    /// events.
    [[nodiscard]] Local image(Local state) const { return state < images_.size() ? images_[state] : off_; }

private:
    StateMap(std::vector<Local> images, Local off) : images_(std::move(images)), off_(off) {}

    std::vector<Local> images_;
    Local off_;
};

/// A compiled process whose components have not been minimised.
class UnminimisedSystem final : public lts::FinerSystem {
public:
    /// `maps` contains, for each slot, the mapping from the component of `combined` to that of `minimised`.
    UnminimisedSystem(std::shared_ptr<const Supercombinator> combined, std::shared_ptr<const Supercombinator> minimised,
                      std::vector<StateMap> maps, const process::TermStore& terms)
        : system_(combined, terms),
          combined_(std::move(combined)),
          minimised_(std::move(minimised)),
          maps_(std::move(maps)) {}

    [[nodiscard]] std::size_t width() const override { return system_.width(); }
    void initial(std::span<lts::Word> state) override { system_.initial(state); }
    void successors(lts::StateView state, lts::SuccessorSink& sink) override { system_.successors(state, sink); }
    [[nodiscard]] const process::EventTable& events() const override { return system_.events(); }
    [[nodiscard]] std::string describe(lts::StateView state) const override { return system_.describe(state); }
    void set_budget(diagnostics::Pollable& budget) override { system_.set_budget(budget); }
    void minimised_state(lts::StateView state, std::span<lts::Word> minimised) const override;
    [[nodiscard]] std::size_t minimised_width() const override { return minimised_->words; }

private:
    SupercombinatorSystem system_;
    std::shared_ptr<const Supercombinator> combined_;
    std::shared_ptr<const Supercombinator> minimised_;
    std::vector<StateMap> maps_;
};

}  // namespace robochart::machine
