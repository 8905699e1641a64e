// SPDX-License-Identifier: Apache-2.0
// Explores M on demand. Numbers the states, maps their transitions to roles in the cycle, and stores them.
#include "conformance/model/model_graph.hpp"

#include <fmt/format.h>

#include <cstring>
#include <unordered_set>

namespace robochart::conformance {

namespace {

struct Successor {
    process::Event event;
    process::Event revealed;
    std::vector<lts::Word> target;
};

class Collect : public lts::SuccessorSink {
public:
    void add(process::Event event, lts::StateView target, process::Event revealed) override {
        successors.push_back({event, revealed, {target.begin(), target.end()}});
    }
    std::vector<Successor> successors;
};

}  // namespace

ModelGraph::ModelGraph(lts::TransitionSystem& model, const Alphabet& alphabet)
    : model_(&model), alphabet_(&alphabet), width_(model.width()) {
    std::vector<lts::Word> start(width_);
    model.initial(start);
    initial_ = intern_state(start);
}

ModelState ModelGraph::intern_state(lts::StateView state) {
    const std::string key(reinterpret_cast<const char*>(state.data()), state.size_bytes());
    const auto [place, fresh] = ids_.emplace(key, static_cast<ModelState>(edges_.size()));
    if (fresh) {
        words_.insert(words_.end(), state.begin(), state.end());
        edges_.emplace_back();
    }
    return place->second;
}

lts::StateView ModelGraph::packed_state(ModelState state) const {
    return {words_.data() + state * width_, width_};
}

const ModelRole& ModelGraph::event_role(process::Event event) {
    if (event >= roles_.size()) {
        roles_.resize(event + 1U);
        role_known_.resize(event + 1U);
    }
    if (!role_known_[event]) {
        roles_[event] = alphabet_->model_role(event);
        role_known_[event] = true;
    }
    return roles_[event];
}

void ModelGraph::expand_state(ModelState state) {
    if (poll_) poll_();
    Collect sink;
    // A copy, because `words_` may grow while the model calls its own sink.
    const std::vector<lts::Word> packed(packed_state(state).begin(), packed_state(state).end());
    model_->successors(packed, sink);
    std::vector<ModelEdge> edges;
    for (const Successor& successor : sink.successors) {
        const ModelRole& role_of = event_role(successor.event);
        if (role_of.kind == ModelRole::Kind::foreign)
            throw AlphabetError(fmt::format("the model can do {}, which the code's interface does not have",
                                            model_->events().name(successor.event)));
        if (role_of.kind == ModelRole::Kind::blocked) continue;
        edges.push_back({role_of, successor.event, successor.revealed, intern_state(successor.target)});
    }
    edges_[state].edges = std::move(edges);
    edges_[state].known = true;
}

const std::vector<ModelEdge>& ModelGraph::edges(ModelState state) {
    if (!edges_[state].known) expand_state(state);
    return edges_[state].edges;
}

namespace {

/// Visits the edges of every state that is reachable before time passes, until `enough` returns true. Returns false if
/// there are too many states.
template <class Enough>
bool look_before_time_passes(ModelGraph& graph, ModelState start, Enough enough) {
    constexpr std::size_t most = 20'000;
    std::unordered_set<ModelState> seen{start};
    std::vector<ModelState> open{start};
    while (!open.empty()) {
        if (seen.size() > most) return false;
        const ModelState state = open.back();
        open.pop_back();
        for (const ModelEdge& edge : graph.edges(state)) {
            if (enough(edge)) return true;
            if (edge.role.kind != ModelRole::Kind::tock && seen.insert(edge.target).second) open.push_back(edge.target);
        }
    }
    return true;
}

}  // namespace

/// If there are too many states, returns false: the model is then reported to stop time.
bool ModelGraph::goes_on(ModelState start) {
    const auto found = goes_on_.find(start);
    if (found != goes_on_.end()) return found->second;
    bool result = false;
    (void)look_before_time_passes(*this, start, [&](const ModelEdge& edge) {
        using Kind = ModelRole::Kind;
        const Kind kind = edge.role.kind;
        result = kind == Kind::tock || kind == Kind::tick || kind == Kind::terminate;
        return result;
    });
    return goes_on_.emplace(start, result).first->second;
}

/// If there are too many states, returns true for all registers, which only loses the reduction of readings.
const std::vector<bool>& ModelGraph::heard_inputs(ModelState start) {
    const auto found = hears_.find(start);
    if (found != hears_.end()) return found->second;
    std::vector<bool> heard(alphabet_->interface().inputs.size());
    const bool all = look_before_time_passes(*this, start, [&](const ModelEdge& edge) {
        if (edge.role.kind == ModelRole::Kind::input) heard[edge.role.index] = true;
        return false;
    });
    if (!all) heard.assign(heard.size(), true);
    return hears_.emplace(start, std::move(heard)).first->second;
}

std::string ModelGraph::describe(ModelState state) const {
    return model_->describe(packed_state(state));
}

}  // namespace robochart::conformance
