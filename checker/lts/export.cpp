// Graphs as text for other tools.
#include <fmt/ostream.h>

#include <ostream>

#include "checker/lts/graph.hpp"

namespace robochart::lts {
namespace {

std::string label(const process::EventTable& events, Event event) {
    if (event == process::tau) return "tau";
    if (event == process::tick) return "tick";
    std::string text;
    for (char c : events.name(event)) {
        if (c == '"' || c == '\\') text += '\\';
        text += c;
    }
    return text;
}

}  // namespace

void write_aut(const Graph& graph, const process::EventTable& events, std::ostream& out) {
    fmt::print(out, "des (0,{},{})\n", graph.edge_count(), graph.size());
    for (StateIndex state = 0; state < graph.size(); ++state)
        for (const Edge& edge : graph.edges(state))
            fmt::print(out, "({},\"{}\",{})\n", state, label(events, edge.event), edge.target);
}

void write_dot(const Graph& graph, const process::EventTable& events, std::ostream& out) {
    fmt::print(out, "digraph lts {{\n  node [shape=circle];\n  start [shape=point];\n  start -> 0;\n");
    for (StateIndex state = 0; state < graph.size(); ++state) {
        fmt::print(out, "  {};\n", state);
        for (const Edge& edge : graph.edges(state))
            fmt::print(out, "  {} -> {} [label=\"{}\"];\n", state, edge.target, label(events, edge.event));
    }
    fmt::print(out, "}}\n");
}

}  // namespace robochart::lts
