// SPDX-License-Identifier: Apache-2.0
// Projects NF_c(M) to what is visible in a log: unobserved events are hidden, and a log that starts late may start in
// any cycle.
#pragma once

#include <vector>

#include "conformance/model/cyclic_model.hpp"

namespace robochart::conformance {

/// The kinds of events that a log records. Events of other kinds may have happened without a record, with any values.
struct Observation {
    std::vector<bool> inputs;   ///< by register
    std::vector<bool> outputs;  ///< by output
    friend bool operator==(const Observation&, const Observation&) = default;
};

/// Returns all reachable packed states of NF_c(M) in which a cycle may begin, or none if NF_c(M) has more than `most`
/// states. Throws process::Interrupted at a limit.
[[nodiscard]] std::vector<std::vector<lts::Word>> cycle_starts(CycleSystem&, const refine::Limits&, std::size_t most);

class ObservedSystem final : public lts::TransitionSystem {
public:
    /// `starts` contains the possible initial states. If it is empty, the only initial state is that of NF_c(M).
    ObservedSystem(CycleSystem&, const Alphabet&, Observation, std::vector<std::vector<lts::Word>> starts);

    [[nodiscard]] std::size_t width() const override { return normal_form_->width(); }
    void initial(std::span<lts::Word> state) override;
    void successors(lts::StateView state, lts::SuccessorSink& sink) override;
    [[nodiscard]] const process::EventTable& events() const override { return alphabet_->events(); }
    [[nodiscard]] std::string describe(lts::StateView state) const override;
    [[nodiscard]] bool is_hidden(process::Event event);
    /// Returns whether no hidden step is possible.
    [[nodiscard]] bool is_stable(lts::StateView state);
    /// Returns the description of the model's state (CycleSystem::describe_model); "" if the state is not known yet.
    [[nodiscard]] std::string describe_model(lts::StateView state) const;

private:
    class Sink;

    CycleSystem* normal_form_;
    const Alphabet* alphabet_;
    Observation observation_;
    std::vector<std::vector<lts::Word>> starts_;
    std::vector<signed char> hidden_;  ///< by event: -1 if not known yet
};

}  // namespace robochart::conformance
