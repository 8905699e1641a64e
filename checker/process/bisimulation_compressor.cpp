// SPDX-License-Identifier: Apache-2.0
// Converts machines of the semantics to graphs, minimises them, and converts them back.

#include "checker/process/bisimulation_compressor.hpp"

#include <cassert>

namespace robochart::process {

lts::Equivalence equivalence_of(Compression kind) {
    const bool strong =
        kind == Compression::sbisim || kind == Compression::explicate || kind == Compression::lazyenumerate;
    return strong ? lts::Equivalence::strong : lts::Equivalence::branching_with_divergence;
}

namespace {

lts::Graph graph_of(const Machine& machine) {
    assert(machine.edges.size() == machine.meaning.size());
    lts::Graph graph;
    for (const auto& edges : machine.edges) {
        for (const Machine::Edge& edge : edges) graph.add_edge({edge.event, edge.target});
        graph.finish_state();
    }
    return graph;
}

}  // namespace

Machine BisimulationCompressor::compress(const Machine& explored, Compression kind, diagnostics::Pollable& budget) {
    const lts::Quotient quotient = lts::minimise(graph_of(explored), equivalence_of(kind), budget);
    Machine result;
    for (lts::StateIndex state = 0; state < quotient.graph.size(); ++state) {
        result.meaning.push_back(explored.meaning[quotient.representative[state]]);
        std::vector<Machine::Edge>& edges = result.edges.emplace_back();
        for (const lts::Edge& edge : quotient.graph.edges(state)) edges.push_back({edge.event, edge.target});
    }
    return result;
}

}  // namespace robochart::process
