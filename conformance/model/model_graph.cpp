// SPDX-License-Identifier: Apache-2.0
// Explores M on demand: numbers the states, maps their transitions to roles in the cycle, and stores them.
#include "conformance/model/model_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <unordered_set>

#include "checker/cspm/session.hpp"

namespace robochart::conformance {

namespace {

/// The maximal number of states that one search for events before the next tock visits.
constexpr std::size_t most_in_search = 20'000;

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
    heard_.emplace_back(alphabet.interface().inputs.size(), true);
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
    budget_->poll();
    Collect sink;
    // The state is copied, because `words_` may grow while the model calls its own sink.
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

/// Evaluates the edges of a state. Returns false if this fails, for example because a value leaves its carrier.
bool ModelGraph::is_evaluated(ModelState state) {
    try {
        (void)edges(state);
        return true;
    } catch (const cspm::EvaluationError&) {
        return false;
    }
}

namespace {

/// Visits the edges of every state that is reachable before time passes, until `enough` returns true. Returns false if
/// there are too many states.
template <class Enough>
bool look_before_time_passes(ModelGraph& graph, ModelState start, Enough enough) {
    std::unordered_set<ModelState> seen{start};
    std::vector<ModelState> open{start};
    while (!open.empty()) {
        if (seen.size() > most_in_search) return false;
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

/// Returns whether time can pass or the model can terminate after the state. If there are too many states, returns
/// false, and the model is then reported to stop time.
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

namespace {

/// Whether the search for heard inputs would visit too many states: it follows all readings of all registers. A model
/// with so many readings is evaluated on demand (cyclic_model.cpp), for a log that visits few states.
bool has_many_readings(const lts::TransitionSystem& model, const Interface& interface) {
    constexpr std::uint32_t most_readings = 64;
    return model.states_are_terms() && std::ranges::any_of(interface.inputs, [](const Register& input) {
               return input.reading_count() > most_readings;
           });
}

}  // namespace

const std::vector<bool>& ModelGraph::heard_inputs(ModelState state) {
    if (has_many_readings(*model_, alphabet_->interface())) return heard_[hears_all];
    if (state >= component_of_.size() || component_of_[state] == unknown) find_components(state);
    return heard_[component_of_[state]];
}

/// Finds strongly connected components of the graph without tocks (Tarjan), because all states of a component hear the
/// same registers. If there are too many states, or a state cannot be evaluated, the states that are still open are
/// assumed to hear all registers. This is safe: only the reduction of readings is lost.
void ModelGraph::find_components(ModelState start) {
    struct Visit {
        ModelState state = 0;
        std::size_t next = 0;  ///< edge
    };
    struct Numbers {
        std::size_t own = 0;
        std::size_t low = 0;
    };
    std::unordered_map<ModelState, Numbers> seen;  // never iterated
    std::vector<ModelState> open;
    std::vector<Visit> path;
    const auto known = [&](ModelState state) {
        return state < component_of_.size() && component_of_[state] != unknown;
    };
    const auto visit = [&](ModelState state) {
        seen[state] = {seen.size(), seen.size()};
        open.push_back(state);
        path.push_back({state});
    };
    visit(start);
    while (!path.empty()) {
        const ModelState state = path.back().state;
        const bool evaluated = is_evaluated(state);
        component_of_.resize(std::max(component_of_.size(), edges_.size()), unknown);
        if (!evaluated || seen.size() > most_in_search) {
            for (const ModelState open_state : open) component_of_[open_state] = hears_all;
            return;
        }
        const std::vector<ModelEdge>& all = edges(state);
        if (path.back().next == all.size()) {
            const Numbers numbers = seen.at(state);
            if (numbers.low == numbers.own) close_component(open, state);
            path.pop_back();
            if (path.empty()) continue;
            Numbers& before = seen.at(path.back().state);
            before.low = std::min(before.low, numbers.low);
            continue;
        }
        const ModelEdge& edge = all[path.back().next++];
        if (edge.role.kind == ModelRole::Kind::tock || known(edge.target)) continue;
        const auto met = seen.find(edge.target);
        if (met == seen.end()) {
            visit(edge.target);
        } else {
            Numbers& here = seen.at(state);
            here.low = std::min(here.low, met->second.own);
        }
    }
}

/// Closes a component: the last states of `open`, down to `first`.
void ModelGraph::close_component(std::vector<ModelState>& open, ModelState first) {
    const auto begin = std::find(open.rbegin(), open.rend(), first).base() - 1;
    const auto number = static_cast<std::uint32_t>(heard_.size());
    std::vector<bool> heard(alphabet_->interface().inputs.size());
    for (auto state = begin; state != open.end(); ++state) {
        for (const ModelEdge& edge : edges(*state)) {
            if (edge.role.kind == ModelRole::Kind::input) heard[edge.role.index] = true;
            if (edge.role.kind == ModelRole::Kind::tock || component_of_[edge.target] == unknown) continue;
            const std::vector<bool>& more = heard_[component_of_[edge.target]];
            for (std::size_t i = 0; i < heard.size(); ++i) heard[i] = heard[i] || more[i];
        }
    }
    for (auto state = begin; state != open.end(); ++state) component_of_[*state] = number;
    open.erase(begin, open.end());
    heard_.push_back(std::move(heard));
}

std::string ModelGraph::describe(ModelState state) const {
    return model_->describe(packed_state(state));
}

}  // namespace robochart::conformance
