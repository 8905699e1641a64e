// SPDX-License-Identifier: Apache-2.0
// Defines the transition system of a compiled process.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "checker/lts/transition_system.hpp"
#include "checker/machine/confluence.hpp"
#include "checker/machine/supercombinator.hpp"
#include "checker/machine/whole_rules.hpp"

namespace robochart::machine {

/// A state of this system consists of the packed states of all components. When the buffers have reached their final
/// size, successors are computed without allocating memory.
class SupercombinatorSystem final : public lts::TransitionSystem {
public:
    /// `terms` contains the terms to which the states of components refer.
    SupercombinatorSystem(std::shared_ptr<const Supercombinator> combined, const process::TermStore& terms);

    [[nodiscard]] std::size_t width() const override { return combined_->words; }
    void initial(std::span<lts::Word> state) override;
    void successors(lts::StateView state, lts::SuccessorSink& sink) override;
    [[nodiscard]] std::unique_ptr<lts::TransitionSystem> clone_for_thread() const override { return make_copy(); }
    [[nodiscard]] std::unique_ptr<lts::ReducedSystem> make_reduced_system(lts::Followed followed,
                                                                          diagnostics::Pollable& budget) const override;
    [[nodiscard]] bool excludes_tau_cycles(diagnostics::Pollable& budget) const override;
    [[nodiscard]] bool excludes_choices(diagnostics::Pollable& budget) const override;
    [[nodiscard]] std::unique_ptr<lts::TransitionSystem> make_cycle_system(
        diagnostics::Pollable& budget) const override;
    /// A function that builds the process from components that were not minimised, or returns null if it
    /// cannot.
    using MakeFiner = std::function<std::unique_ptr<lts::FinerSystem>(diagnostics::Pollable&)>;
    void set_finer_system(MakeFiner make) { make_finer_ = std::move(make); }
    [[nodiscard]] std::unique_ptr<lts::FinerSystem> make_finer_system(diagnostics::Pollable& budget) const override {
        return make_finer_ ? make_finer_(budget) : nullptr;
    }
    [[nodiscard]] std::vector<lts::ReplicaSet> replicas(diagnostics::Pollable& budget) const override;
    [[nodiscard]] const process::EventTable& events() const override { return terms_.events(); }
    [[nodiscard]] std::string describe(lts::StateView state) const override;
    void set_budget(diagnostics::Pollable& budget) override { budget_ = &budget; }
    [[nodiscard]] const Supercombinator& combined() const { return *combined_; }
    [[nodiscard]] const std::shared_ptr<const Supercombinator>& share_combined() const { return combined_; }
    /// Returns the number of transitions of components that were examined so far to compute successors.
    [[nodiscard]] std::uint64_t examined_step_count() const { return work_; }

private:
    struct Move {
        std::uint32_t event;  ///< index in the region's alphabet
        Event revealed;
        std::uint32_t first_change, end_change;
    };
    /// A part of a region's list of moves. Valid in the state with this number.
    struct Range {
        std::uint64_t state = 0;
        std::size_t from = 0, to = 0;
    };
    /// The known moves of an inner region in the current state. Moves are computed when they are needed.
    struct Moves {
        std::vector<Move> list;
        std::vector<Assignment> changes;
        Range leading;                ///< moves for outer rules that begin with this region
        std::vector<Range> by_event;  ///< by event: the moves that were requested
        std::uint64_t state = 0;      ///< number of the state for which `best` is valid
        std::uint32_t best = 0;       ///< the first level that has a move, or no_level
    };
    class Firing;

    [[nodiscard]] std::unique_ptr<SupercombinatorSystem> make_copy() const;
    [[nodiscard]] std::optional<ProofPlan> make_plan(lts::Followed followed, diagnostics::Pollable& budget) const;
    [[nodiscard]] const WholeRules* find_whole_rules(diagnostics::Pollable& budget) const;
    [[nodiscard]] const std::vector<bool>& find_cycle_rules(const WholeRules& rules,
                                                            diagnostics::Pollable& budget) const;
    void pass_successors(lts::StateView state, lts::SuccessorSink& sink);
    void unpack(lts::StateView state);
    Range leading_moves(std::uint32_t region, const std::vector<std::uint32_t>& first_rule_around);
    Range moves_by(std::uint32_t region, std::uint32_t event);
    std::uint32_t best_level(std::uint32_t region);

    /// Facts about the rules of the whole process. Copies of the system share them.
    struct RuleFacts {
        std::shared_ptr<const WholeRules> whole;             ///< null if not computed, or if there are too many rules
        bool too_many = false;                               ///< true if proofs with so many rules would take too long
        std::shared_ptr<const std::vector<bool>> on_cycles;  ///< result of rules_on_tau_cycles; null if not computed
        /// The plans of the reduced systems. The outer value is missing if the plan has not been made; the inner value
        /// is missing if the reduction saves nothing.
        std::optional<std::optional<ProofPlan>> plan_of_taus, plan_of_steps;
    };

    std::shared_ptr<const Supercombinator> combined_;
    const process::TermStore& terms_;
    mutable RuleFacts facts_;                         // computed on first use
    std::shared_ptr<const std::vector<bool>> fired_;  // by rule of the outermost region: may it fire? null: all may
    MakeFiner make_finer_;
    std::vector<Local> locals_;
    std::vector<Moves> moves_;         // by region
    std::vector<Assignment> changes_;  // changes by the current rules; those of inner regions are last
    std::uint64_t state_number_ = 0;   // number of the current state
    std::vector<lts::Word> target_;
    bool busy_ = false;
    mutable std::optional<std::vector<lts::ReplicaSet>> replicas_;  // computed on first use
    diagnostics::Pollable* budget_ = &diagnostics::unlimited;       // polled within a state, too: it may be large
    std::uint32_t performed_ = 0;
    std::uint64_t work_ = 0;
};

}  // namespace robochart::machine
