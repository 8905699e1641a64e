// A compiled process behind the narrow waist.
#pragma once

#include <memory>

#include "checker/lts/transition_system.hpp"
#include "checker/machine/supercombinator.hpp"

namespace robochart::machine {

/// States are the components' states, packed. Successors need no memory of their own once the buffers have grown.
class SupercombinatorSystem final : public lts::TransitionSystem {
public:
    /// `terms` are those the components' meanings belong to.
    SupercombinatorSystem(std::shared_ptr<const Supercombinator> combined, const process::TermStore& terms);

    [[nodiscard]] std::size_t width() const override { return combined_->words; }
    void initial(std::span<lts::Word> state) override;
    void successors(lts::StateView state, lts::SuccessorSink& sink) override;
    [[nodiscard]] std::unique_ptr<lts::TransitionSystem> another() const override {
        return std::make_unique<SupercombinatorSystem>(combined_, terms_);
    }
    [[nodiscard]] const process::EventTable& events() const override { return terms_.events(); }
    [[nodiscard]] std::string describe(lts::StateView state) const override;

private:
    struct Move {
        std::uint32_t event;  ///< place in the region's alphabet
        Event name;
        Event revealed;
        std::uint32_t first_change, end_change;
    };
    /// What a region inside can do in the present state; ordered by event.
    struct Moves {
        std::vector<Move> list;
        std::vector<Assignment> changes;
    };
    class Firing;

    void pass_successors(lts::StateView state, lts::SuccessorSink& sink);
    void unpack(lts::StateView state);
    void fire(std::size_t region, lts::StateView state, lts::SuccessorSink* sink);
    void prefer(const Region& region, Moves& moves) const;

    std::shared_ptr<const Supercombinator> combined_;
    const process::TermStore& terms_;
    std::vector<Local> locals_;
    std::vector<Moves> moves_;  // by region
    std::vector<Assignment> changes_;
    std::vector<lts::Word> target_;
    bool busy_ = false;
};

}  // namespace robochart::machine
