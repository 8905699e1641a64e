// SPDX-License-Identifier: Apache-2.0
// Numbers the states of the model M and stores their successors, because NF_c(M) visits each state of M with many
// register contents. The graph also computes which registers a state can still read before time passes.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/lts/transition_system.hpp"
#include "conformance/code/interface.hpp"

namespace robochart::conformance {

using ModelState = std::uint32_t;

struct ModelEdge {
    ModelRole role;
    process::Event event = process::tau;
    process::Event revealed = process::tau;
    ModelState target = 0;
};

class ModelGraph {
public:
    /// The functions throw AlphabetError when they visit a state with an event that the alphabet does not name.
    ModelGraph(lts::TransitionSystem& model, const Alphabet& alphabet);

    [[nodiscard]] ModelState initial() const { return initial_; }
    [[nodiscard]] const std::vector<ModelEdge>& edges(ModelState);
    /// Returns, for each register, whether its event can happen from this state before the next tock, in any run. The
    /// function ignores the simulation assumptions. So the answer `true` may be wrong, but the answer `false` is always
    /// right.
    [[nodiscard]] const std::vector<bool>& heard_inputs(ModelState);
    /// Returns whether the model can reach a state in which time can pass or the model can terminate, before time
    /// passes. The sequence of events to this state may contain any inputs.
    [[nodiscard]] bool goes_on(ModelState);
    [[nodiscard]] std::string describe(ModelState) const;
    /// Returns the state as M packs it. The result is valid until another state is added.
    [[nodiscard]] lts::StateView packed_state(ModelState) const;
    /// Sets the budget that is polled for every expanded state; it must outlive its use.
    void set_budget(diagnostics::Pollable& budget) { budget_ = &budget; }
    [[nodiscard]] std::size_t size() const { return edges_.size(); }

private:
    struct Node {
        bool known = false;
        std::vector<ModelEdge> edges;
    };
    ModelState intern_state(lts::StateView);
    void expand_state(ModelState);
    [[nodiscard]] bool is_evaluated(ModelState);
    void find_components(ModelState);
    void close_component(std::vector<ModelState>& open, ModelState first);
    [[nodiscard]] const ModelRole& event_role(process::Event);

    diagnostics::Pollable* budget_ = &diagnostics::unlimited;
    lts::TransitionSystem* model_;
    const Alphabet* alphabet_;
    std::size_t width_;
    ModelState initial_ = 0;
    std::unordered_map<std::string, ModelState> ids_;  ///< bytes of the packed state; never iterated
    std::vector<lts::Word> words_;
    std::deque<Node> edges_;  ///< a deque, so that references stay valid while the graph grows
    static constexpr std::uint32_t unknown = 0xffffffffU;
    static constexpr std::uint32_t hears_all = 0;
    std::vector<std::uint32_t> component_of_;  ///< for each state: an index of `heard_`, or unknown
    std::deque<std::vector<bool>> heard_;      ///< the first element: all registers can be heard
    std::unordered_map<ModelState, bool> goes_on_;
    std::vector<ModelRole> roles_;
    std::vector<bool> role_known_;
};

}  // namespace robochart::conformance
