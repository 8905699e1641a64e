// SPDX-License-Identifier: Apache-2.0
// Computes NF_c(M) step by step. Each rule cites the assumption of docs/conformance.md that it implements: A1
// registers, A2 outputs and time, A3 the cycle, H hiding of M's alphabet, P priority of τ and ✓ over tock.
#include "conformance/model/normal_form_system.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace robochart::conformance {

namespace {

// The layout of a packed state. With Outputs::once, the mask of outputs written in this cycle follows. The last words
// are one for each register: 0 if it is empty, otherwise the reading.
enum Field : std::size_t { phase, progress, model_state, pending, fields };
enum Phase : lts::Word {
    reading,  ///< progress: the next register
    acting,   ///< between the reads and the tock
    waiting,  ///< progress: the number of remaining tocks (in cycles with several tocks)
    ending,   ///< terminated, before ✓
    over,
    repeated,  ///< Outputs::once; pending: the report of the second output
    missed,    ///< Deadlines::mark and idle; model_state: the state in which M waits
};
/// The content of a register that was not read (Frame::unread).
constexpr lts::Word not_read = 0xffffffffU;
/// The state of the model after M's own ✓, before `terminate`.
constexpr lts::Word gone = 0xffffffffU;

}  // namespace

/// The data of one call of `successors`: the source state, the sink, and whether tock is still possible.
struct NormalFormSystem::Move {
    lts::StateView from;
    lts::SuccessorSink& sink;
    std::vector<lts::Word> next;
    bool urgent = false;  ///< a τ or ✓ was found (P)
    bool stands = true;   ///< no step was found

    std::vector<lts::Word>& restart() {
        next.assign(from.begin(), from.end());
        return next;
    }
    void add_silent_step(process::Event revealed) {
        urgent = true;
        stands = false;
        sink.add(process::tau, next, revealed);
    }
};

NormalFormSystem::NormalFormSystem(ModelGraph& model, const Alphabet& alphabet, std::uint32_t cycle_length, Frame frame)
    : model_(&model),
      alphabet_(&alphabet),
      cycle_length_(std::max(1U, cycle_length)),
      frame_(frame),
      repeats_(alphabet.events().intern("model.repeats")),
      deadline_(alphabet.events().intern("model.deadline")),
      inputs_(alphabet.interface().inputs.size()),
      mask_words_(frame.outputs == Outputs::once ? (alphabet.interface().outputs.size() + 31) / 32 : 0) {
    for (std::size_t i = 0; frame.unread && i < inputs_; ++i) {
        unread_.push_back(alphabet.events().intern(fmt::format("model.unread.{}", i)));
        asks_.push_back(alphabet.events().intern(fmt::format("model.asks.{}", i)));
    }
}

std::size_t NormalFormSystem::width() const {
    return fields + mask_words_ + inputs_;
}

void NormalFormSystem::initial(std::span<lts::Word> state) {
    std::ranges::fill(state, 0U);
    state[model_state] = model_->initial();
    begin_cycle(state);
}

// Begins a new cycle: all outputs are possible again (A2), and all registers are read again (A3). The contents that A1
// still stores are cleared here, because they cannot be consumed before the registers are read again (A3). The state is
// equivalent, and there are fewer states.
void NormalFormSystem::begin_cycle(std::span<lts::Word> state) const {
    std::fill(state.begin() + fields, state.end(), 0U);
    state[phase] = inputs_ == 0 ? acting : reading;
    state[progress] = 0;
}

void NormalFormSystem::successors(lts::StateView state, lts::SuccessorSink& sink) {
    Move move{state, sink, {}};
    if (state[phase] == over) {
        if (frame_.after == AfterTermination::idle) sink.add(alphabet_->tock(), state, alphabet_->tock());
        return;
    }
    if (state[phase] == repeated) return;
    if (state[phase] == missed) {
        if (frame_.deadlines == Deadlines::idle) sink.add(alphabet_->tock(), state, alphabet_->tock());
        return;
    }
    if (state[phase] == ending) {
        move.restart()[phase] = over;
        if (frame_.after == AfterTermination::idle)
            move.add_silent_step(process::tick);
        else
            sink.add(process::tick, move.next, process::tick);
        return;
    }
    if (state[phase] == reading) add_reads(move);
    if (state[pending] != 0) {  // A2: the report follows the output before any other output or tock
        move.restart()[pending] = 0;
        move.stands = false;
        sink.add(frame_.writes_hidden ? process::tau : state[pending], move.next, state[pending]);
    }
    if (state[model_state] == gone)
        add_termination(move);
    else
        model_moves(move);
    if (move.stands && frame_.deadlines != Deadlines::stop && awaits_input(state)) add_missed_deadline(move);
}

/// Detects a missed deadline of an input. M lets no time pass in the middle of a cycle's actions, but inputs could make
/// M continue to a point at which time passes again. There is no other sign of such a deadline, because M has performed
/// every step that needs no input (P). If another machine would take an input, but time still could not pass after it,
/// this input does not indicate a missed deadline.
bool NormalFormSystem::awaits_input(lts::StateView state) {
    if (state[phase] != acting || state[pending] != 0 || state[model_state] == gone) return false;
    const std::vector<ModelEdge>& edges = model_->edges(state[model_state]);
    return std::ranges::any_of(edges, [this](const ModelEdge& edge) {
        return edge.role.kind == ModelRole::Kind::input && model_->goes_on(edge.target);
    });
}

void NormalFormSystem::add_missed_deadline(Move& move) {
    move.restart()[phase] = missed;
    std::fill(move.next.begin() + fields, move.next.end(), 0U);
    if (frame_.deadlines == Deadlines::idle)
        move.add_silent_step(deadline_);
    else
        move.sink.add(deadline_, move.next, deadline_);
}

namespace {

class Counts final : public lts::SuccessorSink {
public:
    void add(process::Event /*event*/, lts::StateView /*target*/, process::Event /*revealed*/) override { ++count; }
    std::size_t count = 0;
};

}  // namespace

Standstill NormalFormSystem::standstill_kind(lts::StateView state) {
    if (state[phase] == over) return Standstill::terminated;
    Counts sink;
    successors(state, sink);
    if (sink.count > 0) return Standstill::none;
    if (state[phase] == waiting) return standstill_in_mid_cycle(state);
    return awaits_input(state) ? Standstill::inputs : Standstill::other;
}

Standstill NormalFormSystem::standstill_in_mid_cycle(lts::StateView state) {
    if (state[model_state] == gone) return Standstill::end_in_mid_cycle;
    const std::vector<ModelEdge>& edges = model_->edges(state[model_state]);
    const auto offers = [&edges](const auto& fits) { return std::ranges::any_of(edges, fits); };
    using Kind = ModelRole::Kind;
    if (offers([](const ModelEdge& edge) { return edge.role.kind == Kind::output; }))
        return Standstill::output_in_mid_cycle;
    const bool input =
        offers([&](const ModelEdge& edge) { return edge.role.kind == Kind::input && model_->goes_on(edge.target); });
    return input ? Standstill::input_in_mid_cycle : Standstill::other;
}

/// Drops inputs. The same filter is used for the code.
void NormalFormSystem::drop_inputs(std::span<lts::Word> state, lts::Word model) {
    const auto content = state.subspan(fields + mask_words_, inputs_);
    for (const DroppedInput& drop : alphabet_->interface().drops)
        if (content[drop.event] != 0) content[drop.dropped] = 0;
    for (const DroppedInput& drop : alphabet_->interface().drops)
        if (model == gone || !model_->heard_inputs(model)[drop.event]) content[drop.event] = 0;
}

// Adds the reads (A1, A3): registers are read one after the other, each with any reading. If M cannot read a register
// before time passes, the register is treated as absent (model_graph.hpp).
void NormalFormSystem::add_reads(Move& move) {
    const lts::Word at = move.from[progress];
    const auto input = static_cast<std::uint32_t>(at);
    const lts::Word state = move.from[model_state];
    const std::vector<DroppedInput>& drops = alphabet_->interface().drops;
    const bool decides = std::ranges::find(drops, input, &DroppedInput::event) != drops.end();
    const bool heard = state != gone && model_->heard_inputs(state)[input];
    const auto found = [&](lts::Word reading, process::Event event) {
        std::vector<lts::Word>& next = move.restart();
        next[fields + mask_words_ + input] = heard || decides ? reading : 0;
        next[progress] = at + 1;
        if (at + 1 == inputs_) {
            if (!drops.empty()) drop_inputs(next, state);
            next[phase] = acting;
            next[progress] = 0;
        }
        move.stands = false;
        move.sink.add(event, next, event);
    };
    for (std::uint32_t r = 0; r < alphabet_->interface().inputs[input].reading_count(); ++r)
        found(r, alphabet_->read_event(input, r));
    if (frame_.unread) found(not_read, unread_[input]);
}

void NormalFormSystem::model_moves(Move& move) {
    const std::vector<ModelEdge>& edges = model_->edges(move.from[model_state]);
    for (const ModelEdge& edge : edges) model_step(move, edge);
    if (move.urgent) return;  // P: prioritise(…, <{}, {tock}>)
    for (const ModelEdge& edge : edges) {
        if (edge.role.kind == ModelRole::Kind::tock) pass_time(move, edge);
    }
}

void NormalFormSystem::model_step(Move& move, const ModelEdge& edge) {
    std::vector<lts::Word>& next = move.restart();
    switch (edge.role.kind) {
        case ModelRole::Kind::tau:
        case ModelRole::Kind::terminate:  // M \ {terminate}
            next[model_state] = edge.target;
            move.add_silent_step(edge.role.kind == ModelRole::Kind::tau ? edge.revealed : edge.event);
            return;
        case ModelRole::Kind::tick:  // M \ {terminate} ; terminate -> SKIP
            next[model_state] = gone;
            move.add_silent_step(edge.event);
            return;
        case ModelRole::Kind::input:
            return add_input_step(move, edge);
        case ModelRole::Kind::output:
            return store_output(move, edge);
        case ModelRole::Kind::tock:
        case ModelRole::Kind::read:
        case ModelRole::Kind::hidden:
        case ModelRole::Kind::blocked:
        case ModelRole::Kind::foreign:
            return;
    }
}

// Adds an input. A1: it happens only with the reading of this cycle, and only once. A3: not before all registers are
// read. H: hidden.
void NormalFormSystem::add_input_step(Move& move, const ModelEdge& edge) {
    lts::Word& held = move.next[fields + mask_words_ + edge.role.index];
    if (move.from[phase] != acting) return;
    if (held == not_read) {
        move.stands = false;
        move.sink.add(asks_[edge.role.index], move.from, asks_[edge.role.index]);
    }
    if (held != edge.role.reading) return;
    held = 0;
    move.next[model_state] = edge.target;
    move.add_silent_step(edge.event);
}

// Stores an output. A2: any number, one report at a time. A3: not before all registers are read. H: hidden.
void NormalFormSystem::store_output(Move& move, const ModelEdge& edge) {
    if (move.from[phase] != acting || move.from[pending] != 0) return;
    move.next[pending] = edge.role.write;
    if (frame_.outputs == Outputs::once) {
        lts::Word& mask = move.next[fields + edge.role.index / 32];
        const lts::Word bit = 1U << (edge.role.index % 32);
        if ((mask & bit) != 0) return add_repeat(move);
        mask |= bit;
    }
    move.next[model_state] = edge.target;
    move.add_silent_step(edge.event);
}

void NormalFormSystem::add_repeat(Move& move) {
    std::fill(move.next.begin() + fields, move.next.end(), 0U);
    move.next[phase] = repeated;
    move.urgent = true;
    move.stands = false;
    move.sink.add(repeats_, move.next, repeats_);
}

// Adds a tock. A2: not while a report is pending. A3: not while registers are read. After the first tock of a cycle,
// only tocks follow.
void NormalFormSystem::pass_time(Move& move, const ModelEdge& edge) {
    const lts::Word at = move.from[phase];
    if (at == reading || move.from[pending] != 0) return;
    std::vector<lts::Word>& next = move.restart();
    next[model_state] = edge.target;
    const lts::Word left = (at == waiting ? move.from[progress] : cycle_length_) - 1;
    if (left == 0) {
        begin_cycle(next);
    } else {
        std::fill(next.begin() + fields, next.end(), 0U);  // A1, A2: not used before the next cycle
        next[phase] = waiting;
        next[progress] = left;
    }
    move.stands = false;
    move.sink.add(edge.event, next, edge.event);
}

// Adds termination. All parts synchronise on `terminate`, after the reads and if no report is pending. The event is
// hidden, and after it all parts perform ✓ together.
void NormalFormSystem::add_termination(Move& move) {
    if (move.from[phase] != acting || move.from[pending] != 0) return;
    std::vector<lts::Word>& next = move.restart();
    std::ranges::fill(next, 0U);
    next[phase] = ending;
    move.add_silent_step(process::tick);
}

bool NormalFormSystem::begins_cycle(lts::StateView state) const {
    const bool fresh = std::all_of(state.begin() + fields, state.end(), [](lts::Word word) { return word == 0; });
    const bool first = state[phase] == (inputs_ == 0 ? acting : reading) && state[progress] == 0;
    return fresh && first && state[pending] == 0 && state[model_state] != gone;
}

std::optional<ModelState> NormalFormSystem::model_state_of(lts::StateView state) const {
    const bool ended = state[phase] == ending || state[phase] == over || state[model_state] == gone;
    return ended ? std::nullopt : std::optional(state[model_state]);
}

std::string NormalFormSystem::describe_model(lts::StateView state) const {
    const std::optional<ModelState> at = model_state_of(state);
    return at ? model_->describe(*at) : "";
}

std::string NormalFormSystem::describe(lts::StateView state) const {
    if (state[phase] == ending || state[phase] == over) return "terminated";
    if (state[model_state] == gone) return "terminating";
    if (state[phase] == repeated)
        return fmt::format("{} a second time in one cycle, at {}", alphabet_->describe_event(state[pending]),
                           model_->describe(state[model_state]));
    return model_->describe(state[model_state]);
}

}  // namespace robochart::conformance
