// SPDX-License-Identifier: Apache-2.0
// Implements log_projection.hpp: hides unobserved events of NF_c(M). For logs that start late, every beginning of a
// cycle is an initial state.
#include "conformance/traces/log_projection.hpp"

#include <algorithm>

#include "checker/lts/graph.hpp"
#include "checker/refine/search/budget.hpp"
#include "checker/refine/search/poll_guard.hpp"

namespace robochart::conformance {

namespace {

/// The first word of the packed state while the initial state is unknown. Neither a phase of NF_c(M) nor a state of
/// S(M) has this number.
constexpr lts::Word anywhere = 0xffffffffU;

bool is_unknown(lts::StateView state) {
    return !state.empty() && state[0] == anywhere;
}

}  // namespace

std::vector<std::vector<lts::Word>> cycle_starts(CycleSystem& system, const refine::Limits& limits, std::size_t most) {
    struct TooMany {};
    refine::Budget budget(limits);
    const refine::PollGuard guard({&system}, budget);
    std::vector<std::vector<lts::Word>> starts;
    try {
        const lts::Exploration all = lts::explore(system, [&](std::size_t states) {
            if (states > most) throw TooMany();
            budget.states(states);
            budget.charge();
        });
        for (std::size_t i = 0; i < all.states.size(); ++i) {
            const lts::StateView state = all.states[static_cast<lts::StateIndex>(i)];
            if (system.begins_cycle(state)) starts.emplace_back(state.begin(), state.end());
        }
    } catch (const TooMany&) {
        starts.clear();
    }
    return starts;
}

/// Hides unobserved events.
class ObservedSystem::Sink final : public lts::SuccessorSink {
public:
    Sink(ObservedSystem& system, lts::SuccessorSink& out) : system_(system), out_(out) {}
    void add(process::Event event, lts::StateView target, process::Event revealed) override {
        out_.add(system_.is_hidden(event) ? process::tau : event, target, revealed);
    }

private:
    ObservedSystem& system_;
    lts::SuccessorSink& out_;
};

ObservedSystem::ObservedSystem(CycleSystem& normal_form, const Alphabet& alphabet, Observation observation,
                               std::vector<std::vector<lts::Word>> starts)
    : normal_form_(&normal_form),
      alphabet_(&alphabet),
      observation_(std::move(observation)),
      starts_(std::move(starts)) {}

void ObservedSystem::initial(std::span<lts::Word> state) {
    if (starts_.empty()) return normal_form_->initial(state);
    std::ranges::fill(state, anywhere);
}

void ObservedSystem::successors(lts::StateView state, lts::SuccessorSink& sink) {
    if (is_unknown(state)) {
        for (const auto& start : starts_) sink.add(process::tau, start, process::tau);
        return;
    }
    Sink hiding(*this, sink);
    normal_form_->successors(state, hiding);
}

bool ObservedSystem::is_hidden(process::Event event) {
    if (event >= hidden_.size()) hidden_.resize(event + 1U, -1);
    if (hidden_[event] < 0) {
        const CycleRole role = alphabet_->cycle_role(event);
        bool shown = true;
        if (role.kind == CycleRole::Kind::read) shown = observation_.inputs[role.index];
        if (role.kind == CycleRole::Kind::write) shown = observation_.outputs[role.index];
        hidden_[event] = shown ? 0 : 1;
    }
    return hidden_[event] == 1;
}

bool ObservedSystem::is_stable(lts::StateView state) {
    return !lts::has_tau(*this, state);
}

std::string ObservedSystem::describe(lts::StateView state) const {
    return is_unknown(state) ? "anywhere" : normal_form_->describe(state);
}

std::string ObservedSystem::describe_model(lts::StateView state) const {
    return is_unknown(state) ? "" : normal_form_->describe_model(state);
}

}  // namespace robochart::conformance
