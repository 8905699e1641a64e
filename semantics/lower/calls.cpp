// SPDX-License-Identifier: Apache-2.0
// Rejects operations that call themselves inside a controller, directly or through others. (RoboTool bounds recursion,
// semantics 3.8.)
#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/depth_first_search.hpp>

#include "semantics/ir/query.hpp"
#include "semantics/lower/components.hpp"
#include "semantics/rules.hpp"

namespace robochart::ir {
namespace {

/// The vertices are the definitions of a controller, in their order. The edges are calls.
using CallGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS>;
using Vertex = boost::graph_traits<CallGraph>::vertex_descriptor;
using Edge = boost::graph_traits<CallGraph>::edge_descriptor;

CallGraph call_graph(const System& system, const Controller& controller) {
    CallGraph graph(controller.definitions.size());
    for (Vertex caller = 0; caller < controller.definitions.size(); ++caller) {
        const Machine& machine = system.machine(controller.definitions[caller]);
        for (const auto operation : called_operations(machine)) {
            const MachineId callee = definition_in(system, controller, machine.operations[operation.index]);
            const auto at = std::ranges::find(controller.definitions, callee);
            if (at == controller.definitions.end()) continue;
            boost::add_edge(caller, static_cast<Vertex>(at - controller.definitions.begin()), graph);
        }
    }
    return graph;
}

/// Records the depth-first search tree and the back edges, that is, calls of an operation that is still active. Each
/// back edge closes a cycle.
class CycleFinder : public boost::default_dfs_visitor {
public:
    CycleFinder(std::vector<Vertex>& parents, std::vector<Edge>& closing) : parents_(parents), closing_(closing) {}
    void tree_edge(Edge edge, const CallGraph& graph) const { parents_[target(edge, graph)] = source(edge, graph); }
    void back_edge(Edge edge, const CallGraph& /*graph*/) const { closing_.push_back(edge); }

private:
    std::vector<Vertex>& parents_;
    std::vector<Edge>& closing_;
};

void report_cycle(Lowering& lowering, const Controller& controller, const std::vector<Vertex>& parents, Vertex first,
                  Vertex last) {
    const auto machine = [&](Vertex vertex) -> const Machine& {
        return lowering.system.machine(controller.definitions[vertex]);
    };
    std::string chain = machine(first).name;
    for (Vertex at = last; at != first; at = parents[at]) chain = machine(at).name + " calls " + chain;
    chain = machine(first).name + " calls " + chain;
    lowering.diagnostics.report(rules::recursive_operation, machine(first).origin.span, {machine(first).name, chain});
}

void check_recursion(Lowering& lowering, const Controller& controller) {
    const CallGraph graph = call_graph(lowering.system, controller);
    std::vector<Vertex> parents(boost::num_vertices(graph));
    std::vector<Edge> closing;
    boost::depth_first_search(graph, boost::visitor(CycleFinder(parents, closing)));
    for (const Edge& edge : closing)
        report_cycle(lowering, controller, parents, boost::target(edge, graph), boost::source(edge, graph));
}

}  // namespace

void check_calls(Lowering& lowering) {
    for (const auto& controller : lowering.system.controllers) check_recursion(lowering, controller);
    for (const SharedConstant& shared : shared_constants(lowering.system))
        if (!shared.is_one_constant())
            lowering.diagnostics.report(
                rules::ambiguous_constant, shared.operation->origin.span,
                {shared.operation->name, shared.constant, shared.controller->name, shared.source_names()});
}

}  // namespace robochart::ir
