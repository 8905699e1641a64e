// SPDX-License-Identifier: Apache-2.0
// Exports graphs as text for other tools.
#include <fmt/ostream.h>

#include <ostream>
#include <string>
#include <unordered_set>

#include "base/diagnostics/escape.hpp"
#include "checker/lts/graph.hpp"

namespace robochart::lts {
namespace {

/// The labels for Aldebaran's format. Other tools read certain labels as a hidden step (mCRL2: `tau`, CADP: `i`), and
/// this export has a label for termination. If an event has one of these names, an underscore follows it.
class Labels {
public:
    explicit Labels(const EventTable& events) : events_(events) {
        for (Event event = tick + 1; event < events.size(); ++event) names_.insert(events.name(event));
    }
    [[nodiscard]] std::string label_of(Event event) const {
        if (event == tau) return "tau";
        if (event == tick) return "tick";
        std::string name = events_.name(event);
        if (name == "tau" || name == "i" || name == "tick") do
                name += '_';
            while (names_.contains(name));
        return diagnostics::label_text(name);
    }

private:
    const EventTable& events_;
    std::unordered_set<std::string> names_;
};

}  // namespace

void write_aut(const Graph& graph, const EventTable& events, std::ostream& out) {
    fmt::print(out, "des (0,{},{})\n", graph.edge_count(), graph.size());
    const Labels labels(events);
    for (StateIndex state = 0; state < graph.size(); ++state)
        for (const Edge& edge : graph.edges(state))
            fmt::print(out, "({},\"{}\",{})\n", state, labels.label_of(edge.event), edge.target);
}

namespace {

/// Returns an event as a CSPM expression. Negative fields get parentheses.
std::string expression(const std::string& event) {
    std::string text;
    for (std::size_t i = 0; i < event.size(); ++i) {
        text += event[i];
        if (event[i] != '.' || i + 1 >= event.size() || event[i + 1] != '-') continue;
        std::size_t end = i + 2;
        while (end < event.size() && event[end] >= '0' && event[end] <= '9') ++end;
        text += "(" + event.substr(i + 1, end - i - 1) + ")";
        i = end - 1;
    }
    return text;
}

/// Returns the CSPM text of what a state offers: STOP, SKIP, or a choice of prefixes.
std::string offer_text(std::span<const Edge> edges, const EventTable& events, const std::string& name) {
    std::string text;
    for (const Edge& edge : edges) {
        if (edge.event == tau) continue;
        if (!text.empty()) text += " [] ";
        if (edge.event == tick)
            text += "SKIP";
        else
            text += fmt::format("{} -> {}{}", expression(events.name(edge.event)), name, edge.target);
    }
    return text.empty() ? "STOP" : text;
}

}  // namespace

void write_csp(const Graph& graph, const EventTable& events, const std::string& name, std::ostream& out) {
    fmt::print(out, "{0} = {0}0\n", name);
    for (StateIndex state = 0; state < graph.size(); ++state) {
        const std::string visible = offer_text(graph.edges(state), events, name);
        std::string hidden;
        std::size_t taus = 0;
        for (const Edge& edge : graph.edges(state)) {
            if (edge.event != tau) continue;
            hidden += fmt::format("{}{}{}", taus++ > 0 ? " |~| " : "", name, edge.target);
        }
        fmt::print(out, "{}{} = ", name, state);
        if (taus == 0)
            fmt::print(out, "{}\n", visible);
        else if (taus > 1 && visible == "STOP")
            fmt::print(out, "{}\n", hidden);
        else
            fmt::print(out, "({}) [> ({})\n", visible, hidden);
    }
}

void write_dot(const Graph& graph, const EventTable& events, std::ostream& out) {
    fmt::print(out, "digraph lts {{\n  node [shape=circle];\n  start [shape=point];\n  start -> 0;\n");
    const Labels labels(events);
    for (StateIndex state = 0; state < graph.size(); ++state) {
        fmt::print(out, "  {};\n", state);
        for (const Edge& edge : graph.edges(state))
            fmt::print(out, "  {} -> {} [label=\"{}\"];\n", state, edge.target, labels.label_of(edge.event));
    }
    fmt::print(out, "}}\n");
}

}  // namespace robochart::lts
