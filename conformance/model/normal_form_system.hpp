// SPDX-License-Identifier: Apache-2.0
// Implements NF_c(M) as a transition system: the model in parallel with the three simulation assumptions
// (docs/conformance.md). normal_form.hpp writes the same process in CSPM. Tests in tests/conformance check that both
// processes are equivalent.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "conformance/model/cycle_system.hpp"
#include "conformance/model/model_graph.hpp"

namespace robochart::conformance {

/// What happens after the successful termination of the model.
enum class AfterTermination {
    stop,  ///< ✓, as in the definition
    idle,  ///< tock forever, so that termination is not a deadlock (schedulability)
};

/// How often an output may be made in one cycle (docs/conformance.md, A2).
enum class Outputs {
    sequence,  ///< any number, in the order in which M makes them
    once,      ///< each at most once: a repeated output is the event `model.repeats`, after which nothing follows
};

/// What happens if M waits for an input that was not read, and the deadline of this input has expired, so that time
/// cannot pass.
enum class Deadlines {
    stop,  ///< no further step, as in M
    mark,  ///< the event `model.deadline`, after which nothing follows
    idle,  ///< tock forever, so that a missed deadline is not a deadlock
};

/// A variant of NF_c(M). With the first value of each member, it is NF_c(M) as defined. The other values are used to
/// find out why M cannot be run in cycles.
struct Frame {
    AfterTermination after = AfterTermination::stop;
    Outputs outputs = Outputs::sequence;
    Deadlines deadlines = Deadlines::stop;
    bool writes_hidden = false;  ///< hides the writes, so that an endless sequence of outputs is a divergence
    /// If true, a register may also stay unread: the event `unread` represents this. If the behaviour then depends on
    /// the reading of this register, the event `asks` is possible, and all other events are meaningless.
    bool unread = false;
};

/// Why a state of NF_c(M) has no transitions.
enum class Standstill {
    none,    ///< the state has transitions
    inputs,  ///< M waits, with an expired deadline, for inputs that were not read
    other,
    output_in_mid_cycle,  ///< M must make an output after the first tock of a cycle
    input_in_mid_cycle,   ///< M waits, after the first tock of a cycle, for an input with an expired deadline
    end_in_mid_cycle,     ///< M has terminated after the first tock of a cycle
    terminated,
};

class NormalFormSystem : public CycleSystem {
public:
    NormalFormSystem(ModelGraph& model, const Alphabet& alphabet, std::uint32_t cycle_length, Frame = {});

    [[nodiscard]] std::size_t width() const override;
    void initial(std::span<lts::Word> state) override;
    void successors(lts::StateView state, lts::SuccessorSink& sink) override;
    [[nodiscard]] const process::EventTable& events() const override { return alphabet_->events(); }
    [[nodiscard]] std::string describe(lts::StateView state) const override;
    void set_budget(diagnostics::Pollable& budget) override { model_->set_budget(budget); }
    [[nodiscard]] bool begins_cycle(lts::StateView state) const override;
    /// Returns why the state has no transitions, or `none` if it has some.
    [[nodiscard]] Standstill standstill_kind(lts::StateView state);
    /// Returns the state of M, or no value after its termination.
    [[nodiscard]] std::optional<ModelState> model_state_of(lts::StateView state) const;
    /// Return the events for a repeated output (Outputs::once) and a missed deadline (Deadlines::mark).
    [[nodiscard]] process::Event repeat_event() const { return repeats_; }
    [[nodiscard]] process::Event deadline_event() const { return deadline_; }
    /// Return the events of Frame::unread.
    [[nodiscard]] process::Event unread_event(std::uint32_t input) const { return unread_[input]; }
    [[nodiscard]] process::Event ask_event(std::uint32_t input) const { return asks_[input]; }
    [[nodiscard]] std::string describe_model(lts::StateView state) const override;

private:
    struct Move;
    void begin_cycle(std::span<lts::Word> state) const;
    void add_reads(Move&);
    void drop_inputs(std::span<lts::Word> state, lts::Word model);
    void model_moves(Move&);
    void model_step(Move&, const ModelEdge&);
    void add_input_step(Move&, const ModelEdge&);
    void store_output(Move&, const ModelEdge&);
    void pass_time(Move&, const ModelEdge&);
    void add_termination(Move&);
    void add_repeat(Move&);
    void add_missed_deadline(Move&);
    [[nodiscard]] bool awaits_input(lts::StateView state);
    [[nodiscard]] Standstill standstill_in_mid_cycle(lts::StateView state);

    ModelGraph* model_;
    const Alphabet* alphabet_;
    std::uint32_t cycle_length_;
    Frame frame_;
    process::Event repeats_;
    process::Event deadline_;
    std::vector<process::Event> unread_, asks_;
    std::size_t inputs_;
    std::size_t mask_words_;
};

}  // namespace robochart::conformance
