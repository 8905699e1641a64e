// SPDX-License-Identifier: Apache-2.0
// Represents a RoboSim component over the events of L(G). This is the specification of its code (docs/conformance.md,
// "RoboSim").
//
// The component M of docs/robosim.md already runs in cycles, so there is no normal form. This system
//   * hides endexec and terminate, as a module does, and gives τ and ✓ priority over tock again,
//   * reads the registers in the order of the interface ("One order of reading"),
//   * maps `registerRead.i_e.false.v` to absent for every v, so that M chooses the value of an empty register,
//   * maps absent to the last value of a variable, because M then reads this value again,
//   * accepts a write before it reports the write, so that M, and not the environment, makes the choice between two
//     outputs. A controller treats the writes of its machines in the same way.
#pragma once

#include "conformance/code/interface.hpp"
#include "conformance/model/cycle_system.hpp"
#include "conformance/model/model_graph.hpp"

namespace robochart::conformance {

/// What the process does after ✓.
enum class AfterEnd {
    stop,  ///< nothing
    idle,  ///< time passes, so that only a timelock is a deadlock
};

class RegisterSystem final : public CycleSystem {
public:
    /// The model and the alphabet must outlive the system.
    RegisterSystem(ModelGraph&, const Alphabet&, std::uint32_t cycle_length, AfterEnd);

    [[nodiscard]] std::size_t width() const override;
    void initial(std::span<lts::Word> state) override;
    void successors(lts::StateView, lts::SuccessorSink&) override;
    [[nodiscard]] const process::EventTable& events() const override { return alphabet_->events(); }
    [[nodiscard]] std::string describe(lts::StateView) const override;
    void set_budget(diagnostics::Pollable& budget) override { model_->set_budget(budget); }
    [[nodiscard]] bool begins_cycle(lts::StateView) const override;
    [[nodiscard]] std::string describe_model(lts::StateView) const override;

private:
    struct Move;
    void add_edge(Move&, const ModelEdge&) const;
    void add_read(Move&, const ModelEdge&) const;
    void add_write(Move&, const ModelEdge&) const;

    ModelGraph* model_;
    const Alphabet* alphabet_;
    std::uint32_t cycle_length_;
    AfterEnd after_;
    std::size_t inputs_;
    std::vector<std::uint32_t> kept_by_output_;  ///< by output: the input with the same register, or no_input
};

}  // namespace robochart::conformance
