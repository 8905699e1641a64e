// Tarjan (1972) without recursion: components are finished, and numbered, after those that their taus lead to.
#include "checker/lts/tau_components.hpp"

#include <algorithm>

namespace robochart::lts {
namespace {

class Tarjan {
public:
    explicit Tarjan(const Graph& graph)
        : graph_(graph), number_(graph.size(), 0), low_(graph.size(), 0), next_edge_(graph.size(), 0) {
        result_.component.assign(graph.size(), no_state);
    }
    TauComponents run() {
        for (StateIndex root = 0; root < graph_.size(); ++root)
            if (number_[root] == 0) explore(root);
        return std::move(result_);
    }

private:
    void explore(StateIndex root) {
        enter(root);
        while (!path_.empty()) {
            const StateIndex state = path_.back();
            const std::span<const Edge> edges = graph_.edges(state);
            if (next_edge_[state] == edges.size()) {
                leave(state);
                continue;
            }
            const Edge& edge = edges[next_edge_[state]++];
            if (edge.event != tau) continue;
            if (number_[edge.target] == 0)
                enter(edge.target);
            else if (result_.component[edge.target] == no_state)
                low_[state] = std::min(low_[state], number_[edge.target]);
        }
    }
    void enter(StateIndex state) {
        number_[state] = low_[state] = ++count_;
        path_.push_back(state);
        open_.push_back(state);
    }
    void leave(StateIndex state) {
        path_.pop_back();
        if (!path_.empty()) low_[path_.back()] = std::min(low_[path_.back()], low_[state]);
        if (low_[state] != number_[state]) return;
        const auto component = static_cast<StateIndex>(result_.cyclic.size());
        result_.cyclic.push_back(open_.back() != state || loops(state));
        for (StateIndex member = no_state; member != state;) {
            member = open_.back();
            open_.pop_back();
            result_.component[member] = component;
        }
    }
    bool loops(StateIndex state) const {
        const std::span<const Edge> edges = graph_.edges(state);
        return std::find(edges.begin(), edges.end(), Edge{tau, state}) != edges.end();
    }

    const Graph& graph_;
    TauComponents result_;
    std::vector<std::uint32_t> number_;
    std::vector<std::uint32_t> low_;
    std::vector<std::size_t> next_edge_;
    std::vector<StateIndex> path_;
    std::vector<StateIndex> open_;
    std::uint32_t count_ = 0;
};

}  // namespace

TauComponents tau_components(const Graph& graph) {
    return Tarjan(graph).run();
}

TauComponents every_state_alone(const Graph& graph) {
    TauComponents result{{}, std::vector<bool>(graph.size(), false)};
    for (StateIndex state = 0; state < graph.size(); ++state) result.component.push_back(state);
    return result;
}

Graph contract(const Graph& graph, const TauComponents& components) {
    std::vector<std::vector<StateIndex>> members(components.cyclic.size());
    for (StateIndex state = 0; state < graph.size(); ++state) members[components.component[state]].push_back(state);
    Graph result;
    for (StateIndex component = 0; component < members.size(); ++component) {
        std::vector<Edge> edges;
        if (components.cyclic[component]) edges.push_back({tau, component});
        for (StateIndex state : members[component])
            for (const Edge& edge : graph.edges(state)) {
                const StateIndex target = components.component[edge.target];
                if (edge.event != tau || target != component) edges.push_back({edge.event, target});
            }
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        for (const Edge& edge : edges) result.add_edge(edge);
        result.finish_state();
    }
    return result;
}

}  // namespace robochart::lts
