// SPDX-License-Identifier: Apache-2.0
#include "conformance/model/register_system.hpp"

#include <algorithm>

namespace robochart::conformance {

namespace {

// The layout of a packed state. The last words are one for each register: the last reading of a variable, 0 for events.
namespace word {
enum Place : std::size_t { model, next_register, pending, tocks, kept };
/// The value of `tocks` between the first read or write of a cycle and its first tock. At other times, `tocks` is the
/// number of tocks of the cycle; it is 0 before the first read or write.
constexpr lts::Word acting = 0xffffffffU;
}  // namespace word
/// The state of the model after ✓. (log_projection.cpp uses the next number for states that are not known.)
constexpr lts::Word after_end = 0xfffffffeU;
constexpr std::uint32_t no_input = 0xffffffffU;

}  // namespace

struct RegisterSystem::Move {
    lts::StateView from;
    lts::SuccessorSink& sink;
    std::vector<lts::Word> next;
    bool urgent = false;  ///< there is a τ or ✓

    std::vector<lts::Word>& restart() {
        next.assign(from.begin(), from.end());
        return next;
    }
};

RegisterSystem::RegisterSystem(ModelGraph& model, const Alphabet& alphabet, std::uint32_t cycle_length, AfterEnd after)
    : model_(&model),
      alphabet_(&alphabet),
      cycle_length_(cycle_length),
      after_(after),
      inputs_(alphabet.interface().inputs.size()) {
    const std::vector<Register>& inputs = alphabet.interface().inputs;
    for (const Output& output : alphabet.interface().outputs) {
        const auto same = std::ranges::find_if(inputs, [&](const Register& input) {
            return input.kept != 0 && "set_" + input_name(input) == output.name;
        });
        kept_by_output_.push_back(same == inputs.end() ? no_input : static_cast<std::uint32_t>(same - inputs.begin()));
    }
}

std::size_t RegisterSystem::width() const {
    return word::kept + inputs_;
}

void RegisterSystem::initial(std::span<lts::Word> state) {
    std::ranges::fill(state, 0U);
    state[word::model] = model_->initial();
    for (std::size_t i = 0; i < inputs_; ++i) state[word::kept + i] = alphabet_->interface().inputs[i].kept;
}

void RegisterSystem::successors(lts::StateView state, lts::SuccessorSink& sink) {
    Move move{state, sink, {}};
    if (state[word::model] == after_end) {
        if (after_ == AfterEnd::idle) sink.add(alphabet_->tock(), state, alphabet_->tock());
        return;
    }
    if (state[word::pending] != 0) {
        move.restart()[word::pending] = 0;
        return sink.add(state[word::pending], move.next, state[word::pending]);
    }
    const std::vector<ModelEdge>& edges = model_->edges(state[word::model]);
    for (const ModelEdge& edge : edges) add_edge(move, edge);
    if (move.urgent) return;
    for (const ModelEdge& edge : edges) {
        if (edge.role.kind != ModelRole::Kind::tock) continue;
        move.restart()[word::model] = edge.target;
        const lts::Word before = state[word::tocks] == word::acting ? 0 : state[word::tocks];
        move.next[word::tocks] = before + 1 == cycle_length_ ? 0 : before + 1;
        sink.add(edge.event, move.next, edge.event);
    }
}

void RegisterSystem::add_edge(Move& move, const ModelEdge& edge) const {
    move.restart()[word::model] = edge.target;
    switch (edge.role.kind) {
        case ModelRole::Kind::tau:
        case ModelRole::Kind::hidden:
        case ModelRole::Kind::terminate:
            move.urgent = true;
            return move.sink.add(process::tau, move.next, edge.revealed);
        case ModelRole::Kind::tick:
            move.urgent = true;
            move.next[word::model] = after_end;
            return after_ == AfterEnd::idle ? move.sink.add(process::tau, move.next, process::tick)
                                            : move.sink.add(process::tick, move.next, process::tick);
        case ModelRole::Kind::read:
            return add_read(move, edge);
        case ModelRole::Kind::output:
            return add_write(move, edge);
        case ModelRole::Kind::tock:
        case ModelRole::Kind::input:
        case ModelRole::Kind::blocked:
        case ModelRole::Kind::foreign:
            return;
    }
}

void RegisterSystem::add_read(Move& move, const ModelEdge& edge) const {
    const std::uint32_t input = edge.role.index, reading = edge.role.reading;
    if (move.from[word::next_register] != input) return;
    move.next[word::next_register] = input + 1 == inputs_ ? 0 : input + 1;
    move.next[word::tocks] = word::acting;
    const process::Event event = alphabet_->read_event(input, reading);
    if (alphabet_->interface().inputs[input].kept == 0) return move.sink.add(event, move.next, event);
    const process::Event absent = alphabet_->read_event(input, 0);
    if (move.from[word::kept + input] == reading) move.sink.add(absent, move.next, absent);
    move.next[word::kept + input] = reading;
    move.sink.add(event, move.next, event);
}

/// Adds the report of an output that the component has made. The report comes before anything else.
void RegisterSystem::add_write(Move& move, const ModelEdge& edge) const {
    move.urgent = true;
    move.next[word::pending] = edge.role.write;
    move.next[word::tocks] = word::acting;
    if (const std::uint32_t input = kept_by_output_[edge.role.index]; input != no_input) {
        const auto& texts = alphabet_->interface().inputs[input].texts;
        const auto value = std::ranges::find(texts, alphabet_->written_arguments(edge.role.write).at(0));
        if (value != texts.end()) move.next[word::kept + input] = 1 + static_cast<lts::Word>(value - texts.begin());
    }
    move.sink.add(process::tau, move.next, edge.event);
}

std::string RegisterSystem::describe(lts::StateView state) const {
    return state[word::model] == after_end ? "terminated" : model_->describe(state[word::model]);
}

bool RegisterSystem::begins_cycle(lts::StateView state) const {
    return state[word::model] != after_end && state[word::tocks] == 0;
}

std::string RegisterSystem::describe_model(lts::StateView state) const {
    return state[word::model] == after_end ? "" : model_->describe(state[word::model]);
}

}  // namespace robochart::conformance
