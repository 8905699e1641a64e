// SPDX-License-Identifier: Apache-2.0
// Writes the nodes and transitions of random models. Every node has incoming and outgoing transitions as the rules
// require.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tests/random_models/models/behaviour.hpp"

namespace robochart::random_models {

std::string Behaviour::trigger() {
    std::vector<Port> inputs;
    for (const Port& port : around_.ports)
        if (port.receives || port.both_ways) inputs.push_back(port);
    if (inputs.empty()) return {};
    const Port port = random_.pick(inputs);
    const std::string accepted = filter(port, "from");
    if (port.type == nullptr) return port.name + accepted;
    const std::string variable = stored_variable(port);
    return variable.empty() ? "" : port.name + accepted + "?" + variable;
}

/// Returns a condition over variables, clocks and states of the container (TE4, TE5).
std::string Behaviour::condition(const Nodes& nodes) {
    const std::vector<std::string> orders = {"<", "<=", ">", ">=", "=="};
    if (!shape_.time || random_.chance(60)) return expressions_.expression_text(*types_.boolean());
    const std::string order = random_.pick(orders);
    if (!around_.clocks.empty() && random_.chance(70)) {
        const std::string clock = random_.pick(around_.clocks);
        return fmt::format("since({}) {} {}", clock, order, duration());
    }
    const bool qualified = shape_.qualified_names && !inside_.empty() && random_.chance(40);
    const std::string state = (qualified ? inside_ + "::" : "") + random_.pick(nodes.states);
    return fmt::format("sinceEntry({}) {} {}", state, order, duration());
}

std::string Behaviour::target(const Nodes& nodes) {
    if (!nodes.finals.empty() && random_.chance(15)) return random_.pick(nodes.finals);
    return random_.pick(nodes.states);
}

/// Returns guards for the outgoing transitions of a junction. One of them is true, unless the shape varies junctions.
std::vector<std::string> Behaviour::ways() {
    const std::string guard = expressions_.operand(*types_.boolean(), 4);
    const bool otherwise = shape_.else_conditions && random_.chance(50);
    const std::vector<std::string> plain = {guard, otherwise ? "else" : "not (" + guard + ")"};
    if (!shape_.varied_junctions || random_.chance(40)) return plain;
    const std::string second = expressions_.operand(*types_.boolean(), 4);
    switch (random_.below(4)) {
        case 0:
            return {guard, second, otherwise ? "else" : ""};
        case 1:
            return {guard, second};
        case 2:
            return {""};
        default:
            return {guard, ""};
    }
}

std::vector<std::string> Behaviour::chances() {
    if (!shape_.chance_expressions || random_.chance(30)) return {"0.25", "0.75"};
    if (!around_.chance.empty() && random_.chance(60)) return {around_.chance, "1 - " + around_.chance};
    return random_.chance(50) ? std::vector<std::string>{"1 / 4", "3 / 4"}
                              : std::vector<std::string>{"1 / 2", "0.25", "1 / 4"};
}

/// Plans junctions, which split one transition into several. A probabilistic junction splits it by probability.
void Behaviour::plan_junctions(Nodes& nodes) {
    const auto split = [&](const std::string& name, const std::vector<std::string>& ways, bool by_chance) {
        const bool chained = shape_.varied_junctions && !by_chance && nodes.junctions.size() > 1 && random_.chance(60);
        if (chained)
            nodes.steps.push_back({nodes.junctions[0], name, {}, {}, {}, {}, false});
        else
            nodes.steps.push_back({random_.pick(nodes.states), name, {}, {}, {}, {}, true});
        for (const std::string& way : ways) {
            Step out{name, target(nodes), {}, {}, {}, {}, false};
            (by_chance ? out.probability : out.condition) = way;
            nodes.steps.push_back(std::move(out));
        }
    };
    if (shape_.junctions && random_.chance(40)) {
        nodes.junctions.push_back(names_.local_name("j"));
        split(nodes.junctions.back(), ways(), false);
        if (shape_.varied_junctions && random_.chance(30)) {
            nodes.junctions.push_back(names_.local_name("j"));
            split(nodes.junctions.back(), ways(), false);
        }
        // The first state has a transition from the initial node, unless that transition goes through the junction.
        if (shape_.varied_junctions && random_.chance(25)) {
            nodes.steps[0].to = nodes.junctions[0];
            nodes.steps.push_back({nodes.junctions[0], nodes.states[0], {}, {}, {}, {}, false});
        }
    }
    if (shape_.probabilistic && random_.chance(shape_.chance_expressions ? 30 : 15)) {
        nodes.probabilistic.push_back(names_.local_name("pj"));
        split(nodes.probabilistic.back(), chances(), true);
    }
}

Behaviour::Nodes Behaviour::plan(bool must_end) {
    Nodes nodes;
    nodes.initial = names_.local_name("i");
    for (std::size_t i = random_.between(std::max<std::size_t>(1, shape_.states.low), shape_.states.high); i > 0; --i)
        nodes.states.push_back(names_.local_name("S"));
    if (must_end || (shape_.final_states && random_.chance(30))) nodes.finals.push_back(names_.local_name("F"));
    nodes.steps.push_back({nodes.initial, nodes.states[0], {}, {}, {}, {}, false});
    for (std::size_t i = 1; i < nodes.states.size(); ++i)
        nodes.steps.push_back({nodes.states[random_.below(i)], nodes.states[i], {}, {}, {}, {}, true});
    for (const std::string& end : nodes.finals)
        nodes.steps.push_back({random_.pick(nodes.states), end, {}, {}, {}, {}, true});
    for (std::size_t i = random_.between(shape_.transitions.low, shape_.transitions.high); i > 0; --i) {
        const std::string from = random_.pick(nodes.states);
        const std::string to = target(nodes);
        nodes.steps.push_back({from, to, {}, {}, {}, {}, true});
    }
    plan_junctions(nodes);
    return nodes;
}

void Behaviour::container(Lines& out, std::size_t depth, bool must_end) {
    const Nodes nodes = plan(must_end);
    out.line("initial " + nodes.initial);
    for (const std::string& name : nodes.states) state(out, name, depth);
    for (const std::string& name : nodes.junctions) out.line("junction " + name);
    for (const std::string& name : nodes.probabilistic) out.line("probabilistic " + name);
    for (const std::string& name : nodes.finals) out.line("final " + name);
    for (const Step& next : nodes.steps) step(out, nodes, next);
}

void Behaviour::state(Lines& out, const std::string& name, std::size_t depth) {
    const bool composite = shape_.composite_states && depth > 0 && random_.chance(shape_.composites);
    const bool entry = random_.chance(shape_.actions + 5);
    const bool during = shape_.during_actions && random_.chance(15);
    const bool exit = shape_.exit_actions && random_.chance(15);
    if (!shape_.paced && !composite && !entry && !during && !exit && random_.chance(70))
        return out.line("state " + name + " {}");
    out.open("state " + name);
    if (entry) out.line("entry " + action());
    if (shape_.paced && !entry) out.line("entry wait(1)");
    if (composite) {
        const std::string outer = std::exchange(inside_, name);
        container(out, depth - 1, false);
        inside_ = outer;
    }
    if (during) out.line("during " + action());
    if (exit) out.line("exit " + action());
    out.close();
}

/// Writes the clauses in the order of the grammar. If possible, an outgoing transition of a state waits for an event or
/// for time.
void Behaviour::step(Lines& out, const Nodes& nodes, const Step& step) {
    out.open("transition " + names_.local_name("t"));
    out.line("from " + step.from + " to " + step.to);
    const std::string event = step.triggered && random_.chance(85) ? trigger() : "";
    if (!event.empty()) out.line("trigger " + event);
    if (!step.probability.empty()) out.line("probability " + step.probability);
    if (shape_.time && step.triggered && !around_.clocks.empty() && random_.chance(20))
        out.line("#" + random_.pick(around_.clocks));
    if (shape_.time && !event.empty() && random_.chance(15)) out.line("<{ " + duration() + " }");
    if (!step.condition.empty()) out.line("condition " + step.condition);
    const bool guarded = step.condition.empty() && step.triggered && (event.empty() || random_.chance(30));
    if (guarded) out.line("condition " + condition(nodes));
    if (random_.chance(shape_.actions)) out.line("action " + action());
    out.close();
}

}  // namespace robochart::random_models
