// SPDX-License-Identifier: Apache-2.0
// Explores a transition system and stores it as a graph.
#include "checker/lts/graph.hpp"

#include <cassert>

namespace robochart::lts {
namespace {

class EdgeCollector final : public SuccessorSink {
public:
    explicit EdgeCollector(Exploration& exploration) : exploration_(exploration) {}
    void add(Event event, StateView target, Event /*revealed*/) override {
        exploration_.graph.add_edge({event, exploration_.states.insert(target).index});
    }

private:
    Exploration& exploration_;
};

class FindsTau final : public SuccessorSink {
public:
    void add(Event event, StateView /*target*/, Event /*revealed*/) override { found = found || event == tau; }
    bool found = false;
};

}  // namespace

Exploration explore(TransitionSystem& system, const std::function<void(std::size_t)>& on_state) {
    Exploration result{{}, StateStore(system.width())};
    std::vector<Word> initial(system.width());
    system.initial(initial);
    result.states.insert(initial);
    EdgeCollector collector(result);
    for (StateIndex state = 0; state < result.states.size(); ++state) {
        on_state(result.states.size());
        system.successors(result.states[state], collector);
        result.graph.finish_state();
    }
    return result;
}

void GraphSystem::successors(StateView state, SuccessorSink& sink) {
    assert(state.size() == 1);
    for (const Edge& edge : graph_.edges(state[0])) sink.add(edge.event, StateView(&edge.target, 1), edge.event);
}

std::string GraphSystem::describe(StateView state) const {
    return "state " + std::to_string(state[0]);
}

bool has_tau(TransitionSystem& system, StateView state) {
    FindsTau sink;
    system.successors(state, sink);
    return sink.found;
}

}  // namespace robochart::lts
