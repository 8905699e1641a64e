// NF_c(M) as a transition system: the model in parallel with the three simulation assumptions (docs/conformance.md).
// The same process as normal_form.hpp writes in CSPM; tests/conformance shows that the two are equivalent.
#pragma once

#include <cstdint>
#include <string>

#include "checker/lts/transition_system.hpp"
#include "conformance/model_graph.hpp"

namespace robochart::conformance {

/// What follows successful termination of the model.
enum class AfterTermination {
    stop,  ///< ✓, as in the definition
    idle,  ///< tock for ever: termination is then no deadlock (schedulability)
};

class NormalFormSystem : public lts::TransitionSystem {
public:
    NormalFormSystem(ModelGraph& model, const Alphabet& alphabet, std::uint32_t cycle_length, AfterTermination);

    [[nodiscard]] std::size_t width() const override;
    void initial(std::span<lts::Word> state) override;
    void successors(lts::StateView state, lts::SuccessorSink& sink) override;
    [[nodiscard]] const process::EventTable& events() const override { return alphabet_->events(); }
    [[nodiscard]] std::string describe(lts::StateView state) const override;
    void watch(const std::function<void()>& poll) override { model_->watch(poll); }
    /// Whether a cycle may begin in the state: nothing is read or written yet.
    [[nodiscard]] bool begins_cycle(lts::StateView state) const;
    /// The states of M behind it, as M tells them; "" after termination.
    [[nodiscard]] std::string describe_model(lts::StateView state) const;

private:
    struct Move;
    void begin_cycle(std::span<lts::Word> state) const;
    void read(Move&);
    void model_moves(Move&);
    void model_step(Move&, const ModelEdge&);
    void input(Move&, const ModelEdge&);
    void output(Move&, const ModelEdge&);
    void pass_time(Move&, const ModelEdge&);
    void terminate(Move&);
    [[nodiscard]] std::string obstacle(lts::StateView state) const;

    ModelGraph* model_;
    const Alphabet* alphabet_;
    std::uint32_t cycle_length_;
    AfterTermination after_;
    std::size_t inputs_;
    std::size_t mask_words_;
};

}  // namespace robochart::conformance
