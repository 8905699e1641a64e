// NF_c(M) as a log shows it: what the log does not observe is hidden, and a log that starts late starts anywhere.
#pragma once

#include <vector>

#include "conformance/model/cyclic_model.hpp"

namespace robochart::conformance {

/// What a log shows. Kinds that are not observed may have happened or not, with any values.
struct Observation {
    std::vector<bool> inputs;   ///< of each register
    std::vector<bool> outputs;  ///< of each output
    friend bool operator==(const Observation&, const Observation&) = default;
};

/// Packed states of NF_c(M) in which a cycle may begin, over all that is reachable. Throws process::Interrupted at a
/// limit.
[[nodiscard]] std::vector<std::vector<lts::Word>> cycle_starts(NormalFormSystem&, const refine::Limits&);

class ObservedSystem final : public lts::TransitionSystem {
public:
    /// `starts`: where it may begin; empty: where NF_c(M) does.
    ObservedSystem(NormalFormSystem&, const Alphabet&, Observation, std::vector<std::vector<lts::Word>> starts);

    [[nodiscard]] std::size_t width() const override { return normal_form_->width(); }
    void initial(std::span<lts::Word> state) override;
    void successors(lts::StateView state, lts::SuccessorSink& sink) override;
    [[nodiscard]] const process::EventTable& events() const override { return alphabet_->events(); }
    [[nodiscard]] std::string describe(lts::StateView state) const override;
    [[nodiscard]] bool hidden(process::Event event);
    /// Can it do nothing on its own?
    [[nodiscard]] bool stable(lts::StateView state);
    /// "" where it is not known yet; see NormalFormSystem::describe_model.
    [[nodiscard]] std::string describe_model(lts::StateView state) const;

private:
    class Sink;

    NormalFormSystem* normal_form_;
    const Alphabet* alphabet_;
    Observation observation_;
    std::vector<std::vector<lts::Word>> starts_;
    std::vector<signed char> hidden_;  ///< of each event: -1 not known yet
};

}  // namespace robochart::conformance
