// Machines of the semantics as graphs, minimised, and back.
#include "checker/lts/compressor.hpp"

#include "checker/lts/bisimulation.hpp"

namespace robochart::lts {
namespace {

Equivalence equivalence_of(process::Compression kind) {
    using process::Compression;
    const bool strong =
        kind == Compression::sbisim || kind == Compression::explicate || kind == Compression::lazyenumerate;
    return strong ? Equivalence::strong : Equivalence::branching_with_divergence;
}

Graph graph_of(const process::Machine& machine) {
    Graph graph;
    for (const auto& edges : machine.edges) {
        for (const process::Machine::Edge& edge : edges) graph.add_edge({edge.event, edge.target});
        graph.finish_state();
    }
    return graph;
}

}  // namespace

process::Machine BisimulationCompressor::compress(const process::Machine& explored, process::Compression kind,
                                                  const std::function<void()>& poll) {
    const Quotient quotient = minimise(graph_of(explored), equivalence_of(kind), poll);
    process::Machine result;
    for (StateIndex state = 0; state < quotient.graph.size(); ++state) {
        result.meaning.push_back(explored.meaning[quotient.representative[state]]);
        std::vector<process::Machine::Edge>& edges = result.edges.emplace_back();
        for (const Edge& edge : quotient.graph.edges(state)) edges.push_back({edge.event, edge.target});
    }
    return result;
}

}  // namespace robochart::lts
